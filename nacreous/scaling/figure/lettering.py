"""Words on a sheet: how wide they are, and where they go so that none covers another."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any
from unicodedata import category, east_asian_width

import numpy as np
from numpy.typing import NDArray

__all__ = [
    "INK",
    "QUIET",
    "SIZE_PT",
    "columns",
    "elided",
    "signed",
    "spread",
    "tick_text",
    "ticks",
    "width_pt",
    "write",
]

#: Height of all text.
SIZE_PT = 9.0
INK, QUIET = "#24262b", "#686c75"
#: Share of the height that a letter is wide at most; the widest common fonts reach it.
_LATIN, _WIDE = 0.68, 1.0


def width_pt(text: str) -> float:
    """How wide a text is at most: no font is asked, so that every machine draws the same.

    >>> width_pt("真珠") == 2 * SIZE_PT
    True
    """
    return SIZE_PT * sum(_WIDE if east_asian_width(each) in "WF" else _LATIN for each in text)


def elided(text: str, most_pt: float) -> str:
    """One line of the text, cut with an ellipsis where it is wider than that.

    >>> elided("a very long name", 40.0)
    'a ver…'
    """
    line = "".join("\N{REPLACEMENT CHARACTER}" if category(c) in ("Cc", "Cs") else c for c in text)
    if width_pt(line) <= most_pt:
        return line
    while line and width_pt(line + "…") > most_pt:
        line = line[:-1]
    return line.rstrip() + "…"


def spread(
    places: NDArray[np.float64], widths: NDArray[np.float64], low: float, high: float
) -> NDArray[np.float64] | None:
    """Centres of labels in one row from `low` to `high`, as near to their places as can be.

    places: ascending. None where they do not fit. The squares of the moves are least (isotonic
    regression by pooling neighbours, Barlow and others 1972, with bounds).

    >>> spread(np.array([5.0, 6.0]), np.array([4.0, 4.0]), 0.0, 20.0)
    array([3.5, 7.5])
    """
    if widths.sum() > high - low:
        return None
    steps = np.concatenate([[0.0], (widths[1:] + widths[:-1]) / 2]).cumsum()
    free = np.asarray(_pooled(places - steps))
    least, most = low + widths[0] / 2, high - widths[-1] / 2 - steps[-1]
    return np.asarray(np.clip(free, least, most) + steps, np.float64)


def _pooled(values: NDArray[np.float64]) -> list[float]:
    blocks: list[tuple[float, int]] = []
    for value in values:
        mean, count = float(value), 1
        while blocks and blocks[-1][0] > mean:
            before, members = blocks.pop()
            mean = (mean * count + before * members) / (count + members)
            count += members
        blocks.append((mean, count))
    return [mean for mean, count in blocks for _ in range(count)]


def ticks(low: float, high: float, most: int) -> list[float]:
    """Round numbers from `low` to `high`, about as many as asked for.

    >>> ticks(-0.9, 0.86, 5)
    [-0.5, 0.0, 0.5]
    """
    from matplotlib.ticker import MaxNLocator

    found = MaxNLocator(max(most, 2), steps=[1, 2, 2.5, 5, 10]).tick_values(low, high)
    return [float(tick) for tick in found if low <= tick <= high]


def tick_text(tick: float) -> str:
    """A tick's number, with a true minus sign."""
    return f"{tick:zg}".replace("-", "\N{MINUS SIGN}")


def signed(value: float) -> str:
    """A deviation with one decimal and its sign, which nothing has not.

    >>> signed(1.25), signed(-0.6), signed(-1e-16)
    ('+1.2', '−0.6', '0.0')
    """
    text = f"{value:+.1f}".replace("-", "\N{MINUS SIGN}")
    return text if float(text[1:]) else text[1:]


def columns(texts: Sequence[str], most_pt: float) -> float:
    """The width of a column that holds these texts, at most so much."""
    return min(max((width_pt(text) for text in texts), default=0.0), most_pt)


def write(axes: Any, x: float, y: float, text: str, **look: Any) -> Any:
    """Put text on the sheet; `ha`, `va`, `color`, `rotation` as in matplotlib."""
    return axes.text(x, y, text, **{"fontsize": SIZE_PT, "color": INK, **look})
