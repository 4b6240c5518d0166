"""Pearls of the trade among the presets: they load, render, and have the colour of their name."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

import nacreous as nc
from nacreous.nacre import stack_of
from nacreous.spec import Camera, Pearl, Scene, preset

#: Of each pearl: its pigment, and the nacre that the trade expects, mm.
PEARLS = {
    "south-sea-gold": ("gold", 2.0),
    "south-sea-white": ("white", 2.0),
    "tahitian": ("black-lip", 1.0),
    "akoya-cream": ("cream", 0.4),
    "akoya-pink": ("pink", 0.4),
    "akoya-dyed-blue": ("dyed-blue", 0.4),
    "akoya-thin": ("white", 0.1),
}


def nacre_mm(pearl: Pearl) -> float:
    own = pearl.body.nacre_mm
    return 1e-3 * stack_of(pearl).total_um if own is None else own


def lab(name: str) -> NDArray[np.float64]:
    """Mean colour of the whole pearl, against a white matt ball in the same light."""
    pearl = Pearl.load(name)
    scene = Scene(
        camera=Camera(field_mm=1.2 * pearl.diameter_mm),
        table={"kind": "none"},
        lamps=[],
        sky={"kind": "constant", "intensity": 1.0},
    )
    image = nc.render(pearl, scene, 32, 4)
    mean = image.linear[image.layers["coverage"][..., 0] == 1].mean(axis=0, dtype=float)
    return nc.colour.lab_from_xyz(nc.colour.xyz_from_rgb(mean), nc.colour.xyz_from_rgb([1, 1, 1]))


@pytest.mark.parametrize("name", PEARLS)
def test_each_has_the_pigment_and_the_nacre_of_its_kind(name: str) -> None:
    pearl = Pearl.load(name)
    pigment, expected_mm = PEARLS[name]
    assert pearl.body.pigment == pigment
    assert nacre_mm(pearl) == pytest.approx(expected_mm, rel=0.06)
    assert pearl.model == "transport"


@pytest.mark.parametrize("name", ["south-sea-gold", "south-sea-white", "tahitian"])
def test_what_no_source_gives_is_said_to_be_unverified(name: str) -> None:
    assert "NOT VERIFIED: the mean of the tablets." in preset.text("pearl", name)


def test_each_looks_like_its_name() -> None:
    """In an even white light from all sides, mirrored light and all."""
    seen = {name: lab(name) for name in PEARLS}
    assert all(np.all(np.isfinite(colour)) for colour in seen.values())
    lightness, red, yellow = ({name: colour[i] for name, colour in seen.items()} for i in range(3))
    assert min(lightness, key=lambda name: lightness[name]) == "tahitian"
    assert max(lightness, key=lambda name: lightness[name]) == "south-sea-white"
    assert max(yellow, key=lambda name: yellow[name]) == "south-sea-gold"
    assert min(yellow, key=lambda name: yellow[name]) == "akoya-dyed-blue"
    assert yellow["south-sea-gold"] > 15
    assert yellow["akoya-dyed-blue"] < -12
    assert red["akoya-pink"] > red["akoya-cream"]
    assert yellow["akoya-cream"] > yellow["akoya-pink"] + 3
    assert abs(yellow["south-sea-white"]) < 5


def test_the_nucleus_shows_through_thin_nacre_and_not_through_thick() -> None:
    """What it does to the body's reflectance whether the nucleus is light or dark."""

    def contrast(name: str) -> float:
        pearl = Pearl.load(name)
        black, white = (
            nc.body.reflectance_of_body(
                pearl.replace(body=pearl.body.replace(nucleus=colour)),
                nacre_mm(pearl),
            )
            for colour in ("#000000", "#ffffff")
        )
        return float(np.mean(white - black))

    assert contrast("akoya-thin") > 0.6
    assert contrast("akoya-cream") < 0.5
    assert contrast("south-sea-gold") < 0.1
