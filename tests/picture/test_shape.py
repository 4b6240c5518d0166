"""What makes a pearl other than round: its silhouette, its hole, its rest, and its keys."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import nacreous as nc
from nacreous.spec import Pearl, Scene

Array = NDArray[np.float64]

#: From far away, level, so that outlines are those of parallel light.
FIELD_MM = 14.0
FAR = Scene(
    table={"kind": "none"},
    sky={"kind": "constant", "intensity": 1.0},
    camera={"elevation_deg": 0.0, "distance_mm": 5000.0, "field_mm": FIELD_MM},
)
UPRIGHT = {"tilt_deg": 0.0}


def picture(scene: Any = FAR, size: int = 64, samples: int = 4, **pearl: Any) -> nc.Image:
    pearl.setdefault("nacre", {"preset": "akoya-rg-1.0"})
    return nc.render(Pearl(**{"grain": 0.0} | pearl), scene, size=size, samples=samples)


def silhouette(size: int = 96, **pearl: Any) -> Array:
    """The share of each pixel that the pearl covers."""
    coverage = picture(size=size, samples=1, **pearl).layers["coverage"]
    return np.asarray(coverage[..., 0], float)


def extents_mm(covered: Array) -> tuple[float, float]:
    """Width and height, by the pixels that the middle row and the middle column cover.

    The middle is that of the pearl's mass, which lies on the axis of a figure of revolution.
    """
    rows, columns = covered.sum(axis=1), covered.sum(axis=0)
    per_px = FIELD_MM / len(covered)
    return float(rows.max() * per_px), float(columns.max() * per_px)


def test_an_ovals_silhouette_has_the_axes_that_were_asked_for() -> None:
    width, height = extents_mm(silhouette(shape={"length": 1.3}, pose=UPRIGHT))
    assert width == pytest.approx(8.0, abs=0.03)
    assert height == pytest.approx(1.3 * 8.0, abs=0.03)


@pytest.mark.parametrize("out_of_round", [0.03, 0.1])
def test_a_near_rounds_diameters_vary_as_asked_for(out_of_round: float) -> None:
    towards_eye = {"tilt_deg": 90.0}
    width, height = extents_mm(silhouette(shape={"out_of_round": out_of_round}, pose=towards_eye))
    assert abs(width - height) / 8.0 == pytest.approx(out_of_round, abs=0.003)
    assert 0.5 * (width + height) == pytest.approx(8.0, abs=0.03)


def test_a_drop_is_narrower_at_one_end_and_an_oval_is_not() -> None:
    def ends_mm(**shape: float) -> tuple[float, float]:
        rows = silhouette(shape={"length": 1.35, **shape}, pose=UPRIGHT).sum(axis=1)
        filled = np.flatnonzero(rows > 0.5)
        quarter = (filled[-1] - filled[0]) // 4
        return rows[filled[0] + quarter], rows[filled[-1] - quarter]

    top, bottom = ends_mm(taper=0.6)
    assert top < 0.75 * bottom
    top, bottom = ends_mm()
    assert top == pytest.approx(bottom, rel=0.02)


def test_a_hole_is_dark_as_wide_as_drilled_and_nowhere_else() -> None:
    towards_eye = {"tilt_deg": 90.0}

    def light(drill_mm: float) -> Array:
        shape = {"drill_mm": drill_mm, "drill_wear_mm": 0.0}
        shown = picture(size=96, pose=towards_eye, shape=shape)
        return nc.colour.xyz_from_rgb(shown.linear)[..., 1]

    whole, drilled = light(0.0), light(2.0)
    middle = slice(40, 56)
    dark = 1 - (drilled / whole)[middle, middle]
    assert dark.max() > 0.8
    # A hole lets out little: what is gone, over what is gone at its darkest, is its area.
    area_mm2 = (dark / dark.max()).sum() * (FIELD_MM / 96) ** 2
    assert area_mm2 == pytest.approx(np.pi, rel=0.05)
    beside = np.ones_like(whole, bool)
    beside[34:62, 34:62] = False
    assert abs(drilled - whole)[beside].max() < 0.01


@pytest.mark.parametrize("scene", ["north-window-black", "paper"])
def test_a_form_that_is_all_but_round_looks_as_the_ball_does(scene: str) -> None:
    codes = [
        picture(scene, grain=0.4, shape={"length": length}).develop()[0].astype(int)
        for length in (1.0, 1.0000001)
    ]
    assert abs(codes[0] - codes[1]).max() <= 2


def test_more_samples_show_the_same_colours_of_a_pearl_that_hides_parts_of_itself() -> None:
    pearl = Pearl.load("south-sea-white", [("shape.length", "0.74"), ("shape.flattening", "0.8")])
    fine, coarse = (
        nc.render(pearl, "north-window-white", size=64, samples=samples).linear[26:50, 20:44]
        for samples in (16, 9)
    )
    assert abs(fine - coarse).mean(axis=(0, 1)).max() < 0.002


def test_a_whole_turn_changes_nothing() -> None:
    def seen(degrees: float) -> Array:
        shape = {"length": 1.2, "lumps": 0.05}
        return picture(size=32, shape=shape, pose={"turn_deg": degrees}).linear

    assert abs(seen(20.0) - seen(380.0)).max() < 1e-5
    assert abs(seen(20.0) - seen(110.0)).max() > 0.05


def test_a_long_pearl_lies_and_a_button_sits_unless_the_file_says_otherwise() -> None:
    def extents(**pearl: Any) -> tuple[float, float]:
        return extents_mm(silhouette(64, **pearl))

    wide, high = extents(shape={"length": 1.4})
    assert wide > 1.3 * high
    wide, high = extents(shape={"length": 1.4}, pose=UPRIGHT)
    assert high > 1.3 * wide
    wide, high = extents(shape={"length": 0.75, "flattening": 0.4})
    assert wide > 1.2 * high


def test_same_seed_same_bytes_and_another_seed_another_baroque() -> None:
    def seen(seed: int) -> Array:
        return picture(size=24, shape={"lumps": 0.08, "seed": seed}).linear

    assert np.array_equal(seen(3), seen(3))
    assert abs(seen(3) - seen(4)).max() > 0.05


def test_keys_without_an_effect_leave_the_ball_to_the_byte() -> None:
    none = {"lump_mm": 9.0, "circle_depth": 0.1, "drill_wear_mm": 0.4, "seed": 5}
    assert np.array_equal(picture(size=24, shape=none).linear, picture(size=24).linear)


@pytest.mark.parametrize(
    ("key", "value", "said"),
    [
        ("length", 3, "shape.length is 3; allowed: 0.5 to 2.5"),
        ("circles", 1.5, "shape.circles is 1.5; wanted: a whole number; allowed: 0 to 12"),
        ("lumps", "many", 'shape.lumps is "many"; wanted: a number; allowed: 0 to 0.2'),
        ("legnth", 1.2, "shape.legnth is not a key here; did you mean length?"),
        ("seed", -1, "shape.seed is -1; allowed: "),
    ],
)
def test_a_bad_key_gets_one_line_with_what_is_allowed(key: str, value: Any, said: str) -> None:
    with pytest.raises(nc.InputError) as caught:
        Pearl(shape={key: value})
    assert said in str(caught.value)
    assert "\n" not in str(caught.value)


def test_a_hole_wider_than_half_the_pearl_is_refused() -> None:
    said = "shape.drill_mm is 1.6; allowed: up to half of diameter_mm, which is 1.5 mm"
    with pytest.raises(nc.InputError, match=said):
        Pearl(diameter_mm=3.0, shape={"drill_mm": 1.6})
    assert Pearl(diameter_mm=3.0, shape={"drill_mm": 1.5}).shape.drill_mm == 1.5


def test_the_model_of_1996_knows_no_shape() -> None:
    with pytest.raises(
        nc.InputError, match=r'shape\.length is given.*only with model = "transport"'
    ):
        Pearl(model="illuminant", shape={"length": 1.2})


def test_lumps_that_would_be_needles_are_refused_with_what_they_may_be() -> None:
    needles = nc.load("akoya-rg").replace(diameter_mm=8.0)
    with pytest.raises(nc.InputError, match=r"shape.lump_mm is 0.5; allowed: at least 5 x .*1 mm"):
        needles.replace(shape=needles.shape.replace(lumps=0.05, lump_mm=0.5))


def test_a_hole_is_as_wide_on_a_long_pearl_as_on_a_ball() -> None:
    def dark(length: float) -> float:
        pearl = nc.load("akoya-rg")
        shape = pearl.shape.replace(length=length, drill_mm=2.0, drill_wear_mm=0.0)
        pose = pearl.pose.replace(tilt_deg=90.0)
        scene = nc.Scene.load("north-window-white")
        camera = scene.camera.replace(elevation_deg=0.0, field_mm=6.0)
        seen = pearl.replace(shape=shape, pose=pose)
        light = nc.render(seen, scene.replace(camera=camera), size=64, samples=4).linear
        return float((light.sum(axis=-1) < 0.3).sum() * (6.0 / 64) ** 2)

    assert dark(1.0) == pytest.approx(np.pi, rel=0.06)
    assert dark(0.6) == pytest.approx(dark(1.0), rel=0.07)
    assert dark(1.3) == pytest.approx(dark(1.0), rel=0.07)
