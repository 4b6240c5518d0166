"""Plain diagrams, drawn by matplotlib, which is loaded only when something is drawn."""

from __future__ import annotations

import logging
import warnings
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any

from nacreous.printable import printable
from nacreous.problem import InputError

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

#: No date of making, which would differ from day to day.
_UNDATED: dict[str, dict[Any, Any]] = {".svg": {"Date": None}, ".pdf": {"CreationDate": None}}


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
    mpl = _matplotlib()
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    with _style(mpl, _STYLE):
        drawing = Figure(figsize=(width_in, height_in), layout="constrained")
        FigureCanvasAgg(drawing)
        axes = drawing.subplots(1, panels)
        yield axes
        drawing.savefig(path, metadata=_UNDATED.get(path.suffix.lower()))


@contextmanager
def sheet(path: Path, width_pt: float, height_pt: float) -> Iterator[Any]:
    """Yield axes that are an empty sheet, in points (1/72 inch) from its upper left corner.

    For drawings that lay out their own text. In SVG, text stays text, for the reader's fonts to
    show; in PNG and PDF, Japanese is set in a Japanese font where the machine has one. The ending
    of `path` decides the kind. Same drawing, same bytes (in PNG and PDF: with the same fonts).

    >>> from tempfile import TemporaryDirectory
    >>> with TemporaryDirectory() as folder:
    ...     path = Path(folder, "word.svg")
    ...     with sheet(path, 72, 36) as axes:
    ...         _ = axes.text(10, 20, "lustre")
    ...     ">lustre</text>" in path.read_text()
    True
    """
    mpl = _matplotlib()
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    kind = path.suffix.lower()
    # A dollar sign in a label is a dollar sign, and SVG's bytes shall not hang on this machine's
    # fonts: only a picture that holds the letters' shapes looks for Japanese ones.
    words = {"svg.fonttype": "none", "text.parse_math": False}
    fonts = {} if kind == ".svg" else {"font.family": ["DejaVu Sans", *japanese_fonts()]}
    with _style(mpl, _STYLE | words | fonts), warnings.catch_warnings():
        warnings.filterwarnings("ignore", "Glyph .* missing from font")
        drawing = Figure(figsize=(width_pt / 72, height_pt / 72))
        FigureCanvasAgg(drawing)
        axes = drawing.add_axes((0, 0, 1, 1), xlim=(0, width_pt), ylim=(height_pt, 0))
        axes.set_axis_off()
        yield axes
        drawing.savefig(path, metadata=_UNDATED.get(kind))


@contextmanager
def _style(mpl: Any, style: dict[str, Any]) -> Iterator[None]:
    """Matplotlib's defaults and a style, whatever a `matplotlibrc` says."""
    with mpl.rc_context():
        mpl.rcdefaults()
        mpl.rcParams.update(style)
        yield


def _matplotlib() -> Any:
    """The library, which keeps to itself that it cannot keep its cache where HOME is read-only."""
    logger = logging.getLogger("matplotlib")
    level = logger.level
    logger.setLevel(logging.ERROR)
    try:
        import matplotlib as mpl
        import matplotlib.font_manager
    except UnicodeDecodeError:
        raise InputError("matplotlibrc is not UTF-8; allowed: text in UTF-8, or none") from None
    finally:
        logger.setLevel(level)
    return mpl


def letters_without_a_font(text: str) -> str:
    """The letters of a text that no font of a `sheet` has here, each once.

    >>> letters_without_a_font("lustre")
    ''
    """
    _matplotlib()
    from matplotlib.font_manager import findfont, get_font

    fonts = [get_font(findfont(name)) for name in ("DejaVu Sans", *japanese_fonts())]
    held = {code for font in fonts for code in font.get_charmap()}
    return "".join(one for one in dict.fromkeys(printable(text)) if ord(one) not in held)


def japanese_fonts() -> list[str]:
    """Those of the common Japanese fonts that are here."""
    return _common_here() or (_look_for_new_fonts() and _common_here()) or []


def _common_here() -> list[str]:
    from matplotlib.font_manager import fontManager

    here = {font.name for font in fontManager.ttflist}
    common = (
        *("Noto Sans CJK JP", "Hiragino Sans", "Yu Gothic", "Meiryo", "IPAexGothic", "IPAGothic"),
        *("TakaoGothic", "VL Gothic", "Noto Serif CJK JP"),
    )
    return [name for name in common if name in here]


def _look_for_new_fonts() -> bool:
    """Whether fonts were installed since matplotlib wrote its list of them, which it keeps."""
    from matplotlib.font_manager import findSystemFonts, fontManager

    known = {font.fname for font in fontManager.ttflist}
    new = sorted(set(findSystemFonts()) - known)
    for path in new:
        with suppress(RuntimeError, OSError):  # a file that is no font that it can read
            fontManager.addfont(path)
    return bool(new)
