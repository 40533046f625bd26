// ipywidgets names no handle of a slider for a screen reader, and its value has no unit: both are
// in the label beside, "φ = 30°". The classes are those of interactive.py.
if (!window.newtonEulerSliders) {
  const set = (handle, name, text) =>
    handle.getAttribute(name) === text || handle.setAttribute(name, text);
  const describe = () => {
    for (const row of document.querySelectorAll('.newton-euler-slider')) {
      const handle = row.querySelector('[role=slider]'), label = row.querySelector('.newton-euler-value');
      if (!handle || !label) continue;
      const [name, value] = label.textContent.split(' = ');
      set(handle, 'aria-label', name);
      set(handle, 'aria-valuetext', value);
    }
  };
  let asked = false;
  const soon = () => {
    if (!asked) requestAnimationFrame(() => { asked = false; describe(); });
    asked = true;
  };
  window.newtonEulerSliders = new MutationObserver(soon);
  window.newtonEulerSliders.observe(document.body, {
    subtree: true, childList: true, attributes: true, attributeFilter: ['aria-valuetext'],
  });
  soon();
}
