// Python and the engine, which answer one call after the other
const tell = (kind, content) => postMessage([kind, content]);
let answer;
const engine = new Promise((resolve) => (answer = resolve));

onmessage = async ({ data: { root, id, name, text } }) => {
  if (root) {
    answer(load(new URL("engine/", root)));
    engine.then(() => tell("ready"), (error) => tell("failed", `The engine cannot be loaded: ${error.message}`));
  } else {
    const call = await engine;
    tell("answer", { id, text: call(name, text) });
  }
};

async function load(folder) {
  const about = await (await fetch(new URL("engine.json", folder))).json();
  countBytes(about.bytes);
  const archive = fetch(new URL(about.package, folder)).then((response) => response.arrayBuffer());
  const home = new URL(about.python, folder).href;
  const { loadPyodide } = await import(`${home}pyodide.mjs`);
  const python = await loadPyodide({ indexURL: home });
  python.unpackArchive(await archive, "zip");
  return python.runPython("from newton_euler.browser import answer; answer");
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
        tell("progress", Math.min(0.99, (come += chunk.length) / all));
        out.enqueue(chunk);
      },
    });
    return new Response(response.body.pipeThrough(counter), response);
  };
}
