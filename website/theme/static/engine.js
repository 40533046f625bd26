// engine.call("module.function", {arguments}) asks newton_euler/browser/module.py, in a worker that
// is started by the first call, or by a touch of anything within [data-engine]; pages that were
// opened as files have no window.engine
(() => {
  if (location.protocol === "file:" || !window.Worker || !window.WebAssembly) return;
  const root = new URL("../", document.currentScript.src);
  const asked = new Map(), watching = new Set();
  let worker, number = 0, loaded = 0, settle;
  const ready = new Promise((resolve, reject) => (settle = { resolve, reject }));
  ready.catch(() => {}); // each call says it

  const progress = (part) => {
    loaded = part;
    for (const callback of watching) callback(part);
  };
  const heard = {
    progress,
    ready: () => (progress(1), settle.resolve()),
    failed: (words) => {
      settle.reject(new Error(words));
      for (const { reject } of asked.values()) reject(new Error(words));
      asked.clear();
    },
    answer: ({ id, text, packages }) => {
      const { value, error, needs } = JSON.parse(text), { resolve, reject } = asked.get(id);
      asked.delete(id);
      error === undefined ? resolve(value) : reject(Object.assign(new Error(error), { needs, packages }));
    },
  };

  const start = () => {
    if (worker) return;
    worker = new Worker(new URL("_static/engine-worker.js", root), { type: "module" });
    worker.onmessage = ({ data: [kind, content] }) => heard[kind](content);
    worker.onerror = (event) => heard.failed(event.message || "the engine cannot be started");
    kept().then(() => worker.postMessage({ root: root.href }));
  };

  // from now on the pages, and the engine, come back without a network
  const kept = async () => {
    const container = navigator.serviceWorker;
    if (!container || container.controller) return;
    const taken = new Promise((resolve) => container.addEventListener("controllerchange", resolve));
    const late = new Promise((resolve) => setTimeout(resolve, 2000));
    await container.register(new URL("offline.js", root)).catch(() => {});
    await Promise.race([taken, late]);
    const seen = performance.getEntriesByType("resource").map((entry) => entry.name);
    for (const url of new Set([location.href, ...seen]))
      if (url.startsWith(root.href)) fetch(url).catch(() => {});
  };

  // ends what runs; the next call starts anew, with nothing of what was computed
  const stop = () => {
    worker?.terminate();
    worker = undefined;
    progress(0);
    for (const { reject } of asked.values()) reject(new Error("stopped; cells that were run are forgotten"));
    asked.clear();
  };

  const call = (name, args = {}) =>
    new Promise((resolve, reject) => {
      start();
      asked.set(++number, { resolve, reject });
      worker.postMessage({ id: number, name, text: JSON.stringify(args) });
    });

  for (const kind of ["pointerover", "pointerdown", "focusin"])
    addEventListener(kind, (event) => event.target.closest?.("[data-engine]") && start());

  window.engine = {
    call,
    ready,
    start,
    stop,
    root,
    // lets a package be fetched from the address that an error has named
    allow: (name) => worker.postMessage({ allow: name }),
    // called with the part that is loaded, 0 to 1, now and whenever it grows
    progress: (callback) => (watching.add(callback), callback(loaded)),
  };
})();
