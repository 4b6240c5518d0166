"""A matrix of pairs as a heat map: proportions, or residuals."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from os import PathLike
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nacreous import file
from nacreous.figure import sheet
from nacreous.number import array_of
from nacreous.problem import InputError
from nacreous.scaling.figure import lettering
from nacreous.scaling.figure.fitted import output

__all__ = ["matrix_plot"]

#: More rows than a page has room for, and than a file should carry.
MOST = 1000
#: Cells narrower than this hold no number and no label of their own.
_LEGIBLE_PT = 21.0
_EMPTY = "#f2f2ee"
_BAR_PT = 30.0
#: Residuals up to here are what chance makes of single pairs; they never get the full colour.
_CHANCE = 2.0


def matrix_plot(
    values: ArrayLike,
    stimuli: Sequence[str],
    path: str | PathLike[str],
    *,
    kind: Literal["proportions", "residuals"] = "proportions",
    order: ArrayLike | None = None,
    width_pt: float = 360.0,
) -> None:
    """Draw a matrix of pairs as a heat map; row i, column j is how i did against j.

    values: [n, n], NaN where there is nothing to show. Proportions run from 0 to
    1, and are shown as percentages; residuals from minus to plus the largest, 2 at the
    least, so that chance stays pale.
    order: the stimuli's rows from top to bottom, as given where not
    given. The file's ending decides the kind of file: .svg, .png, .pdf. Raises `InputError` for a
    matrix that is not square, of another size than the names, or of more than 1000 rows.

    >>> from tempfile import TemporaryDirectory
    >>> with TemporaryDirectory() as folder:
    ...     matrix_plot([[np.nan, 0.8], [0.2, np.nan]], ["a", "b"], f"{folder}/share.svg")
    """
    target, width = output(path, width_pt)
    matrix = array_of("values", values)
    count = len(stimuli)
    if matrix.shape != (count, count) or not 1 <= count <= MOST:
        shape = " x ".join(str(side) for side in matrix.shape)
        raise InputError(f"values is an array of {shape}; allowed: {count} x {count}, 1 to {MOST}")
    if kind not in ("proportions", "residuals"):
        raise InputError(f"kind is {kind!r}; allowed: proportions, residuals")
    rows = np.arange(count) if order is None else np.asarray(order)
    if rows.shape != (count,) or sorted(rows.tolist()) != list(range(count)):
        raise InputError(f"order is no arrangement of 0 to {count - 1}; allowed: each once")
    labels = [lettering.elided(stimuli[row], width * 0.25) for row in rows.tolist()]
    with file.atomic(target) as temporary:
        _draw(temporary, matrix[np.ix_(rows, rows)], labels, kind, width)


def _draw(
    path: Any, matrix: NDArray[np.float64], labels: list[str], kind: str, width: float
) -> None:
    count = len(labels)
    left = lettering.columns(labels, width * 0.25) + 6.0
    cell = (width - left - 2.0) / count
    flat = max((lettering.width_pt(label) for label in labels), default=0.0) <= cell
    top = 16.0 if flat else left
    bottom = top + cell * count
    colours, low, high = _colours(matrix, kind)
    with sheet(path, width, bottom + _BAR_PT) as axes:
        edges = np.arange(count + 1) * cell
        axes.pcolormesh(
            left + edges,
            top + edges,
            np.ma.masked_invalid(matrix),
            cmap=colours,
            vmin=low,
            vmax=high,
            edgecolors="white" if cell >= _LEGIBLE_PT else "none",
            linewidth=1.0 if cell >= _LEGIBLE_PT else 0.0,
            rasterized=count > 40,
        )
        _names(axes, labels, left, top, cell, flat)
        if cell >= _LEGIBLE_PT:
            _numbers(
                axes, matrix, kind, (left, top, cell), lambda v: colours((v - low) / (high - low))
            )
        _bar(axes, colours, (low, high), kind, left, bottom, min(140.0, width - left - 56.0))


def _colours(matrix: NDArray[np.float64], kind: str) -> tuple[Any, float, float]:
    from matplotlib.colors import LinearSegmentedColormap

    if kind == "proportions":
        shades = ["#faf7f0", "#bcd0e2", "#2f5d8a"]
        low, high = 0.0, 1.0
    else:
        shades = ["#c05a1b", "#f7f7f5", "#2f5d8a"]
        seen = np.abs(matrix[np.isfinite(matrix)])
        high = float(seen.max(initial=_CHANCE))
        low = -high
    colours = LinearSegmentedColormap.from_list(kind, shades)
    return colours.with_extremes(bad=_EMPTY), low, high


def _names(axes: Any, labels: list[str], left: float, top: float, cell: float, flat: bool) -> None:
    """Every label where there is room, else every second, third ... one."""
    step = max(1, int(np.ceil(lettering.SIZE_PT * 1.2 / cell)))
    upright = {"rotation": 90, "rotation_mode": "anchor", "ha": "left", "va": "center"}
    look = {"ha": "center", "va": "bottom"} if flat else upright
    for at in range(0, len(labels), step):
        middle = (at + 0.5) * cell
        lettering.write(
            axes, left - 4.0, top + middle, labels[at], ha="right", va="center_baseline"
        )
        lettering.write(axes, left + middle, top - 4.0, labels[at], **look)


def _numbers(
    axes: Any,
    matrix: NDArray[np.float64],
    kind: str,
    place: tuple[float, float, float],
    colour_of: Callable[[float], Any],
) -> None:
    left, top, cell = place
    for row, column in np.argwhere(np.isfinite(matrix)):
        value = matrix[row, column]
        text = f"{100 * value:.0f}" if kind == "proportions" else lettering.signed(value)
        dark = np.dot(colour_of(value)[:3], (0.3, 0.6, 0.1)) < 0.58  # about how light it looks
        x, y = left + (column + 0.5) * cell, top + (row + 0.5) * cell
        look = {"color": "white" if dark else lettering.INK, "fontsize": lettering.SIZE_PT - 1.0}
        lettering.write(axes, x, y, text, ha="center", va="center_baseline", **look)


def _bar(
    axes: Any,
    colours: Any,
    ends: tuple[float, float],
    kind: str,
    left: float,
    bottom: float,
    length: float,
) -> None:
    """What the colours mean."""
    steps = np.linspace(0.0, 1.0, 41)
    axes.pcolormesh(
        left + 26.0 + steps * length,
        [bottom + 12.0, bottom + 22.0],
        [steps[:-1]],
        cmap=colours,
        edgecolors="face",
    )
    texts = [f"{end:.0%}" if kind == "proportions" else lettering.signed(end) for end in ends]
    lettering.write(axes, left + 22.0, bottom + 17.0, texts[0], ha="right", va="center_baseline")
    lettering.write(axes, left + length + 30.0, bottom + 17.0, texts[1], va="center_baseline")
