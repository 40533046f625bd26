"""pictures.py: a figure shown once, with its alt text."""

import base64

import matplotlib
import matplotlib.pyplot as plt
import pytest

from newton_euler import NewtonEulerError
from newton_euler.classroom import show_figure

matplotlib.use("Agg")
ALT = 'A disk "rolls" on a line < 3 m long'


def plot():
    figure, ax = plt.subplots(figsize=(3, 2))
    ax.plot([0, 1], [0, 1])
    return figure


def test_a_figure_is_shown_as_html_and_as_png_of_two_pixels_each_and_closed(shown):
    show_figure(plot(), ALT)
    ((data, metadata),) = shown.outputs
    assert 'alt="A disk &quot;rolls&quot; on a line &lt; 3 m long"' in data["text/html"]
    assert "max-width: 100%" in data["text/html"]
    assert data["image/png"] in data["text/html"]
    assert metadata["image/png"]["alt"] == data["text/plain"] == ALT
    assert not plt.get_fignums()  # otherwise the notebook would show it twice
    png = base64.b64decode(data["image/png"])
    assert abs(int.from_bytes(png[16:20], "big") - 2 * metadata["image/png"]["width"]) <= 1


@pytest.mark.parametrize("alt", ["", "A disk that rolls on a line", None])
def test_an_alt_text_of_fewer_than_8_words_is_refused(shown, alt):
    with pytest.raises(NewtonEulerError, match="alt"):
        show_figure(plot(), alt)
    plt.close("all")


def test_what_is_not_a_figure_is_refused():
    with pytest.raises(NewtonEulerError, match="matplotlib figure or a Page; got 3"):
        show_figure(3, ALT)
