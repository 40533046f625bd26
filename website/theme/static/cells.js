// the cells of a chapter can be edited and run, after what they need of those above
if (window.engine) {
  const { el, button } = engine;
  const chapter = document.querySelector("article");
  const formula = (text) =>
    text.replace(/^\$\$([^]*)\$\$$/, "\\[$1\\]").replace(/^\$([^]*)\$$/, "\\($1\\)").replace(/^\\begin[^]*$/, "\\[$&\\]");

  const output = (more, ...inside) => el("div", { class: `output ${more}` }, ...inside);
  const ofHtml = (more, html) => Object.assign(output(more), { innerHTML: html });
  const makers = {
    "text/plain": (text) => output("stream highlight", el("pre", {}, text)),
    "text/html": (html) => scripted(ofHtml("text_html", html)),
    "image/svg+xml": (svg) => ofHtml("", svg),
    "image/png": (data) => output("", el("img", { src: `data:image/png;base64,${data}`, alt: gettext("What the cell drew") })),
    "text/latex": (text) => output("math", formula(text)),
    "text/markdown": (text) => output("mathjax_process", text),
    figure: (about) => {
      const holder = ofHtml("moving", about.svg);
      holder.firstElementChild.setAttribute("aria-label", about.alt);
      queueMicrotask(() => moving.figure(holder, about));
      return holder;
    },
  };
  // scripts inserted as text do not run until they are created again
  const scripted = (element) => {
    for (const old of element.querySelectorAll("script")) old.replaceWith(el("script", {}, old.textContent));
    return element;
  };

  const prepare = (input) => {
    const cell = input.closest(".cell"), code = input.querySelector("pre");
    const note = el("span", { class: "note", role: "status" });
    let running = false;

    const start = async () => {
      running = true;
      run.textContent = gettext("Stop");
      note.textContent = gettext("running …");
      cell.setAttribute("aria-busy", "true");
      const began = performance.now();
      try {
        const page = location.pathname, cells = moving.sources(), number = moving.numberOf(input);
        const { shown, error } = await engine.call("cells.run", { page, cells, number });
        show(shown, error);
        note.textContent = gettext("ran in this page, {seconds} s", { seconds: ((performance.now() - began) / 1000).toFixed(1) });
      } catch (error) {
        show([], error.message);
        note.textContent = "";
        if (error.needs && error.packages) offer(error);
      }
      running = false;
      run.textContent = gettext("Run");
      cell.removeAttribute("aria-busy");
    };
    // a package is fetched from elsewhere only if the reader asks for it
    const offer = ({ needs, packages }) => {
      const text = gettext("Fetch {needs} from {host}", { needs, host: new URL(packages).host });
      cell.querySelector(".cell_output").append(button(text, () => (engine.allow(needs), start())));
    };
    const show = (shown, error) => {
      let place = cell.querySelector(".cell_output");
      if (!place) cell.append((place = el("div", { class: "cell_output docutils container" })));
      shown.filter(([kind]) => kind === "figure").forEach(([, about], n) => (about.number = n));
      place.replaceChildren(...shown.map(([kind, content]) => makers[kind](content)));
      if (error) place.append(output("error", el("pre", {}, error)));
      if (place.querySelector(".math, .mathjax_process, .text_html")) engine.typeset(place);
    };

    const run = button(gettext("Run"), () => (running ? engine.stop() : start()));
    const edit = button(gettext("Edit"), () => {
      code.contentEditable = "plaintext-only";
      code.setAttribute("role", "textbox");
      code.setAttribute("aria-multiline", "true");
      code.setAttribute("aria-label", gettext("Code of this cell"));
      code.focus();
    });
    code.addEventListener("keydown", (event) => {
      if (event.key === "Enter" && event.shiftKey && code.isContentEditable) {
        event.preventDefault();
        if (!running) start();
      }
    });
    input.append(el("div", { class: "run" }, run, edit, note));
    input.dataset.engine = "";
  };

  for (const input of chapter?.querySelectorAll(".cell_input") ?? []) prepare(input);
}
