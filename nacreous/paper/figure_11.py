"""Figure 11: the diffuse component."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from nacreous import colour
from nacreous.image import Image
from nacreous.paper.component import alone
from nacreous.paper.exhibit import Exhibit, Plate, Quotation
from nacreous.paper.lamp_image import luminance
from nacreous.paper.measurement import Measurement
from nacreous.paper.pictures import Pictures
from nacreous.paper.sight import Sight, direction_of

__all__ = ["exhibit", "measure"]

Array = NDArray[np.float64]

FILES = ("figure-11.png",)


def measure(picture: Image, others: list[Image], sight: Sight, lamp: Array) -> list[Measurement]:
    """What the paper's sentence asks of the diffuse component.

    others: pictures of which the first has the lamp where `picture` has it, unit vector `lamp`, and
    the rest elsewhere.
    """
    whole = picture.layers["coverage"][..., 0] == 1
    diffuse = picture.layers["diffuse"][whole].astype(np.float64)
    light = luminance(diffuse)
    facing = np.maximum(sight.normal[whole] @ lamp, 0.0)
    moved = [
        np.abs(other.layers["diffuse"] - others[0].layers["diffuse"]).max() for other in others[1:]
    ]
    return [
        Measurement(
            "luminance against the cosine of the lamp's incidence (Lambert), correlation",
            _correlation(light, facing),
            "",
            0.9,
        ),
        Measurement(
            "arc of hue over the disc, chroma-weighted standard deviation",
            _hue_spread_deg(diffuse),
            "deg",
            None,
            10.0,
        ),
        Measurement(
            "chroma over that of the interference component at equal luminance",
            _relative_chroma(picture, whole),
            "",
            None,
            0.5,
        ),
        Measurement(
            "least change over the brightest, when the lamp moves",
            float(min(moved) / light.max()),
            "",
            0.1,
        ),
    ]


def exhibit(folder: Path, pictures: Pictures) -> Exhibit:
    """Save the component in `folder` and measure it."""
    path = folder / FILES[0]
    component, gain = alone(pictures.smooth, "diffuse")
    component.save(path)
    lamp = direction_of(pictures.scene.lamps[0])
    return Exhibit(
        "11",
        "拡散光成分",
        "A diffuse image.",
        [
            Quotation(
                "従って、拡散反射光を真珠の物体色を用いて計算し、干渉光との混合比率を変化させることによって、深み感を表現する。",
                "Diffusely reflected light is therefore computed with the body colour of the pearl, and "
                "depth is expressed by changing the ratio in which it is mixed with the interference "
                "light.",
                "4.1",
            )
        ],
        [Plate(path, "A matt ball in one pale body colour, lit from the upper left, on black.")],
        measure(pictures.smooth, pictures.lamps, pictures.sight, lamp),
        "nacreous render paper --set grain=0 -o layers.exr, layer diffuse",
        [
            f"Light shown times {gain:g}. Body colour {pictures.pearl.body_colour} (ours).",
            "Unlike figure 10 it moves with the lamp.",
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


def _relative_chroma(picture: Image, whole: NDArray[np.bool_]) -> float:
    """Mean chroma of the diffuse over that of the interference component, both at luminance 0.4."""
    chroma = []
    for part in ("diffuse", "interference"):
        rgb = picture.layers[part][whole].astype(np.float64)
        even = rgb * (0.4 / np.maximum(luminance(rgb), 1e-6))[:, None]
        chroma.append(float(colour.hvc_from_rgb(even)[..., 2].mean()))
    return chroma[0] / max(chroma[1], 1e-12)
