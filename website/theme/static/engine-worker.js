// Python and the engine, which answer one call after another
const tell = (kind, content) => postMessage([kind, content]);
let answer;
const engine = new Promise((resolve) => (answer = resolve));

const allowed = new Set(); // packages from elsewhere that the reader has asked for

onmessage = async ({ data: { root, allow, id, name, text } }) => {
  if (allow) allowed.add(allow);
  else if (root) {
    answer(load(new URL("engine/", root)));
    engine.then(() => tell("ready"), (error) => tell("failed", error.message));
  } else {
    try {
      const { call, get, packages } = await engine;
      let found = call(name, text), failed;
      // a cell has used a package that is loaded later
      const come = (needed) => get(needed).catch(({ message }) => void (failed = message));
      while (found.startsWith('{"needs"') && (await come(JSON.parse(found).needs))) found = call(name, text);
      tell("answer", { id, text: found, packages, failed });
    } catch (error) { // Python itself has ended
      tell("ended", String(error.message).split("\n")[0]);
    }
  }
};

async function load(folder) {
  const about = await (await fetch(new URL("engine.json", folder), { cache: "no-cache" })).json();
  countBytes(about.bytes);
  const bytes = async (file) => (await fetch(new URL(file, folder))).arrayBuffer();
  const archive = bytes(about.package);
  const home = new URL(about.python, folder).href;
  const { loadPyodide } = await import(`${home}pyodide.mjs`);
  const packages = about.packages && new URL(about.packages, folder).href;
  const python = await loadPyodide({ indexURL: home, packageBaseUrl: packages || home });
  python.unpackArchive(await archive, "zip");
  const got = new Set();
  // whether a package has come; an error says why it could not
  const get = async (name) => {
    const here = about.later[name];
    if (got.has(name) || !(here || allowed.has(name))) return false;
    for (const archive of await Promise.all((here || []).map(bytes))) python.unpackArchive(archive, "zip");
    if (!here) await fetched(name);
    got.add(name);
    return true;
  };
  const fetched = async (name) => {
    const errors = [];
    const found = await python.loadPackage(name, { messageCallback: () => {}, errorCallback: (words) => errors.push(words) });
    if (!found.some((one) => one.name === name)) throw new Error(errors.at(-1));
  };
  return { get, packages, call: python.runPython("from website.browser import answer; answer") };
}

// every fetch from now on reports how much of the whole has arrived
function countBytes(all) {
  const plain = fetch;
  let received = 0;
  self.fetch = async (...request) => {
    const response = await plain(...request);
    if (!response.ok) throw new Error(`${response.status} for ${response.url}`);
    const counter = new TransformStream({
      transform(chunk, out) {
        received += chunk.length;
        if (received < all) tell("progress", received / all);
        out.enqueue(chunk);
      },
    });
    return new Response(response.body.pipeThrough(counter), response);
  };
}
