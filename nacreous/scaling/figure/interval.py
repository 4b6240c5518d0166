"""The scale with its doubt: one row a stimulus, a dot with its interval, a colour a group."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from os import PathLike
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nacreous import file
from nacreous.figure import sheet
from nacreous.number import array_of
from nacreous.problem import InputError
from nacreous.scaling.figure import lettering
from nacreous.scaling.figure.fitted import Fitted, by_name, output, span

__all__ = ["interval_plot"]

#: Told apart by shape as well as by colour (Okabe and Ito's, which colour-blind people tell apart).
_MARKS = (
    ("#2f5d8a", "o"),
    ("#d55e00", "s"),
    ("#009e73", "D"),
    ("#cc79a7", "^"),
    ("#7a6a00", "v"),
    ("#56b4e9", "P"),
)
_ROW_PT, _STEP_PT, _GAP_PT = 17.0, 8.0, 8.0


def interval_plot(
    fits: Fitted | Mapping[str, Fitted],
    path: str | PathLike[str],
    *,
    intervals: ArrayLike | Mapping[str, ArrayLike],
    open_ends: ArrayLike | None = None,
    unit: str | None = None,
    width_pt: float = 480.0,
) -> None:
    """Draw a scale with an interval at each stimulus, the most preferred on top.

    fits: a scale, or up to six by name, in the order of the first. intervals: [stimulus, 2], lower
    and upper end, as `fit.intervals()` gives them; by the same names where there are several.
    open_ends: bool [stimulus, 2], ends that the answers do not set, of one scale: dots go on from
    there to an arrow at the edge. The file's ending decides the kind: .svg, .png, .pdf. Raises
    `InputError` for what `scale_plot` refuses, and for intervals of another shape or not finite.

    >>> import nacreous as nc
    >>> from tempfile import TemporaryDirectory
    >>> fit = nc.scaling.thurstone([[0, 7, 9], [3, 0, 6], [1, 4, 0]])
    >>> with TemporaryDirectory() as folder:
    ...     interval_plot(fit, f"{folder}/doubt.svg", intervals=fit.intervals())
    """
    named = by_name(fits)
    target, width = output(path, width_pt)
    if len(named) > len(_MARKS):
        raise InputError(f"there are {len(named)} scales to draw; allowed: 1 to {len(_MARKS)}")
    bounds = _bounds(named, intervals)
    first = next(iter(named.values()))
    order = np.argsort(-first.scale, kind="stable")
    labels = [lettering.elided(first.stimuli[at], width * 0.34) for at in order]
    left = lettering.columns(labels, width * 0.34) + 2 * _GAP_PT
    row_pt = _ROW_PT + _STEP_PT * (len(named) - 1)
    head = _ROW_PT * (0 if "" in named else _legend_rows(named, width)) + 4.0
    foot = head + row_pt * len(labels)
    low, high = span(*bounds.values())

    def place(value: NDArray[np.float64] | float) -> Any:
        return left + (value - low) / (high - low) * (width - left - 2 * _GAP_PT)

    with file.atomic(target) as temporary, sheet(temporary, width, foot + 38.0) as axes:
        _frame(axes, place, (low, high), (head, foot), width - left)
        for at, label in enumerate(labels):
            middle = head + (at + 0.5) * row_pt
            lettering.write(axes, left - _GAP_PT, middle, label, ha="right", va="center_baseline")
        for at, (name, fit) in enumerate(named.items()):
            y = head + (np.arange(len(order)) + 0.5) * row_pt
            y = y + _STEP_PT * (at - (len(named) - 1) / 2)
            if open_ends is not None:
                _arrows(
                    axes, place, bounds[name][order], _open(open_ends, fit)[order], y, _MARKS[at]
                )
            _dots(axes, place(fit.scale[order]), place(bounds[name][order]), y, _MARKS[at])
        lettering.write(
            axes, (left + width) / 2, foot + 20.0, unit or first.unit, ha="center", va="top"
        )
        if "" not in named:
            _legend(axes, list(named), width)


def _bounds(
    named: Mapping[str, Fitted], intervals: ArrayLike | Mapping[str, ArrayLike]
) -> dict[str, NDArray[np.float64]]:
    given = intervals if isinstance(intervals, Mapping) else {"": intervals}
    found = {}
    for name, fit in named.items():
        if name not in given:
            raise InputError(f"intervals of scale {name!r} are missing")
        ends = array_of("intervals", given[name])
        if ends.shape != (len(fit.stimuli), 2) or not np.isfinite(ends).all():
            shape = " x ".join(str(side) for side in ends.shape)
            raise InputError(
                f"intervals is an array of {shape}; allowed: {len(fit.stimuli)} x 2 finite numbers"
            )
        found[name] = ends
    return found


def _open(given: ArrayLike, fit: Fitted) -> NDArray[np.bool_]:
    ends = np.asarray(given, np.bool_)
    if ends.shape != (len(fit.stimuli), 2):
        shape = " x ".join(str(side) for side in ends.shape)
        raise InputError(
            f"open_ends is an array of {shape}; allowed: {len(fit.stimuli)} x 2 truth values"
        )
    return ends


def _arrows(
    axes: Any,
    place: Any,
    bounds: NDArray[np.floating[Any]],
    gone: NDArray[np.bool_],
    y: NDArray[np.floating[Any]],
    mark: tuple[str, str],
) -> None:
    """Dots from an end that the answers do not set to beyond the outermost one."""
    for side, (edge, head, shift) in enumerate(
        ((bounds.min(), "<", -_GAP_PT), (bounds.max(), ">", _GAP_PT))
    ):
        for row in np.flatnonzero(gone[:, side]):
            tip = place(edge) + 0.6 * shift
            at = [y[row], y[row]]
            axes.plot([place(bounds[row, side]), tip], at, ":", color=mark[0], lw=1.4, zorder=2)
            axes.plot([tip], at[:1], head, color=mark[0], ms=5, mew=0, zorder=2)


def _frame(
    axes: Any,
    place: Any,
    values: tuple[float, float],
    rows: tuple[float, float],
    room: float,
) -> None:
    for tick in lettering.ticks(*values, int(room // 55)):
        x = place(tick)
        look = {"color": "#b9bbb8", "lw": 0.9} if tick == 0 else {"color": "#e6e6e2", "lw": 0.7}
        axes.plot([x, x], rows, zorder=1, **look)
        lettering.write(axes, x, rows[1] + 4.0, lettering.tick_text(tick), ha="center", va="top")


def _dots(axes: Any, x: Any, ends: Any, y: Any, mark: tuple[str, str]) -> None:
    colour, shape = mark
    axes.hlines(y, ends[:, 0], ends[:, 1], color=colour, lw=1.6, alpha=0.75, zorder=2)
    axes.plot(x, y, shape, color=colour, ms=5, mew=0, zorder=3)


def _cells(names: Sequence[str], width: float) -> list[tuple[float, int, str]]:
    """Where the legend's entries begin, in which row, and what they say."""
    cells, x, row = [], 4.0, 0
    for name in names:
        text = lettering.elided(name, width - 30.0)
        room = lettering.width_pt(text) + 26.0
        if x > 4.0 and x + room > width:
            x, row = 4.0, row + 1
        cells.append((x, row, text))
        x += room
    return cells


def _legend_rows(named: Mapping[str, Fitted], width: float) -> int:
    return _cells(list(named), width)[-1][1] + 1


def _legend(axes: Any, names: Sequence[str], width: float) -> None:
    for (x, row, text), (colour, shape) in zip(_cells(names, width), _MARKS, strict=False):
        y = (row + 0.5) * _ROW_PT
        axes.plot([x + 5.0], [y], shape, color=colour, ms=5, mew=0)
        lettering.write(axes, x + 13.0, y, text, va="center_baseline")
