"""What differs from place to place on a pearl, and how it is turned."""

from typing import Any

import numpy as np
import pytest

import nacreous as nc
from nacreous.spec import Pearl, Scene

BLEMISHES = {
    "pits": 14,
    "bumps": 8,
    "scratches": 4,
    "wrinkles": 3,
    "chalky_spots": 5,
    "size_mm": 0.5,
    "depth_um": 40.0,
}
COAT = {"thickness_spread": 0.1, "terrace_um": 60.0, "hammering_rad": 0.1, "banding": 0.3}

#: Even light from all sides, and none that hangs on a direction about the upright.
FURNACE = Scene(
    sky={"kind": "constant", "intensity": 1.0},
    table={"kind": "none"},
    camera={"exposure": 1.0, "white": "D65"},
)
ROUND = Scene(
    sky={"kind": "gradient", "horizon": "#000000", "intensity": 2.0}, table={"kind": "none"}
)


def render(scene: Any = "north-window-black", size: int = 48, **pearl: Any) -> np.ndarray:
    pearl.setdefault("nacre", {"preset": "akoya-rg-1.0"})
    return nc.render(Pearl(**pearl), scene, size=size, samples=4).linear


@pytest.mark.parametrize("waviness_rad", [0.0, 0.1])
def test_a_lossless_pearl_with_everything_on_cannot_be_seen_in_even_light(
    waviness_rad: float,
) -> None:
    light = render(
        FURNACE,
        body={"pigment": "none", "nucleus": "#ffffff"},
        coat=COAT | {"grain_relief_rad": 0.02},
        blemishes=BLEMISHES,
        surface={"waviness_rad": waviness_rad},
        texture={"hue_weight": 0.0, "chroma_weight": 0.0, "value_weight": 0.0},
    )
    assert abs(light - 1).max() < 0.001


def test_a_pearl_turned_with_the_camera_looks_the_same() -> None:
    def seen(degrees: float) -> np.ndarray:
        scene = ROUND.replace(camera=ROUND.camera.replace(azimuth_deg=degrees))
        return render(scene, coat=COAT, blemishes=BLEMISHES, pose={"turn_deg": degrees})

    assert abs(seen(70.0) - seen(0.0)).max() < 0.01
    assert (
        abs(render(ROUND, coat=COAT) - render(ROUND, coat=COAT, pose={"turn_deg": 70.0})).max()
        > 0.05
    )


def test_about_its_own_axis_a_banded_pearl_looks_the_same() -> None:
    banded = {"thickness_spread": 0.1, "banding": 1.0}
    seen = [
        render(ROUND, coat=banded, pose={"spin_deg": spin, "tilt_deg": 30.0}, grain=0.0)
        for spin in (0.0, 120.0)
    ]
    assert abs(seen[0] - seen[1]).max() < 0.01
    tilted = render(ROUND, coat=banded, pose={"tilt_deg": 80.0}, grain=0.0)
    assert abs(seen[0] - tilted).max() > 0.02


@pytest.mark.parametrize(
    "none",
    [
        {"coat": {"patch_mm": 9.0, "banding": 0.7, "dent_mm": 2.0, "terrace_step_nm": 900.0}},
        {"blemishes": {"size_mm": 1.0, "depth_um": 90.0, "area": 0.1}},
        {"pose": {"turn_deg": 90.0, "tilt_deg": 20.0}, "grain": 0.0},
    ],
)
def test_nothing_that_differs_is_an_even_pearl_to_the_byte(none: dict[str, Any]) -> None:
    even = {"grain": 0.0} if "grain" in none else {}
    assert np.array_equal(render(**none), render(**even))


def test_the_grain_stays_where_it_is_under_a_coat() -> None:
    coat = {"thickness_spread": 1e-6}
    assert abs(render(coat=coat, grain=1.0) - render(grain=1.0)).max() < 1e-3


def test_thickness_moves_hue_and_relief_does_not() -> None:
    def hues(**pearl: Any) -> np.ndarray:
        scene = Scene.load("north-window-black")
        rgb = render(scene, 64, grain=0.0, body={"pigment": "black-lip"}, **pearl)[20:44, 20:44]
        lab = nc.colour.lab_from_xyz(nc.colour.xyz_from_rgb(rgb), nc.colour.white_xyz("D65"))
        return np.degrees(np.arctan2(lab[..., 2], lab[..., 1]))

    def moved(**coat: float) -> float:
        turned = hues(coat=coat) - hues()
        return float(np.median(abs((turned + 180) % 360 - 180)))

    assert moved(thickness_spread=0.08) > 5 * moved(hammering_rad=0.02)


def test_a_finer_picture_shows_the_mean_of_what_a_coarse_one_shows() -> None:
    fine = render("north-window-black", 192, coat=COAT, blemishes=BLEMISHES)
    coarse = render("north-window-black", 48, coat=COAT, blemishes=BLEMISHES)
    means = fine.reshape(48, 4, 48, 4, 3).mean(axis=(1, 3))
    assert abs(means - coarse).mean() < 0.01


def test_same_seed_same_bytes_and_another_seed_another_pearl() -> None:
    def seen(seed: int) -> np.ndarray:
        return render(coat=COAT | {"seed": seed}, blemishes=BLEMISHES | {"seed": seed}, size=24)

    assert np.array_equal(seen(3), seen(3))
    assert abs(seen(3) - seen(4)).max() > 0.01


def test_bands_of_the_nucleus_show_through_thin_nacre_alone() -> None:
    def contrast(nacre_mm: float) -> float:
        def inside(bands: float) -> np.ndarray:
            body = {"nacre_mm": nacre_mm, "nucleus_bands": bands}
            pearl = Pearl(nacre={"preset": "akoya-rg-1.0"}, body=body, grain=0.0)
            return nc.render(pearl, "north-window-black", size=64, samples=4).layers["diffuse"]

        ratio = inside(0.3)[24:40, 24:40] / inside(0.0)[24:40, 24:40]
        return float(ratio.std() / ratio.mean())

    thin, thick = contrast(0.1), contrast(3.0)
    assert thin > 0.02
    assert thick < 0.2 * thin
