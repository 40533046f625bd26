// figures with sliders: the engine redraws them while a slider is dragged; until it is loaded, and
// where it cannot draw them, the nearest of the pictures built with the page is shown
const moving = (() => {
  const root = window.engine && engine.root;
  const codes = () => [...document.querySelectorAll(".cell_input pre, .cell pre.source")];
  const sources = () => codes().map((code) => code.textContent.replace(/\n$/, ""));
  const numberOf = (element) => codes().findIndex((code) => code.closest(".cell") === element.closest(".cell"));

  const decimals = (x) => (String(x).split(".")[1] || "").length;
  const words = (slider, x) => {
    const digits = Math.min(6, Math.max(decimals(slider.start), decimals(slider.step)));
    const space = /^[°%]?$/.test(slider.unit[0] || "") ? "" : "\u00a0";
    return x.toFixed(digits).replace("-", "\u2212") + space + slider.unit;
  };

  // turns an element with a picture and its description into a figure with sliders
  function figure(holder, { sliders, along, number }) {
    const values = Object.fromEntries(sliders.map((slider) => [slider.name, slider.start]));
    const { el } = engine, picture = holder.firstElementChild, first = picture.outerHTML;
    const reply = el("p", { class: "reply", role: "status" }), note = el("p", { class: "note" });
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
          const given = { ...values };
          show(await engine.call("cells.picture", { page, cells, number: cell, figure: number, values: given }));
          holder.dataset.drawn = JSON.stringify(given);
          note.textContent = "";
        } catch (error) {
          holder.dataset.failed = error.message;
          note.textContent = gettext("The nearest picture is shown: {error}", { error: error.message });
        }
      }
      busy = false;
    };
    const nearest = async ({ name, start }) => {
      const off = ({ at }) => Math.abs(values[name] - at);
      const [best] = [{ at: start }, ...along[name]].sort((a, b) => off(a) - off(b));
      if (!best.file) return (stage.innerHTML = first);
      const svg = await (await fetch(new URL(`moving/${best.file}`, root))).text();
      if (!holder.dataset.drawn) show({ svg, alt: best.alt });
    };

    const rows = sliders.map((slider) => {
      const { name, label, start: value, low: min, high: max, step } = slider;
      const shown = el("span", { class: "value" });
      const text = () => {
        shown.textContent = words(slider, values[name]);
        input.setAttribute("aria-valuetext", shown.textContent);
      };
      const oninput = () => {
        values[name] = +input.value;
        text();
        if (along && !holder.dataset.drawn) nearest(slider).catch(() => {}); // no network
        draw();
      };
      const onchange = () =>
        (reply.textContent = sliders.map((s) => `${s.label} = ${words(s, values[s.name])}`).join(", "));
      const input = el("input", { type: "range", min, max, step, value, oninput, onchange });
      text();
      return el("label", {}, el("span", {}, `${label} =`), shown, input);
    });
    const wide = picture.classList.contains("wide"); // on a phone keys move it sideways too
    const stage = el("div", { class: "stage", tabindex: wide && 0 }, picture);
    holder.append(stage, el("div", { class: "sliders" }, ...rows), note, reply);
    engine.progress((part) => {
      if (0 < part && part < 1) note.textContent = gettext("The engine is loaded: {percent} %", { percent: Math.round(100 * part) });
    });
  }

  if (root)
    for (const holder of document.querySelectorAll("[data-moving]"))
      figure(holder, JSON.parse(holder.dataset.moving));
  return { figure, sources, numberOf };
})();
