"""Figure 12: the mirrored component, lamp and table."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from nacreous.figure import figure
from nacreous.paper.component import alone
from nacreous.paper.exhibit import Exhibit, Plate, Quotation
from nacreous.paper.lamp_image import LampImage
from nacreous.paper.measurement import Measurement
from nacreous.paper.pictures import Pictures
from nacreous.paper.sight import Sight
from nacreous.paper.table_image import fading
from nacreous.spec import Scene

__all__ = ["exhibit", "measure"]

Array = NDArray[np.float64]

FILES = ("figure-12.png", "figure-12-fading.png")


def measure(mirror: NDArray[np.float32], sight: Sight, scene: Scene) -> list[Measurement]:
    """What the paper's sentences ask of the mirrored component, linear RGB [row, column, 3]."""
    lamp = LampImage.of(mirror, sight)
    distance_mm, contrast = fading(mirror, sight, scene.table.check_mm)
    known = np.flatnonzero(np.isfinite(contrast))
    near, far = (known[0], known[-1]) if known.size else (0, 0)
    steps = np.diff(contrast[known])
    pixel_deg = np.degrees(1 / sight.circle.radius_px)
    return [
        Measurement(
            "peak of the lamp's image, over white facing the lamp",
            lamp.peak / (scene.camera.exposure * scene.lamps[0].intensity),
            "",
            1.0,
        ),
        Measurement("half width of the lamp's image", lamp.half_width_deg, "deg", None, 15.0),
        Measurement(
            "width of its edge, 90 % to 10 %, of the surface's normal",
            lamp.edge_deg,
            "deg",
            1.0,
            20.0,
        ),
        Measurement(
            "the same edge in pixels at the pearl's middle", lamp.edge_deg / pixel_deg, "px", 1.5
        ),
        Measurement(
            f"contrast of the mirrored table {distance_mm[near]:.0f} mm away",
            float(contrast[near]),
            "",
            0.3,
        ),
        Measurement(
            f"contrast {distance_mm[far]:.0f} mm away, over that",
            float(contrast[far] / contrast[near]),
            "",
            None,
            0.7,
        ),
        Measurement(
            "largest rise of contrast from one distance to the next",
            float(steps.max()) if steps.size else float("nan"),
            "",
            None,
            0.0,
        ),
    ]


def exhibit(folder: Path, pictures: Pictures) -> Exhibit:
    """Save the component and the diagram in `folder`, and measure them."""
    path, curve = (folder / name for name in FILES)
    component, gain = alone(pictures.smooth, "mirror", share=0.97)
    component.save(path)
    mirror, scene = pictures.smooth.layers["mirror"], pictures.scene
    _draw(
        curve,
        *fading(mirror, pictures.sight, scene.table.check_mm),
        pictures.pearl.surface.falloff_mm,
    )
    return Exhibit(
        "12",
        "映り込み成分",
        "A mirroring image.",
        [
            Quotation(
                "まず光源に対してはTorrance-Sparrow model[19]を用いた。",
                "For the light source the Torrance-Sparrow model was used.",
                "4.2",
            ),
            Quotation(
                "また周辺物の映り込みにはレイトレーシングの手法を用い、真珠表面と物体までの距離による光の減衰効果も与えた。"
                "図12に光源とテーブルが映り込んだ画像の例を示す。",
                "The surroundings were mirrored by ray tracing, with an attenuation of light by the "
                "distance between the surface of the pearl and the object. Figure 12 shows an example "
                "in which the light source and a table are mirrored.",
                "4.2",
            ),
        ],
        [
            Plate(
                path,
                "The lamp's image with a soft edge, and a checkered table bent around the lower "
                "half of the ball, on black.",
            ),
            Plate(
                curve,
                "Contrast of the mirrored squares against distance: it falls, near the dashed "
                "exponential.",
            ),
        ],
        measure(mirror, pictures.sight, scene),
        "nacreous render paper --set grain=0 -o layers.exr, layer mirror",
        [
            f"Light shown times {gain:g}; the lamp's image is far brighter than the screen can show.",
            "Contrast is (light − dark) / (light + dark) of the squares, with shading and shadow fitted "
            "away. Beyond some 30 mm the squares are finer than the picture.",
        ],
    )


def _draw(path: Path, distance_mm: Array, contrast: Array, falloff_mm: float) -> None:
    known = np.isfinite(contrast)
    with figure(path, width_in=6.0, height_in=3.0) as axes:
        axes.plot(distance_mm[known], contrast[known], "o-", color="#335c81", label="measured")
        if known.any():
            along = np.linspace(0.0, float(distance_mm[known].max()), 100)
            first = np.flatnonzero(known)[0]
            start = contrast[first] * np.exp(distance_mm[first] / falloff_mm)
            label = f"exp(−distance / {falloff_mm:g} mm)"
            axes.plot(
                along, start * np.exp(-along / falloff_mm), "--", color="#999999", label=label
            )
        axes.set(ylim=(0, None), xlim=(0, None))
        axes.set_xlabel("distance from the pearl's surface to the table, mm")
        axes.set_ylabel("contrast of the squares")
        axes.legend()
