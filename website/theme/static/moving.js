// figures with sliders: the engine draws them anew while a slider is dragged; until it is loaded,
// the pictures at the start and at the ends answer
const moving = (() => {
  const root = window.engine && engine.root;
  const sources = () =>
    [...document.querySelectorAll(".cell_input pre")].map((code) => code.textContent.replace(/\n$/, ""));
  const numberOf = (element) =>
    [...document.querySelectorAll(".cell_input")].findIndex((input) => input.closest(".cell") === element.closest(".cell"));

  let loaded = false;
  if (root) engine.progress((part) => (loaded = part === 1));

  const decimals = (x) => (String(x).split(".")[1] || "").length;
  const words = (slider, x) => {
    const digits = Math.min(6, Math.max(decimals(slider.start), decimals(slider.step)));
    const space = /^[°%]?$/.test(slider.unit[0] || "") ? "" : "\u00a0";
    return x.toFixed(digits).replace("-", "\u2212") + space + slider.unit;
  };

  const node = (tag, attributes = {}, ...inside) => {
    const made = Object.assign(document.createElement(tag), attributes);
    made.append(...inside);
    return made;
  };

  // makes an element with a picture, and what is said of it, a figure with sliders
  function figure(holder, { sliders, ends, number }) {
    const values = Object.fromEntries(sliders.map((slider) => [slider.name, slider.start]));
    const picture = holder.firstElementChild;
    const first = picture.outerHTML;
    const said = node("p", { className: "said" });
    said.setAttribute("role", "status");
    const note = node("p", { className: "note" });
    let asked = 0, busy = false;

    const show = ({ svg, alt }) => {
      stage.innerHTML = svg;
      const drawn = stage.firstElementChild;
      drawn.setAttribute("role", "img");
      drawn.setAttribute("aria-label", alt);
    };
    // one picture at a time, and then the newest
    const draw = async () => {
      asked += 1;
      if (busy) return;
      busy = true;
      for (let done = 0; done !== asked; ) {
        done = asked;
        try {
          const page = location.pathname, cells = sources(), cell = numberOf(holder);
          show(await engine.call("cells.picture", { page, cells, number: cell, figure: number, values: { ...values } }));
          note.textContent = "";
        } catch (error) {
          note.textContent = `No picture: ${error.message}`;
        }
      }
      busy = false;
    };
    // the nearest of the start and the ends
    const nearest = async ({ name, start, low, high }) => {
      const x = values[name], [from, to] = ends[name];
      const [, end] = [[Math.abs(x - start), null], [x - low, from], [high - x, to]].sort((a, b) => a[0] - b[0])[0];
      if (!end) return (stage.innerHTML = first);
      const svg = await (await fetch(new URL(`moving/${end.file}`, root))).text();
      if (!loaded) show({ svg, alt: end.alt });
    };

    const rows = sliders.map((slider) => {
      const input = node("input", { type: "range", min: slider.low, max: slider.high, step: slider.step });
      const shown = node("span", { className: "value" });
      const text = () => {
        shown.textContent = words(slider, values[slider.name]);
        input.setAttribute("aria-valuetext", shown.textContent);
      };
      input.value = slider.start;
      input.addEventListener("input", () => {
        values[slider.name] = +input.value;
        text();
        if (!loaded && ends) nearest(slider);
        draw();
      });
      input.addEventListener("change", () => {
        said.textContent = sliders.map((s) => `${s.label} = ${words(s, values[s.name])}`).join(", ");
      });
      text();
      return node("label", {}, node("span", {}, `${slider.label} =`), shown, input);
    });
    const stage = node("div", { className: "stage" }, picture);
    holder.append(stage, node("div", { className: "sliders" }, ...rows), note, said);
    engine.progress((part) => {
      note.textContent = 0 < part && part < 1 ? `The engine is loaded: ${Math.round(100 * part)} %` : "";
    });
  }

  if (root)
    for (const holder of document.querySelectorAll("[data-moving]"))
      figure(holder, JSON.parse(holder.dataset.moving));
  return { figure, sources, numberOf, node };
})();
