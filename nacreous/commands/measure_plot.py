"""The plot of `nacreous measure`: what was found, over the picture."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

from nacreous import _core
from nacreous.figure import figure
from nacreous.measure import Measures, Places

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

__all__ = ["plot"]

#: Colours that stand out from pearls and cloth alike, and from each other to all eyes.
_OUTLINE, _RING, _LAMP, _SPOT = "#0072b2", "#56b4e9", "#d55e00", "#cc79a7"
#: How much of the surroundings is shown, in radii from the middle.
_SHOWN = 1.25
#: Room above the highest chroma for its mark, as a factor; and the least chroma that is shown.
_ROOM, _LEAST_SHOWN = 1.12, 1.0


def plot(path: Path, linear: NDArray[np.float32], found: Measures) -> None:
    """Draw what was found over the picture, and colour by ring beside it."""
    with figure(path, 2, 10.0, 4.6) as (picture, rings):
        _overlay(picture, linear, found)
        _by_ring(rings, found)


def _overlay(axes: Any, linear: NDArray[np.float32], found: Measures) -> None:
    circle = found.outline.circle
    height, width = linear.shape[:2]
    codes, _ = _core.develop(linear, "srgb", "soft", 8)
    axes.imshow(codes, extent=(0, width, height, 0), interpolation="nearest")
    _line(axes, found.outline.line, _OUTLINE, "outline")
    for number, ring in enumerate(found.rings or ()):
        label = "rings" if number == 0 else None
        _round(axes, (circle.x_px, circle.y_px, ring.outer * circle.radius_px), _RING, label)
    if found.lamp is not None:
        _line(axes, found.lamp.line, _LAMP, "lamp's image, half level")
        axes.plot(found.lamp.x_px, found.lamp.y_px, "+", color=_LAMP)
    for number, spot in enumerate(found.blemishes.spots if found.blemishes else ()):
        label = "blemishes" if number == 0 else None
        _round(axes, (spot.x_px, spot.y_px, spot.radius_px + 2), _SPOT, label)
    reach = _SHOWN * circle.radius_px
    axes.set_xlim(max(0, circle.x_px - reach), min(width, circle.x_px + reach))
    axes.set_ylim(min(height, circle.y_px + reach), max(0, circle.y_px - reach))
    axes.grid(False)
    axes.set_xlabel("pixels")
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, 1.12), ncols=2)


def _line(axes: Any, places: Places, colour: str, label: str) -> None:
    x, y = zip(*places, places[0], strict=True)
    axes.plot(x, y, color=colour, linewidth=1.2, label=label)


def _round(axes: Any, circle: tuple[float, float, float], colour: str, label: str | None) -> None:
    from matplotlib.patches import Circle as Drawn

    x, y, radius = circle
    axes.add_patch(Drawn((x, y), radius, fill=False, edgecolor=colour, linewidth=0.8, label=label))


def _by_ring(axes: Any, found: Measures) -> None:
    """Chroma and lightness by view angle, each mark in the ring's own colour where it has one."""
    axes.set_xlabel("view angle, degrees")
    axes.set_ylabel("chroma C* (marks: the rings' colours)")
    held = [(ring.view_deg, ring.colour) for ring in found.rings or () if ring.colour is not None]
    if not held:
        axes.text(0.5, 0.5, "rings not measured", ha="center", transform=axes.transAxes)
        return
    view = [angle for angle, _ in held]
    chroma = [colour.chroma.value for _, colour in held]
    axes.errorbar(
        view,
        chroma,
        [colour.chroma.error or 0.0 for _, colour in held],
        color="#888888",
        linewidth=1,
        capsize=2,
        label="chroma, with standard errors",
    )
    axes.scatter(
        view, chroma, s=90, c=[_code(colour) for _, colour in held], edgecolors="#444444", zorder=3
    )
    # From grey up, with room for a whole mark above the highest; a grey pearl has room too.
    axes.set_ylim(0, max(axes.get_ylim()[1], _ROOM * max(chroma), _LEAST_SHOWN))
    lightness = axes.twinx()
    lightness.plot(
        view,
        [colour.lightness.value for _, colour in held],
        "--",
        color="#444444",
        label="lightness",
    )
    lightness.set_ylim(0, 100)
    lightness.set_ylabel("lightness L* (dashed)")
    lightness.spines["right"].set_visible(True)
    lightness.grid(False)


def _code(colour: Any) -> tuple[float, ...]:
    """A ring's colour on the screen, its hue and chroma as they are."""
    import math

    import numpy as np

    from nacreous import colour as colours

    hue = math.radians(colour.hue_deg.value) if colour.hue_deg else 0.0
    lab = [
        colour.lightness.value,
        colour.chroma.value * math.cos(hue),
        colour.chroma.value * math.sin(hue),
    ]
    rgb = colours.rgb_from_xyz(colours.xyz_from_lab(np.array(lab)))
    return tuple(np.clip(colours.encode(rgb), 0, 1).tolist())
