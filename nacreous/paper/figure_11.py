"""Figure 11: the diffuse component."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from nacreous import colour
from nacreous.image import Image
from nacreous.linear_light import luminance
from nacreous.paper.component import alone
from nacreous.paper.exhibit import Exhibit, Plate
from nacreous.paper.measurement import Measurement
from nacreous.paper.pictures import Pictures
from nacreous.paper.sight import Sight, direction_of

__all__ = ["FILES", "exhibit", "measure"]

Array = NDArray[np.float64]

FILES = ("figure-11.png",)
#: Luminance at which the chroma of two components is compared.
_LUMINANCE = 0.4


def measure(
    picture: Image, lamps: list[NDArray[np.float32]], sight: Sight, lamp: Array
) -> list[Measurement]:
    """What the paper's sentence asks of the diffuse component.

    lamp: unit vector towards the lamp of `picture`. lamps: diffuse layers [row, column, 3], the
    first with that lamp and the others with it elsewhere.
    """
    whole = picture.layers["coverage"][..., 0] == 1
    diffuse, rings = (
        picture.layers[part][whole].astype(np.float64) for part in ("diffuse", "interference")
    )
    light = luminance(diffuse)
    lambert = _correlation(light, np.maximum(sight.normal[whole] @ lamp, 0.0))
    pale = _chroma(diffuse) / max(_chroma(rings), 1e-12)
    moved = min(float(np.abs(other - lamps[0]).max()) for other in lamps[1:])
    change = moved / max(float(lamps[0].max()), 1e-12)
    return [
        Measurement("correlation with the cosine towards the lamp (Lambert)", lambert, least=0.9),
        Measurement("spread of hue over the disc", _hue_spread_deg(diffuse), "°", most=10.0),
        Measurement("chroma over that of figure 10, equally bright", pale, most=0.5),
        Measurement("least change when the lamp moves, over the brightest", change, least=0.1),
    ]


def exhibit(folder: Path, pictures: Pictures) -> Exhibit:
    """Save the component in `folder` and measure it."""
    path = folder / FILES[0]
    component, gain = alone(pictures.smooth, "diffuse")
    component.save(path)
    layers = [picture.layers["diffuse"] for picture in pictures.lamps]
    lamp = direction_of(pictures.scene.lamps[0])
    return Exhibit(
        "11",
        [Plate(path)],
        measure(pictures.smooth, layers, pictures.sight, lamp),
        "nacreous render paper --set grain=0 -o layers.exr (layer diffuse)",
        [
            f"The component is shown {gain:g} times as bright as in figure 14 (a). The body "
            f"colour, {pictures.pearl.body_colour}, is (ours).",
            "Unlike the component of figure 10, this one moves with the lamp.",
        ],
    )


def _correlation(first: Array, second: Array) -> float:
    if first.size < 2 or not (first.std() > 0 and second.std() > 0):
        return float("nan")
    return float(np.corrcoef(first, second)[0, 1])


def _hue_spread_deg(rgb: Array) -> float:
    """Circular standard deviation of Munsell hue, weighted by chroma."""
    hue, _, chroma = np.moveaxis(colour.hvc_from_rgb(rgb), -1, 0)
    length = np.abs(np.sum(chroma * np.exp(1j * hue))) / max(float(chroma.sum()), 1e-12)
    return float(np.degrees(np.sqrt(-2 * np.log(np.clip(length, 1e-12, 1.0)))))


def _chroma(rgb: Array) -> float:
    """Mean Munsell chroma of colours [n, 3], all brought to one luminance."""
    even = rgb * (_LUMINANCE / np.maximum(luminance(rgb), 1e-6))[:, None]
    return float(colour.hvc_from_rgb(even)[..., 2].mean())
