"""No number leaves the picture that is not one, whatever the spec."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import nacreous as nc
from nacreous.spec import (
    Camera,
    Interference,
    Lamp,
    Layers,
    Pearl,
    Scene,
    Sky,
    Surface,
    Table,
    Texture,
    Walls,
)
from tests.picture.stage import (
    BLACK,
    LEFT,
    NO_TABLE,
    pearl,
    refusal,
)


def lamps(count: int) -> list[Lamp]:
    return [
        Lamp(azimuth_deg=23.0 * i - 180, elevation_deg=11.0 * i - 85, angular_radius_deg=0.05 + i)
        for i in range(count)
    ]


EXTREMES: dict[str, tuple[dict[str, Any], dict[str, Any]]] = {
    "all knobs 0": ({"depth": 0.0, "shininess": 0.0, "grain": 0.0}, {}),
    "all knobs 1": ({"depth": 1.0, "shininess": 1.0, "grain": 1.0}, {}),
    "weights beyond the knob": ({"texture": Texture(hue_weight=10, chroma_weight=10)}, {}),
    "no lamps, black sky": ({}, {"lamps": [], "sky": BLACK}),
    "nothing at all": ({"body_colour": "#000000"}, {"lamps": [], "sky": BLACK, "table": NO_TABLE}),
    "sixteen lamps": ({"shininess": 1.0}, {"lamps": lamps(16)}),
    "broad lamps": ({}, {"lamps": [Lamp(position_mm=(20.1, 0, 0), angular_radius_deg=30)]}),
    "lamp behind": ({}, {"lamps": [Lamp(azimuth_deg=180, elevation_deg=-12)]}),
    "lamp below": ({}, {"lamps": [Lamp(azimuth_deg=0, elevation_deg=-90)]}),
    "blinding": (
        {"shininess": 1.0},
        {
            "lamps": [Lamp(azimuth_deg=0, elevation_deg=12, intensity=1e6)],
            "sky": Sky(intensity=1e6),
        },
    ),
    "candle seen as white by day": (
        {},
        {
            "lamps": [LEFT.replace(spectrum="1000K")],
            "camera": Camera(white="25000K"),
        },
    ),
    "no coherence": ({"interference": Interference(coherence_nm=0)}, {}),
    "endless coherence": ({"interference": Interference(coherence_nm=1e6, threshold=0)}, {}),
    "all light lost": ({"interference": Interference(diffuse_loss=0.9, mixing=1)}, {}),
    "one thin layer": ({"nacre": Layers(thickness_nm=[1.0])}, {}),
    "one thick layer": ({"nacre": Layers(thickness_nm=[1e5], protein_nm=200)}, {}),
    "no difference in index": ({"nacre": Layers(thickness_nm=[400], protein=1.53)}, {}),
    "nacre of air": ({"nacre": Layers(thickness_nm=[400] * 9, aragonite=1, protein=1)}, {}),
    "dense nacre": ({"nacre": Layers(thickness_nm=[400] * 9, aragonite=10, protein=1)}, {}),
    "table none": ({}, {"table": NO_TABLE}),
    "cloth finer than a pixel": ({}, {"table": Table(kind="cloth", weave_mm=0.05)}),
    "checker finer than a pixel": ({}, {"table": Table(check_mm=0.1)}),
    "walls": ({}, {"walls": Walls(half_width_mm=20, height_mm=1)}),
    "tall walls": ({}, {"walls": Walls(half_width_mm=20, height_mm=100_000)}),
    "from 20 mm": (
        {"diameter_mm": 30},
        {"camera": Camera(projection="perspective", distance_mm=20)},
    ),
    "from below the table": ({}, {"camera": Camera(elevation_deg=-80)}),
    "from above": ({}, {"camera": Camera(elevation_deg=89, projection="perspective")}),
    "along the table": ({}, {"camera": Camera(elevation_deg=0)}),
    "tiny": ({"diameter_mm": 1}, {"camera": Camera(field_mm=10_000)}),
    "nothing but nacre": ({"diameter_mm": 30}, {"camera": Camera(field_mm=0.1)}),
    "satin": ({"surface": Surface(facet_spread_rad=0.6, falloff_mm=0.1)}, {}),
    "glass": ({"surface": Surface(facet_spread_rad=0.005, layer_reflectance=0.9)}, {}),
    "ten degrees": ({}, {"observer": "1964-10"}),
}


@pytest.mark.parametrize("case", EXTREMES)
def test_no_spec_makes_a_number_that_is_not_finite(case: str, tmp_path: Path) -> None:
    of_pearl, of_scene = EXTREMES[case]
    scene = Scene(**{"lamps": [LEFT], **of_scene})
    image = nc.render(pearl(**{"grain": 0.5, **of_pearl}), scene, 17, 4)
    for name, layer in {"linear": image.linear, **image.layers}.items():
        assert np.all(np.isfinite(layer)), name
    assert image.layers["coverage"].min() >= 0
    assert image.layers["coverage"].max() <= 1 + 1e-6
    image.save(tmp_path / "a.png", bits=16)
    image.save(tmp_path / "a.exr")


def test_what_is_lit_by_nothing_is_black() -> None:
    scene = Scene(lamps=[], sky=BLACK)
    assert not nc.render(pearl(), scene, 16, 4).linear.any()


@pytest.mark.parametrize(
    ("nacre", "message"),
    [
        (Layers(thickness_nm=[400], aragonite=(1.53, 0.1)), "Pearl: nacre.aragonite is [1.53, 0.1"),
        (Layers(thickness_nm=[400], protein=0.9), "protein has n = 0.9; allowed: at least"),
    ],
)
def test_nacre_that_the_model_has_no_answer_for_is_refused(nacre: Layers, message: str) -> None:
    assert refusal(lambda: nc.render(pearl(nacre=nacre), "paper", 8, 1)).startswith(message)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"size": 0}, "size is 0; allowed: a whole number from 1 to 8192"),
        ({"size": -1}, "size is -1; "),
        ({"size": 8193}, "size is 8193; "),
        ({"size": 10**30}, "size is 1000000000000"),
        ({"size": 64.0}, "size is 64.0; "),
        ({"size": True}, "size is True; "),
        ({"samples": 0}, "samples is 0; allowed: a square number from 1 to 1024, such as 16"),
        ({"samples": 10}, "samples is 10; "),
        ({"samples": 1089}, "samples is 1089; "),
        ({"samples": 4.0}, "samples is 4.0; "),
        ({"pearl": "papre"}, '"papre" is neither a file nor a pearl preset; did you mean paper?'),
        ({"pearl": None}, "pearl is None; allowed: a pearl, a file or a preset's name"),
        ({"scene": Pearl()}, "scene is Pearl("),
        ({"scene": "akoya-r"}, '"akoya-r" is a pearl preset; wanted: a scene file or preset'),
    ],
    ids=lambda case: str(case)[:40],
)
def test_render_says_what_is_wrong(arguments: dict[str, Any], message: str) -> None:
    assert refusal(lambda: nc.render(**{"size": 8, "samples": 1, **arguments})).startswith(message)
