// move the first slider of a figure
const holder = document.querySelectorAll("[data-moving]")[arguments[0]], input = holder.querySelector("input");
input.value = arguments[1] === "end" ? input.max : +input.value + +input.step * (+input.value < +input.max ? 1 : -1);
for (const kind of ["input", "change"]) input.dispatchEvent(new Event(kind, {bubbles: true}));
return [JSON.parse(holder.dataset.moving).sliders[0].name, +input.value];
