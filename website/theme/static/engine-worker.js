// Python and the engine, which answer one call after the other
const tell = (kind, content) => postMessage([kind, content]);
let answer;
const engine = new Promise((resolve) => (answer = resolve));

const allowed = new Set(); // packages that the reader has asked for, from another address

onmessage = async ({ data: { root, allow, id, name, text } }) => {
  if (allow) allowed.add(allow);
  else if (root) {
    answer(load(new URL("engine/", root)));
    engine.then(() => tell("ready"), (error) => tell("failed", `The engine cannot be loaded: ${error.message}`));
  } else {
    const { call, get, packages } = await engine;
    let found = call(name, text);
    // a cell has used a package that comes later
    while (found.startsWith('{"needs"') && (await get(JSON.parse(found).needs))) found = call(name, text);
    tell("answer", { id, text: found, packages });
  }
};

async function load(folder) {
  const about = await (await fetch(new URL("engine.json", folder))).json();
  countBytes(about.bytes);
  const bytes = async (file) => (await fetch(new URL(file, folder))).arrayBuffer();
  const archive = bytes(about.package);
  const home = new URL(about.python, folder).href;
  const { loadPyodide } = await import(`${home}pyodide.mjs`);
  const packages = about.packages && new URL(about.packages, folder).href;
  const python = await loadPyodide({ indexURL: home, packageBaseUrl: packages || home });
  python.unpackArchive(await archive, "zip");
  const got = new Set();
  const get = async (name) => {
    const here = about.later[name];
    if (got.has(name) || !(here || allowed.has(name))) return false;
    got.add(name);
    if (!here) await python.loadPackage(name);
    for (const file of here || []) python.unpackArchive(await bytes(file), "zip");
    return true;
  };
  return { get, packages, call: python.runPython("from newton_euler.browser import answer; answer") };
}

// every fetch from now on tells how much of all has come
function countBytes(all) {
  const plain = fetch;
  let come = 0;
  self.fetch = async (...request) => {
    const response = await plain(...request);
    if (!response.ok) throw new Error(`${response.status} for ${response.url}`);
    const counter = new TransformStream({
      transform(chunk, out) {
        come += chunk.length;
        if (come < all) tell("progress", come / all);
        out.enqueue(chunk);
      },
    });
    return new Response(response.body.pipeThrough(counter), response);
  };
}
