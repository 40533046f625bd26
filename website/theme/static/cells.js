// the cells of a chapter can be edited and run, after what they need of those above
if (window.engine) {
  const { node } = moving;
  const chapter = document.querySelector("article");
  const formula = (text) =>
    text.replace(/^\$\$([^]*)\$\$$/, "\\[$1\\]").replace(/^\$([^]*)\$$/, "\\($1\\)").replace(/^\\begin[^]*$/, "\\[$&\\]");

  const makers = {
    "text/plain": (text) => node("div", { className: "output stream highlight" }, node("pre", { textContent: text })),
    "text/html": (html) => scripted(node("div", { className: "output text_html", innerHTML: html })),
    "image/svg+xml": (svg) => node("div", { className: "output", innerHTML: svg }),
    "image/png": (data) => node("div", { className: "output" }, node("img", { src: `data:image/png;base64,${data}`, alt: gettext("What the cell has drawn") })),
    "text/latex": (text) => node("div", { className: "output math", textContent: formula(text) }),
    "text/markdown": (text) => node("div", { className: "output mathjax_process", textContent: text }),
    figure: (about) => {
      const holder = node("div", { className: "output moving", innerHTML: about.svg });
      holder.firstElementChild.setAttribute("aria-label", about.alt);
      queueMicrotask(() => moving.figure(holder, about));
      return holder;
    },
  };
  // scripts inserted as text do not run until they are created again
  const scripted = (element) => {
    for (const old of element.querySelectorAll("script")) old.replaceWith(node("script", { textContent: old.textContent }));
    return element;
  };

  const prepare = (input) => {
    const cell = input.closest(".cell"), code = input.querySelector("pre");
    const run = node("button", { type: "button", textContent: gettext("Run") });
    const edit = node("button", { type: "button", textContent: gettext("Edit") });
    const note = node("span", { className: "note" });
    note.setAttribute("role", "status");
    let running = false;

    const start = async () => {
      running = true;
      run.textContent = gettext("Stop");
      note.textContent = gettext("runs …");
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
      const button = node("button", { type: "button", textContent: gettext("Fetch {needs} from {host}", { needs, host: new URL(packages).host }) });
      button.addEventListener("click", () => (engine.allow(needs), start()));
      cell.querySelector(".cell_output").append(button);
    };
    const show = (shown, error) => {
      let output = cell.querySelector(".cell_output");
      if (!output) cell.append((output = node("div", { className: "cell_output docutils container" })));
      output.replaceChildren();
      shown.filter(([kind]) => kind === "figure").forEach(([, about], n) => (about.number = n));
      output.append(...shown.map(([kind, content]) => makers[kind](content)));
      if (error) output.append(node("div", { className: "output error" }, node("pre", { textContent: error })));
      if (output.querySelector(".math, .mathjax_process, .text_html")) engine.typeset(output);
    };

    run.addEventListener("click", () => (running ? engine.stop() : start()));
    edit.addEventListener("click", () => {
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
    input.append(node("div", { className: "run" }, run, edit, note));
    input.dataset.engine = "";
  };

  for (const input of chapter?.querySelectorAll(".cell_input") ?? []) prepare(input);
}
