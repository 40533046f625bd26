// The first page: a figure that turns with its slider, and a question. Both were computed when the
// page was built, so neither needs the engine.
(() => {
  const data = (where) => JSON.parse(where.querySelector("script[type='application/json']").textContent);
  const landing = document.querySelector(".landing"), taste = document.querySelector("form.taste");
  if (landing) {
    const { angles, most, sizes } = data(landing), frames = [...landing.querySelectorAll(".figure > div")];
    const slider = landing.querySelector("input"), output = landing.querySelector("output");
    const show = () => {
      const n = +slider.value;
      frames.forEach((frame, m) => (frame.hidden = m !== n));
      output.textContent = `${angles[n]}°`;
      slider.setAttribute("aria-valuetext", gettext("{angle} degrees", { angle: angles[n] }));
      landing.querySelectorAll("dd").forEach((dd, m) => {
        dd.querySelector("span").style.width = `${(70 * sizes[n][m]) / most}%`;
        dd.querySelector("b").textContent = `${sizes[n][m]} mm/s²`;
      });
    };
    // the figure itself can be dragged too
    const figure = landing.querySelector(".figure");
    let from;
    figure.addEventListener("pointerdown", (e) => ((from = [e.clientX, +slider.value]), figure.setPointerCapture(e.pointerId)));
    figure.addEventListener("pointermove", (e) => {
      if (!from) return;
      slider.value = from[1] + ((e.clientX - from[0]) / figure.clientWidth) * 1.5 * frames.length;
      show();
    });
    for (const end of ["pointerup", "pointercancel"]) figure.addEventListener(end, () => (from = undefined));
    slider.addEventListener("input", show);
    show();
  }
  if (taste) {
    const verdicts = data(taste), verdict = taste.querySelector("[role=status]");
    taste.addEventListener("submit", (event) => {
      event.preventDefault();
      const text = taste.querySelector("input").value.trim().replace(",", ".").replace("−", "-"), x = Number(text);
      const near = verdicts.find(([value]) => Math.abs(x - value) <= 0.005 * Math.max(Math.abs(value), 1e-6));
      const right = near?.[1] === "right";
      verdict.className = `verdict ${right ? "right" : "wrong"}`;
      verdict.textContent = !text || Number.isNaN(x) ? gettext("Write a number, as -2.5.") :
        `${right ? "✓" : "✗"} ${near ? near[2] : gettext("not right; the page of the problem has hints and steps")}`;
    });
  }
})();
