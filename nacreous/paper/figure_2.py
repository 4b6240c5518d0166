"""Figure 2: seven crops of figure 14 (d), numbered from the centre outward."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from nacreous import colour
from nacreous.figure import figure
from nacreous.image import Image
from nacreous.paper import hue
from nacreous.paper.component import seen
from nacreous.paper.crop import COUNT, Crop, seven
from nacreous.paper.cutting import save
from nacreous.paper.exhibit import Exhibit, Plate
from nacreous.paper.lamp_image import LampImage
from nacreous.paper.measurement import Measurement
from nacreous.paper.pictures import Pictures
from nacreous.paper.sight import Sight

__all__ = ["FILES", "exhibit", "measure"]

Array = NDArray[np.float64]

_MAP, _STEM = "figure-2-map.png", "figure-2-crop-"
FILES = (_MAP, *(f"{_STEM}{number}.png" for number in range(1, COUNT + 1)))


def measure(picture: Image, crops: list[Crop], sight: Sight) -> list[Measurement]:
    """What the findings of section 2.2 ask of the crops of a rendered picture."""
    lamp = LampImage.of(picture.layers["mirror"], sight).inside
    shares = [float(crop.of(lamp).mean()) for crop in crops]
    outside = [float(1 - crop.of(picture.layers["coverage"]).mean()) for crop in crops]
    arcs = [_arc_deg(picture, crop) for crop in crops]
    away = np.array([crop.distance(sight.circle) for crop in crops])
    gain = float(np.diff(outside[4:]).min())
    return [
        Measurement("share of the lamp's image in crop 1", shares[0], least=0.15),
        Measurement("its lead over any other crop", shares[0] - max(shares[1:]), least=0.05),
        Measurement("share of the lamp's image in crop 2", shares[1], least=0.03),
        Measurement("arc of interference hue in crop 2", arcs[1], "°", least=36.0),
        Measurement("share of the lamp's image in crops 3, 4", max(shares[2:4]), least=0, most=0),
        Measurement("arc of interference hue in crop 4", arcs[3], "°"),
        Measurement("share of surroundings in crops 1 to 4", max(outside[:4]), least=0, most=0),
        Measurement("share of surroundings in crop 5", outside[4], least=0.05),
        Measurement("its least gain from crop 5 to 6 to 7", gain, least=0.05),
        Measurement("least step outward, in radii", float(np.diff(away).min()), least=0.0),
    ]


def exhibit(folder: Path, pictures: Pictures) -> Exhibit:
    """Save the crops and the map in `folder`, and measure them."""
    picture = pictures.grained
    codes, _ = picture.develop()
    # What the file holds, so that `nacreous crops` finds the same places in it.
    crops = seven(colour.decode(codes / 255.0), pictures.sight.circle)
    texts = {f"nacreous:{name}": text for name, text in picture.recipe.items()}
    paths = save(folder, codes, crops, texts, _STEM)
    _draw(folder / _MAP, picture, crops)
    side = crops[0].side_px
    numbered = zip(paths, crops, strict=True)
    return Exhibit(
        "2",
        [
            Plate(folder / _MAP),
            *(Plate(path, str(crop.number), small=True) for path, crop in numbered),
        ],
        measure(picture, crops, pictures.sight),
        "nacreous crops figure-14d.png",
        [
            "The photograph of figure 2 is not at hand: the places are (ours), chosen after what "
            f"section 2.2 says of each crop. A crop has {side} × {side} pixels; the patches of "
            "section 4.3 have 64 × 64.",
        ],
    )


def _arc_deg(picture: Image, crop: Crop) -> float:
    rgb = crop.of(picture.layers["interference"]).astype(np.float64)
    return hue.span_deg(rgb[crop.of(picture.layers["coverage"][..., 0]) == 1])


def _draw(path: Path, picture: Image, crops: list[Crop]) -> None:
    size = len(picture.linear)
    with figure(path, width_in=4.0, height_in=4.0) as axes:
        axes.imshow(colour.encode(seen(picture)), extent=(0, size, size, 0))
        axes.set_axis_off()
        for crop in crops:
            right, low = crop.left_px + crop.side_px, crop.top_px + crop.side_px
            across = [crop.left_px, right, right, crop.left_px, crop.left_px]
            down = [crop.top_px, crop.top_px, low, low, crop.top_px]
            axes.plot(across, down, color="black", linewidth=2.4)
            axes.plot(across, down, color="white", linewidth=1.0)
            corner = (crop.left_px + 0.12 * crop.side_px, crop.top_px + 0.17 * crop.side_px)
            axes.annotate(str(crop.number), corner, color="white", ha="center", va="center", **_BOX)


#: A number that can be read on light and on dark.
_BOX = {"fontsize": 8, "bbox": {"boxstyle": "round,pad=0.2", "facecolor": "black", "alpha": 0.6}}
