"""Colour families in the Aurora viewer: light let through above, mirrored below, in rings."""

from __future__ import annotations

from functools import cache
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import nacreous as nc
from nacreous.spec import Pearl
from tests.picture.rings import fan, rings

Array = NDArray[np.float64]

FAMILIES = ("r", "rg", "g")
STEPS = ("1.0", "0.7", "0.4", "0.0")
#: Chroma below which hue says nothing.
GREY = 3.0
#: Of 16 rings of equal width, the centre at 4 to 7 degrees and the rim at 61 to 70.
RINGS, CENTRE, RIM = 16, 1, 14


@cache
def picture(name: str, body: str = "colourless") -> Any:
    """A pearl in the Aurora viewer without grain, 64 pixels in radius."""
    given: list[tuple[str, object]] = [("grain", 0.0)]
    if body == "colourless":
        given += [("body.pigment", "none"), ("body.nucleus", "#ffffff")]
    return nc.render(Pearl.load(name, given), "aurora", size=192)


def vivid(family: str) -> Any:
    return picture(f"akoya-{family}-1.0")


def part(image: Any, name: str) -> Any:
    """One layer of a picture, as a picture."""
    return SimpleNamespace(linear=image.layers[name], layers=image.layers)


def apart(first: Array, second: Array) -> Array:
    """How far hues lie apart, 0 to 180 degrees."""
    found: Array = np.abs((first - second + 180.0) % 360.0 - 180.0)
    return found


def ab(ring: Array) -> Array:
    hue_rad = np.radians(ring[..., 0])
    return ring[..., 1:2] * np.stack([np.cos(hue_rad), np.sin(hue_rad)], axis=-1)


def letters(hue_deg: float, chroma: float) -> str:
    """Munsell's hue letters of a CIE Lab hue and chroma at Y = 1."""
    a, b = ab(np.array([hue_deg, chroma]))
    xyz = nc.colour.xyz_from_lab([100.0, a, b], nc.colour.white_xyz("D65"))
    hvc = nc.colour.hvc_from_rgb(nc.colour.rgb_from_xyz(0.8 * xyz))
    return str(nc.colour.munsell_notation(hvc)).split(" ")[0].lstrip(".0123456789")


# --- two halves ---------------------------------------------------------------------------------


@pytest.mark.parametrize("family", FAMILIES)
def test_halves_have_opposite_hues(family: str) -> None:
    """T and R = 1 - T, if the body takes nothing away.

    The innermost ring does not count: there the normal is level, and the lobe of the facets sees
    the plate, its edge and the dark box at once, so the halves meet.
    """
    upper, lower = (half[1:] for half in rings(vivid(family), 8))
    counts = (upper[:, 1] > GREY) & (lower[:, 1] > GREY)
    assert counts.sum() >= 3
    assert apart(upper[:, 0], lower[:, 0] + 180.0)[counts].max() < 15.0


@pytest.mark.parametrize("family", FAMILIES)
def test_the_upper_half_lives_by_transmitted_light_alone(family: str) -> None:
    """The box is black, so the film mirrors nothing there: all colour is colour let through."""
    image = vivid(family)
    box = nc.colour.xyz_from_rgb(image.layers["surroundings"].astype(float))[..., 1].max()
    upper, lower = (half[1:] for half in rings(image, 8))
    assert upper[:, 2].min() > 15 * box
    assert np.all(upper[:, 2] < lower[:, 2])
    assert upper[:, 1].max() > 15
    mirrored = [half[1:, 2] for half in rings(part(image, "mirror"), 8)]
    assert np.all(mirrored[0] < 0.02 * upper[:, 2])
    assert mirrored[1].min() > 0.1


# --- rings --------------------------------------------------------------------------------------


@pytest.mark.parametrize("family", FAMILIES)
def test_rings_are_concentric(family: str) -> None:
    """Along a ring the colour stays, though the light does not."""
    parts = fan(vivid(family), 12)[1:]
    off = np.linalg.norm(ab(parts) - ab(parts).mean(axis=1, keepdims=True), axis=-1)
    assert off.max() < 2.5
    middle = parts[:, 2:3]
    clear = parts[..., 1].min(axis=1) > 10
    assert clear.sum() >= 6
    assert apart(parts[..., 0], middle[..., 0])[clear].max() < 10.0
    assert np.all(parts[3:, [0, -1], 2] > 1.1 * parts[3:, 2:3, 2])


@pytest.mark.parametrize("family", FAMILIES)
def test_rings_pass_smoothly_into_one_another(family: str) -> None:
    """Without jumps of hue or of colour, but a long way from centre to rim."""
    upper, _ = rings(vivid(family), 20)
    upper = upper[1:-1]
    assert apart(upper[1:, 0], upper[:-1, 0]).max() < 40.0
    steps = np.linalg.norm(np.diff(ab(upper), axis=0), axis=-1)
    assert steps.max() < 8.0
    assert upper[:, 1].min() > GREY
    assert steps.sum() > 20.0


# --- the trade's words --------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("family", "centre", "rim"),
    [("r", {"R", "RP"}, {"Y", "GY"}), ("rg", {"BG"}, {"RP"}), ("g", {"G"}, {"RP"})],
)
def test_vivid_masters_show_the_words_above(family: str, centre: set[str], rim: set[str]) -> None:
    upper, _ = rings(vivid(family), RINGS)
    assert letters(*upper[CENTRE, :2]) in centre
    assert letters(*upper[RIM, :2]) in rim


def test_g_of_reported_tablets_shows_the_words_below() -> None:
    """What docs/families.md leaves open: at 440 nm the words are those of reflected light."""
    upper, lower = rings(picture("akoya-g-published", body="own"), RINGS)
    assert [letters(*upper[at, :2]) for at in (CENTRE, RIM)] == ["R", "GY"]
    assert [letters(*lower[at, :2]) for at in (CENTRE, RIM)] == ["G", "RP"]


@pytest.mark.parametrize("family", FAMILIES)
def test_steps_have_1_and_0_7_and_0_4_and_no_chroma_above(family: str) -> None:
    found = [rings(picture(f"akoya-{family}-{step}"), RINGS)[0][CENTRE, 1] for step in STEPS]
    assert np.array(found[:3]) / found[0] == pytest.approx([1.0, 0.7, 0.4], abs=0.06)
    assert found[3] < 0.2 * found[0]


@pytest.mark.parametrize("family", FAMILIES)
def test_the_body_adds_its_own_yellow_to_the_steps(family: str) -> None:
    """With a white body step 0.0 is not grey; with the body's light as white it is again."""
    image = picture(f"akoya-{family}-0.0", body="own")
    seen, _ = rings(image, RINGS)
    own, _ = rings(part(image, "diffuse"), RINGS)
    assert seen[CENTRE, 1] > GREY
    assert np.linalg.norm(ab(seen[CENTRE]) - ab(own[CENTRE])) < GREY
