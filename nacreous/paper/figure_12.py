"""Figure 12: the mirrored component, lamp and table."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from nacreous.figure import figure
from nacreous.paper.component import alone
from nacreous.paper.exhibit import Exhibit, Plate
from nacreous.paper.lamp_image import LampImage
from nacreous.paper.measurement import Measurement
from nacreous.paper.pictures import Pictures
from nacreous.paper.sight import Sight
from nacreous.paper.table_image import fading
from nacreous.spec import Scene

__all__ = ["FILES", "exhibit", "measure"]

Array = NDArray[np.float64]

FILES = ("figure-12.png", "figure-12-fading.png")
#: Share of the pearl that the component's exposure suits: the lamp's image is far brighter.
_SHOWN = 0.97


def measure(mirror: NDArray[np.float32], sight: Sight, scene: Scene) -> list[Measurement]:
    """What the paper's sentences ask of the mirrored component, linear RGB [row, column, 3]."""
    lamp = LampImage.of(mirror, sight)
    white = scene.camera.exposure * scene.lamps[0].intensity
    edge_px = np.radians(lamp.edge_deg) * sight.circle.radius_px
    distance_mm, contrast = fading(mirror, sight, scene.table.check_mm)
    known = np.flatnonzero(np.isfinite(contrast))
    near, far = (known[0], known[-1]) if known.size > 1 else (0, 0)
    left = float(contrast[far] / contrast[near]) if near != far else float("nan")
    rise = float(np.diff(contrast[known]).max()) if near != far else float("nan")
    at_near, at_far = (f"{distance_mm[reach]:.0f} mm away" for reach in (near, far))
    return [
        Measurement(
            "peak of the lamp's image, over white in its light", lamp.peak / white, least=1
        ),
        Measurement("half width of the lamp's image", lamp.half_width_deg, "°", most=15),
        Measurement("width of its edge, from 90 % to 10 %", lamp.edge_deg, "°", least=1, most=20),
        Measurement("the edge in the middle of the pearl", float(edge_px), "pixels", least=1.5),
        Measurement(f"contrast of the table {at_near}", float(contrast[near]), least=0.3),
        Measurement(f"contrast {at_far}, over that", left, most=0.7),
        Measurement("largest rise of contrast on the way out", rise, most=0.0),
    ]


def exhibit(folder: Path, pictures: Pictures) -> Exhibit:
    """Save the component and the diagram in `folder`, and measure them."""
    path, curve = (folder / name for name in FILES)
    component, gain = alone(pictures.smooth, "mirror", _SHOWN)
    component.save(path)
    mirror, scene, sight = pictures.smooth.layers["mirror"], pictures.scene, pictures.sight
    falloff_mm = pictures.pearl.surface.falloff_mm
    _draw(curve, *fading(mirror, sight, scene.table.check_mm), falloff_mm)
    return Exhibit(
        "12",
        [Plate(path), Plate(curve)],
        measure(mirror, sight, scene),
        "nacreous render paper --set grain=0 -o layers.exr (layer mirror)",
        [
            f"The component is shown {gain:g} times as bright as in figure 14 (a); the lamp's "
            "image is far brighter than the screen can show. Its widths are angles of the "
            "surface's normal.",
            "Contrast is (light − dark) / (light + dark) of the mirrored squares, with shading and "
            "shadow fitted away; distances are from the pearl's surface. Far squares are finer "
            "than the picture, which takes more contrast than the law.",
        ],
    )


def _draw(path: Path, distance_mm: Array, contrast: Array, falloff_mm: float) -> None:
    known = np.flatnonzero(np.isfinite(contrast))
    with figure(path, width_in=6.0, height_in=3.0) as axes:
        axes.plot(distance_mm[known], contrast[known], "o-", color="#335c81", label="measured")
        if known.size:
            along_mm = np.linspace(0.0, float(distance_mm[known].max()), 100)
            law = contrast[known[0]] * np.exp((distance_mm[known[0]] - along_mm) / falloff_mm)
            label = f"exp(−distance / {falloff_mm:g} mm)"
            axes.plot(along_mm, law, "--", color="#999999", label=label)
        axes.set(ylim=(0, None), xlim=(0, None))
        axes.set_xlabel("distance from the pearl's surface to the table, mm")
        axes.set_ylabel("contrast of the squares")
        axes.legend()
