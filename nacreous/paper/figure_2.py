"""Figure 2: seven crops of figure 14 (d), numbered from the centre outward."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from nacreous import colour
from nacreous.figure import figure
from nacreous.image import Image
from nacreous.paper import hue
from nacreous.paper.circle import Circle
from nacreous.paper.component import seen
from nacreous.paper.crop import COUNT, Crop, seven
from nacreous.paper.cutting import save
from nacreous.paper.exhibit import Exhibit, Plate, Quotation
from nacreous.paper.lamp_image import LampImage
from nacreous.paper.measurement import Measurement
from nacreous.paper.pictures import Pictures
from nacreous.paper.sight import Sight

__all__ = ["exhibit", "measure"]

Array = NDArray[np.float64]

_MAP = "figure-2-map.png"
FILES = (_MAP, *(f"figure-2-crop-{number}.png" for number in range(1, COUNT + 1)))


def measure(picture: Image, crops: list[Crop], sight: Sight) -> list[Measurement]:
    """What the findings of section 2.2 ask of the crops of a rendered picture."""
    lamp = LampImage.of(picture.layers["mirror"], sight).inside
    shares = [float(crop.of(lamp).mean()) for crop in crops]
    outside = [float(1 - crop.of(picture.layers["coverage"]).mean()) for crop in crops]
    arcs = [_arc_deg(picture, crop) for crop in crops]
    away = [_away(crop, sight.circle) for crop in crops]
    plain = max(shares[2], shares[3])
    return [
        Measurement("lamp's image in crop 1, share of its pixels", shares[0], "", 0.15),
        Measurement(
            "its lead over that share in any other crop", shares[0] - max(shares[1:]), "", 0.0
        ),
        Measurement("lamp's image in crop 2", shares[1], "", 0.02),
        Measurement("arc of interference hue in crop 2", arcs[1], "deg", 36.0),
        Measurement("lamp's image in crops 3 and 4, the larger", plain, "", None, 0.0),
        Measurement("arc of interference hue in crop 4", arcs[3], "deg"),
        Measurement("surroundings in crops 1 to 4, the most", max(outside[:4]), "", None, 0.0),
        Measurement("surroundings in crop 5", outside[4], "", 0.05),
        Measurement(
            "least gain of surroundings from crop 5 to 6 to 7",
            float(np.diff(outside[4:]).min()),
            "",
            0.05,
        ),
        Measurement(
            "least step outward from one crop to the next, in radii",
            float(np.diff(away).min()),
            "",
            0.0,
        ),
    ]


def exhibit(folder: Path, pictures: Pictures) -> Exhibit:
    """Save the crops and the map in `folder`, and measure them."""
    picture, circle = pictures.grained, pictures.sight.circle
    codes, _ = picture.develop()
    # What the file holds, so that `nacreous crops` finds the same places in it.
    crops = seven(colour.decode(codes / 255.0), circle)
    texts = {f"nacreous:{name}": text for name, text in picture.recipe.items()}
    paths = save(folder, codes, crops, texts, "figure-2-crop-")
    _draw(folder / _MAP, picture, crops)
    return Exhibit(
        "2",
        "部分写真と切出し位置",
        "Subregions of a picture of a pearl and their locations.",
        _QUOTATIONS,
        [
            Plate(folder / _MAP, "The pearl of figure 14 (d) with seven numbered squares."),
            *(
                Plate(path, alt, str(crop.number), small=True)
                for path, crop, alt in zip(paths, crops, _ALTS, strict=True)
            ),
        ],
        measure(picture, crops, pictures.sight),
        "nacreous crops figure-14d.png",
        [
            "The photograph of figure 2 is not at hand: the places are (ours), chosen after what "
            "section 2.2 says of each crop. Numbers count from the centre outward.",
            f"Each crop is {crops[0].side_px} × {crops[0].side_px} pixels; the paper's patches have 64 × 64.",
        ],
    )


def _arc_deg(picture: Image, crop: Crop) -> float:
    rgb = crop.of(picture.layers["interference"]).astype(np.float64)
    return hue.span_deg(rgb[crop.of(picture.layers["coverage"][..., 0]) == 1])


def _away(crop: Crop, circle: Circle) -> float:
    """Distance of the crop's middle from the pearl's, in radii."""
    half = 0.5 * crop.side_px
    right, below = crop.left_px + half - circle.x_px, crop.top_px + half - circle.y_px
    return float(np.hypot(right, below) / circle.radius_px)


def _draw(path: Path, picture: Image, crops: list[Crop]) -> None:
    with figure(path, width_in=4.0, height_in=4.0) as axes:
        axes.imshow(
            colour.encode(seen(picture)), extent=(0, len(picture.linear), len(picture.linear), 0)
        )
        axes.set_axis_off()
        for crop in crops:
            right, low = crop.left_px + crop.side_px, crop.top_px + crop.side_px
            across = [crop.left_px, right, right, crop.left_px, crop.left_px]
            down = [crop.top_px, crop.top_px, low, low, crop.top_px]
            axes.plot(across, down, color="black", linewidth=2.4)
            axes.plot(across, down, color="white", linewidth=1.0)
            middle = (crop.left_px + 0.5 * crop.side_px, crop.top_px + 0.5 * crop.side_px)
            axes.annotate(
                str(crop.number),
                middle,
                color="white",
                ha="center",
                va="center",
                fontsize=10,
                bbox={"boxstyle": "circle", "facecolor": "black", "alpha": 0.6, "linewidth": 0},
            )


_ALTS = (
    "The lamp's image.",
    "The edge of the lamp's image and interference colours that change.",
    "Interference colours only.",
    "Interference colours only.",
    "Interference colours and a little of the outline.",
    "The outline through the middle.",
    "The outline with more surroundings than pearl.",
)

_QUOTATIONS = [
    Quotation(
        "写真1から7は、真珠の中心から外側に向けて順に番号を付けたものである。",
        "Photographs 1 to 7 are numbered in order from the centre of the pearl outward.",
        "2.2",
    ),
    Quotation(
        "全体の結果では、鏡面反射部分と、高彩度で色相変化の大きい干渉色の部分の双方を含む写真(写真2)を、最も真珠らしいと"
        "判断している。続いて干渉色部分のみの写真(写真4)、鏡面反射部分のみの写真(写真1)を、真珠らしく感じている。一方で、"
        "輪郭を含む写真(写真5,6,7)については、いずれも真珠らしさの評価が低い。",
        "Over all, the photograph that holds both specular reflection and interference colours of high "
        "chroma and strongly changing hue (2) is judged the most like a pearl. Next come the one with "
        "interference colours only (4) and the one with specular reflection only (1). Those that hold "
        "the outline (5, 6, 7) are all judged little like a pearl.",
        "2.2",
    ),
    Quotation(
        "生成画像から図2と同様の七つの部分画像を作り",
        "From the synthesised image seven partial images were made as in figure 2",
        "5.1",
    ),
]
