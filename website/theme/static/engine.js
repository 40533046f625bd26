// engine.call("module.function", {arguments}) asks website/browser/module.py, in a worker that
// is started by the first call, or by a touch of anything within [data-engine]; pages that were
// opened as files have no window.engine
(() => {
  if (location.protocol === "file:" || !window.Worker || !window.WebAssembly) return;
  const root = new URL("../", document.currentScript.src);
  const asked = new Map(), watching = new Set();
  let worker, number = 0, loaded = 0, ends = 0;

  const progress = (part) => {
    loaded = part;
    for (const callback of watching) callback(part);
  };
  const handlers = {
    progress,
    ready: () => progress(1),
    ended: (why) => end(gettext("The engine stopped and is started again by the next call: {error}", { error: why })),
    failed: (why) => end(gettext("The engine cannot be loaded: {error}", { error: why })),
    answer: ({ id, text, packages, failed }) => {
      const { value, error, needs } = JSON.parse(text), { resolve, reject } = asked.get(id);
      asked.delete(id);
      if (error === undefined) return resolve(value);
      const words = failed ? gettext("{needs} cannot be fetched: {error}", { needs, error: failed }) : error;
      reject(Object.assign(new Error(words), { needs, packages }));
    },
  };

  const start = () => {
    if (worker) return;
    worker = new Worker(new URL("_static/engine-worker.js", root), { type: "module" });
    worker.onmessage = ({ data: [kind, content] }) => handlers[kind](content);
    worker.onerror = (event) => handlers.failed(event.message || "worker");
    const mine = worker;
    kept().then(() => mine.postMessage({ root: root.href }));
  };

  // from now on the pages, and the engine, come back without a network
  const kept = async () => {
    const container = navigator.serviceWorker;
    if (!container || container.controller) return;
    const taken = new Promise((resolve) => container.addEventListener("controllerchange", resolve));
    const late = new Promise((resolve) => setTimeout(resolve, 10000));
    if (!(await container.register(new URL("offline.js", root)).catch(() => {}))) return;
    await Promise.race([taken, late]);
    const seen = performance.getEntriesByType("resource").map((entry) => entry.name);
    for (const url of new Set([location.href, ...seen]))
      if (url.startsWith(root.href)) fetch(url).catch(() => {});
  };

  // ends what runs; the next call starts afresh, with nothing of what was computed
  const end = (words) => {
    worker?.terminate();
    worker = undefined;
    ends += 1;
    progress(0);
    for (const { reject } of asked.values()) reject(new Error(words));
    asked.clear();
  };
  const stop = () => end(gettext("stopped; the cells run so far are forgotten"));

  // an element with attributes, listeners ("onclick") and contents
  const el = (tag, attributes = {}, ...inside) => {
    const made = document.createElement(tag);
    for (const [name, value] of Object.entries(attributes))
      if (name.startsWith("on")) made.addEventListener(name.slice(2), value);
      else if (value !== undefined && value !== false) made.setAttribute(name, value === true ? "" : value);
    made.append(...inside);
    return made;
  };
  const button = (text, onclick, more = {}) => el("button", { type: "button", onclick, ...more }, text);

  // draws the formulas added to an element; those of the page as built are drawn already
  const typeset = async (element) => {
    if (!window.MathJax) {
      window.MathJax = {
        options: { enableMenu: false, processHtmlClass: "mathjax_process|math" },
        // texts may come from anywhere: no formula is a link, has a style, or runs anything
        svg: { scale: 0.93 },
        tex: { tags: "none", packages: { "[-]": ["html", "action", "unicode", "require", "bbox"] }, macros: { mmlToken: "?" } },
        startup: { typeset: false },
      };
      document.head.append(el("script", { src: new URL("_static/tex-svg-full.js", root) }));
    }
    while (!MathJax.startup?.promise) await new Promise((done) => setTimeout(done, 50));
    await MathJax.startup.promise;
    await MathJax.typesetPromise([element]);
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
    call, stop, typeset, el, button,
    // how often the engine has ended: the next one does not know what the last one was given
    get ends() { return ends; },
    root,
    // lets a package be fetched from the address that an error has named
    allow: (name) => (start(), worker.postMessage({ allow: name })),
    // called with the fraction loaded, 0 to 1, now and whenever it grows
    progress: (callback) => (watching.add(callback), callback(loaded)),
  };
})();
