// a service worker, which keeps what a reader has seen: pages are fetched first, so that new ones
// are shown; files of the engine have names that change with their contents, and are kept for good
const KEPT = "newton-euler";
const LASTING = /\/engine\/(\w+)-[^/]+/;

addEventListener("install", () => skipWaiting());
addEventListener("activate", (event) => event.waitUntil(clients.claim()));
addEventListener("fetch", (event) => {
  const { request } = event;
  if (request.method !== "GET" || !request.url.startsWith(registration.scope)) return;
  event.respondWith(LASTING.test(request.url) ? keptFirst(event) : fetchedFirst(event));
});

// storage may be full or blocked: then nothing is kept
const kept = (request) => caches.match(request, { ignoreSearch: true }).catch(() => undefined);
const keptFirst = async (event) => (await kept(event.request)) || fetched(event);
const fetchedFirst = (event) =>
  fetched(event).catch(async (error) => (await kept(event.request)) || Promise.reject(error));

// the browser may end a worker as soon as it has answered, unless it knows what is still going on
async function fetched(event) {
  const response = await fetch(event.request);
  if (response.status === 200) event.waitUntil(keep(event.request, response.clone()).catch(() => {}));
  return response;
}

async function keep(request, copy) {
  const store = await caches.open(KEPT), found = LASTING.exec(request.url);
  // of a file of the engine any other version is forgotten
  for (const { url } of found ? await store.keys() : []) {
    const other = LASTING.exec(url);
    if (other && other[1] === found[1] && other[0] !== found[0]) store.delete(url);
  }
  await store.put(request, copy);
}
