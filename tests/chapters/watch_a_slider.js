// notes the time of each event and of each frame in which the picture is another; and the frames
// without a picture, which a reader would see as flicker
const cell = arguments[0], seen = window.seen = {events: [], changes: [], blank: 0};
const picture = () => cell.querySelector('.jp-OutputArea-output img');
let last = picture().src;
window.stopWatching && window.stopWatching();
const note = () => seen.events.push(performance.now());
for (const kind of ['keydown', 'pointermove']) cell.addEventListener(kind, note, true);
let on = true;
window.stopWatching = () => {
  on = false;
  for (const kind of ['keydown', 'pointermove']) cell.removeEventListener(kind, note, true);
};
function frame() {
  const img = picture();
  if (!img || !img.complete || !img.naturalWidth) seen.blank += 1;
  else if (img.src !== last) { last = img.src; seen.changes.push(performance.now()); }
  if (on) requestAnimationFrame(frame);
}
requestAnimationFrame(frame);
