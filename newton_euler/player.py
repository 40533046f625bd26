"""The show of an animation: a page by itself, with a button and a slider, without network or other programs; or a GIF."""

import base64
import html
import io
import json
import math
import uuid
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path


class AnimationError(ValueError):
    """An animation that cannot be made or saved."""


@dataclass(frozen=True)
class Animation:
    """Pictures of a motion. Jupyter shows it; :meth:`save` writes it to a file.

    pictures : PNG, as bytes
    times : of the pictures, in s
    speed : seconds of the motion shown in one second
    alt : what it shows, in words
    size : width and height on the screen, in pixels of CSS
    """

    pictures: tuple
    times: tuple
    speed: float
    alt: str
    size: tuple

    def __repr__(self):
        return f"Animation of {len(self.pictures)} pictures from {self._labels()[0]} to {self._labels()[-1]}{': ' * bool(self.alt)}{self.alt}"

    def _repr_mimebundle_(self, **_):
        """The film; where no HTML is shown, as on paper, its first picture."""
        return {"text/html": self.html(), "image/png": base64.b64encode(self.pictures[0]).decode(), "text/plain": repr(self)}

    def html(self):
        """A piece of HTML. Without a script (in a notebook that is not trusted) it is the first picture; for a reader who prefers
        reduced motion it waits at the first picture until it is played."""
        pictures = [base64.b64encode(picture).decode() for picture in self.pictures]
        alt = html.escape(self.alt or f"Animation of a motion from {self._labels()[0]} to {self._labels()[-1]}")
        data = {"pictures": pictures, "times": self.times, "labels": self._labels(), "speed": self.speed}
        name = f"motion-{uuid.uuid4().hex[:12]}"
        return PLAYER.format(
            name=name, alt=alt, first=pictures[0], width=self.size[0], height=self.size[1], last=len(pictures) - 1, told=self._pace(),
            style=STYLE.replace("NAME", name), script=SCRIPT.replace("NAME", name).replace("DATA", json.dumps(data)),
        )  # fmt: skip

    def save(self, path):
        """Write a page (.html), which needs nothing else, or a moving picture (.gif)."""
        path = Path(path)
        if path.suffix == ".html":
            title = html.escape(self.alt or "Animation")
            path.write_text(PAGE.format(title=title, body=self.html()), encoding="utf-8")
        elif path.suffix == ".gif":
            path.write_bytes(self._gif())
        else:
            raise AnimationError(f"an animation is saved as .html or .gif; got {path.name!r}")

    def _gif(self):
        """A GIF counts time in hundredths of a second, and viewers show nothing shorter than two: pictures between are left out."""
        from PIL import Image

        shown, starts = [], []
        for picture, t in zip(self.pictures, self.times, strict=True):
            start = round(100 * (t - self.times[0]) / self.speed)
            if not starts or start >= starts[-1] + 2:
                shown.append(Image.open(io.BytesIO(picture)))
                starts.append(start)
        waits = [10 * (b - a) for a, b in pairwise(starts)] or [1000]
        out = io.BytesIO()
        shown[0].save(out, format="gif", save_all=True, append_images=shown[1:], duration=[*waits, waits[-1]], loop=0)
        return out.getvalue()

    def _pace(self):
        """How the show differs from the motion, in words."""
        if abs(self.speed - 1) < 1e-9:
            return ""
        return f"shown {1 / self.speed:.3g} times slower" if self.speed < 1 else f"shown {self.speed:.3g} times faster"

    def _labels(self):
        """The times in words, with as many decimals as tell them apart."""
        step = min(b - a for a, b in pairwise(self.times))
        decimals = max(0, math.ceil(-math.log10(step) - 1e-9))
        return [f"t = {t:.{decimals}f} s" if decimals < 7 else f"t = {t:.7g} s" for t in self.times]


PAGE = """<!DOCTYPE html>
<html lang="en">
<head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1"><title>{title}</title></head>
<body>
{body}
</body>
</html>
"""

PLAYER = """<div id="{name}">
<style>{style}</style>
<img src="data:image/png;base64,{first}" alt="{alt}" width="{width}" height="{height}">
<div class="controls" hidden>
<button type="button">Play</button>
<input type="range" min="0" max="{last}" value="0" aria-label="time">
<output></output> <span>{told}</span>
</div>
<script>{script}</script>
</div>"""

STYLE = """
#NAME { max-width: max-content; font: 14px sans-serif; }
#NAME img { display: block; max-width: 100%; height: auto; background: #fff; margin: 0; }
#NAME .controls:not([hidden]) { display: flex; flex-wrap: wrap; align-items: center; gap: 0 0.8em; padding: 0.3em 0; }
#NAME button { min-width: 5em; padding: 0.3em 0; font: inherit; }
#NAME input { flex: 1; min-width: 8em; }
#NAME output { min-width: 6.5em; font-variant-numeric: tabular-nums; }
"""

SCRIPT = """
(() => {
  const film = DATA;
  const root = document.getElementById("NAME");
  const [img, controls, button, slider, output] = ["img", ".controls", "button", "input", "output"].map(part => root.querySelector(part));
  const last = film.times.length - 1, start = film.times[0], end = film.times[last] + (film.times[last] - start) / last;
  const ready = film.pictures.map(data => { const picture = new Image(); picture.src = "data:image/png;base64," + data; return picture; });
  let shown = -1, playing = false, began = 0;

  function show(n) {
    if (n === shown) return;
    shown = n;
    img.src = ready[n].src;
    slider.value = n;
    slider.setAttribute("aria-valuetext", film.labels[n]);
    output.textContent = film.labels[n];
  }
  function step(now) {
    if (!playing || !root.isConnected) return;
    let t = start + Math.max(0, now - began) / 1000 * film.speed, n = 0;
    if (t >= end) { began = now; t = start; }
    while (n < last && film.times[n + 1] <= t) n++;
    show(n);
    requestAnimationFrame(step);
  }
  function play(on) {
    button.textContent = on ? "Pause" : "Play";
    if (on) began = performance.now() - (film.times[shown === last ? 0 : shown] - start) / film.speed * 1000;
    if (on && !playing) requestAnimationFrame(step);
    playing = on;
  }
  button.addEventListener("click", () => play(!playing));
  slider.addEventListener("input", () => { play(false); show(Number(slider.value)); });
  controls.hidden = false;
  show(0);
  play(!window.matchMedia("(prefers-reduced-motion: reduce)").matches);
})();
"""
