"""The scale in the paper's manner: a line with labelled points, one line a group."""

from __future__ import annotations

from collections.abc import Mapping
from os import PathLike
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nacreous import file
from nacreous.figure import sheet
from nacreous.scaling.figure import lettering
from nacreous.scaling.figure.fitted import Fitted, by_name, output, span

__all__ = ["scale_plot"]

_POINT = "#2f5d8a"
_MARGIN_PT = 22.0
#: From a line up to the foot of its labels, and how tall upright labels may be.
_RISE_PT, _UPRIGHT_PT = 15.0, 90.0
_LINE_PT = lettering.SIZE_PT * 1.45


def scale_plot(
    fits: Fitted | Mapping[str, Fitted],
    path: str | PathLike[str],
    *,
    unit: str | None = None,
    width_pt: float = 480.0,
) -> None:
    """Draw a scale as a line with a labelled point for each stimulus, as in the paper's figure 3.

    fits: a scale, or several by name, one below the other, as in figure 4. The file's ending
    decides the kind: .svg, .png, .pdf. unit: what is written under the line, the scale's own where
    not given. Larger values, to the right, were preferred. Raises `InputError` for other endings,
    for scales of different stimuli or units, and for a width out of 200 to 2000 points.

    >>> import nacreous as nc
    >>> from tempfile import TemporaryDirectory
    >>> fit = nc.scaling.thurstone([[0, 7, 9], [3, 0, 6], [1, 4, 0]])
    >>> with TemporaryDirectory() as folder:
    ...     scale_plot(fit, f"{folder}/line.svg")
    """
    named = by_name(fits)
    target, width = output(path, width_pt)
    first = next(iter(named.values()))
    low, high = span(*(fit.scale for fit in named.values()))
    rows = [_Row(name, fit, low, high, width) for name, fit in named.items()]
    height = sum(row.height_pt for row in rows) + 3.2 * _LINE_PT
    with file.atomic(target) as temporary, sheet(temporary, width, height) as axes:
        top = 0.0
        for row in rows:
            row.draw(axes, top)
            top += row.height_pt
        rows[-1].draw_ticks(axes, top, low, high)
        lettering.write(
            axes, width / 2, top + 2.1 * _LINE_PT, unit or first.unit, ha="center", va="top"
        )


class _Row:
    """One line: its points, and its labels above them."""

    def __init__(self, name: str, fit: Fitted, low: float, high: float, width: float) -> None:
        self.name, self.width = name, width
        order = np.argsort(fit.scale, kind="stable")
        self.places = _MARGIN_PT + (fit.scale[order] - low) / (high - low) * (
            width - 2 * _MARGIN_PT
        )
        labels = [lettering.elided(fit.stimuli[at], width * 0.4) for at in order]
        shown = np.arange(len(labels))
        centres = _row(self.places, labels, width)
        self.upright = centres is None
        if centres is None:
            labels = [lettering.elided(fit.stimuli[at], _UPRIGHT_PT) for at in order]
            shown, centres = _uprights(self.places, width)
        self.labels = [labels[at] for at in shown]
        self.shown, self.centres = shown, centres
        tall = lettering.columns(self.labels, _UPRIGHT_PT) if self.upright else _LINE_PT
        head = _LINE_PT if name or len(shown) < len(labels) else 0.0
        self.head_pt, self.height_pt = head, head + tall + _RISE_PT + 16.0

    def draw(self, axes: Any, top: float) -> None:
        y = top + self.height_pt - 4.0
        axes.plot(
            [_MARGIN_PT / 2, self.width - _MARGIN_PT / 2], [y, y], color=lettering.INK, lw=0.9
        )
        for at, centre, label in zip(self.shown, self.centres, self.labels, strict=True):
            bend = [self.places[at], centre]
            axes.plot(bend, [y - 4.0, y - _RISE_PT + 2.0], color="#b9bbb8", lw=0.7)
            # matplotlib's upright text needs its lower end on the anchor, whatever its length.
            turned = {"rotation": 90, "rotation_mode": "anchor", "ha": "left", "va": "center"}
            look = turned if self.upright else {"ha": "center", "va": "bottom"}
            lettering.write(axes, centre, y - _RISE_PT, label, **look)
        axes.plot(self.places, np.full(len(self.places), y), "o", color=_POINT, ms=5, mew=0)
        if self.head_pt:
            hidden = len(self.places) - len(self.shown)
            count = f" ({len(self.shown)} / {len(self.places)})" if hidden else ""
            head = (lettering.elided(self.name, self.width - 80.0) + count).strip()
            lettering.write(axes, _MARGIN_PT / 2, top + 6.0, head, va="top", color=lettering.QUIET)

    def draw_ticks(self, axes: Any, top: float, low: float, high: float) -> None:
        room = self.width - 2 * _MARGIN_PT
        for tick in lettering.ticks(low, high, int(room // 55)):
            x = _MARGIN_PT + (tick - low) / (high - low) * room
            axes.plot([x, x], [top - 4.0, top + 1.0], color=lettering.INK, lw=0.9, zorder=1)
            lettering.write(axes, x, top + 4.0, lettering.tick_text(tick), ha="center", va="top")


def _row(places: NDArray[np.float64], labels: list[str], width: float) -> Any:
    """Centres of labels that lie side by side; None where they are too many."""
    widths = np.array([lettering.width_pt(label) + 5.0 for label in labels])
    return lettering.spread(places, widths, 1.0, width - 1.0)


def _uprights(places: NDArray[np.float64], width: float) -> tuple[NDArray[np.int64], Any]:
    """Which upright labels fit, both ends among them, and their centres."""
    most = int((width - 2.0) // _LINE_PT)
    shown = np.unique(np.linspace(0, len(places) - 1, min(most, len(places))).round().astype(int))
    return shown, lettering.spread(
        places[shown], np.full(len(shown), _LINE_PT * 0.98), 1.0, width - 1.0
    )
