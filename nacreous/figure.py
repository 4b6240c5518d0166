"""Plain diagrams, drawn by matplotlib, which is loaded only when something is drawn."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

#: One look for all diagrams: quiet axes, no boxes.
_STYLE: dict[Any, Any] = {
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "grid.alpha": 0.25,
    "font.size": 9,
    "legend.frameon": False,
    "figure.dpi": 110,
    "savefig.dpi": 160,
    "svg.hashsalt": "nacreous",
}


@contextmanager
def figure(
    path: Path, panels: int = 1, width_in: float = 6.0, height_in: float = 4.0
) -> Iterator[Any]:
    """Yield the axes of a diagram (or an array of `panels` side by side) and write it to `path`.

    The ending of `path` decides the kind: .png, .svg or .pdf. Same drawing, same bytes.

    >>> from tempfile import TemporaryDirectory
    >>> with TemporaryDirectory() as folder:
    ...     path = Path(folder, "line.svg")
    ...     with figure(path) as axes:
    ...         _ = axes.plot([0, 1], [0, 1])
    ...     path.stat().st_size > 1000
    True
    """
    import matplotlib as mpl
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    with mpl.rc_context(_STYLE):
        drawing = Figure(figsize=(width_in, height_in), layout="constrained")
        FigureCanvasAgg(drawing)
        axes = drawing.subplots(1, panels)
        yield axes
        # No date of making, which would differ from day to day.
        undated = {".svg": {"Date": None}, ".pdf": {"CreationDate": None}}
        drawing.savefig(path, metadata=undated.get(path.suffix.lower()))
