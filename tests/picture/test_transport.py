"""Light inside the pearl, from a pearl file to the picture."""

from __future__ import annotations

import numpy as np
import pytest

import nacreous as nc
from nacreous.nacre import columns_of
from nacreous.spec import Pearl, Scene

LOSSLESS = {"pigment": "none", "nucleus": "#ffffff"}
EVEN = Scene(
    sky={"kind": "constant", "intensity": 1.0},
    table={"kind": "none"},
    camera={"exposure": 1.0, "white": "D65"},
)
FACETS = [
    {"facets": "torrance-sparrow", "facet_spread_rad": 0.01},
    {"facets": "torrance-sparrow", "facet_spread_rad": 0.3},
    {"facets": "ggx", "facet_spread_rad": 0.05},
    {"facets": "ggx", "facet_spread_rad": 0.5},
]


def pearl(**given: object) -> Pearl:
    return Pearl(**{"nacre": {"preset": "akoya-rg-1.0"}, "grain": 0, **given})


@pytest.mark.parametrize("surface", FACETS)
@pytest.mark.parametrize("spread", [0.0, 0.4, 1000.0])
def test_a_lossless_pearl_in_even_light_is_invisible(
    surface: dict[str, object], spread: float
) -> None:
    lossless = pearl(body=LOSSLESS, surface=surface, inside={"spread": spread})
    image = nc.render(lossless, EVEN, size=48, samples=4)
    assert np.abs(image.linear - 1).max() < 0.005
    assert image.layers["mirror"].max() > 0.1, "the furnace has nothing in it"


def test_a_white_table_under_a_lossless_pearl_keeps_its_light_where_they_are_apart() -> None:
    # Table, pearl and sky are white; light bounces once, so the touching point alone stays darker.
    table = {"kind": "plain", "colour": "#ffffff"}
    scene = EVEN.replace(table=Scene(table=table).table)
    image = nc.render(pearl(body=LOSSLESS), scene, size=64, samples=4)
    error = np.abs(image.linear - 1).max(axis=-1)
    assert np.median(error) < 0.01
    assert error.max() < 0.25


def test_with_absorption_the_loss_is_the_bodys() -> None:
    # Colours of a body that absorbs, against the series of its rounds: enter, come back by rho,
    # leave by the film or be mirrored back. The film's share by exact optics of the same columns.
    body, level = {"pigment": "gold", "nacre_mm": 0.5}, {"waviness_rad": 0.0}
    gold = pearl(body=body, surface=level)
    nm = np.arange(380.0, 781.0)
    columns = columns_of(gold)
    cosine = (np.arange(64) + 0.5) / 64
    T = 1 - np.mean([nc.optics.energies(c, np.arccos(cosine), nm).R for c in columns[:16]], axis=0)
    hemisphere = 2 * (T * cosine[:, None]).mean(axis=0)
    rho = nc.body.reflectance_of_body(gold, 0.5)
    n_o, n_e = 1.683, 1.530
    out = hemisphere / (0.5 * (n_o**2 + n_e**2))
    lit, left = np.ones_like(nm), np.zeros_like(nm)
    for _ in range(2000):
        lit = lit * rho
        left, lit = left + lit * out, lit * (1 - out)
    middle = 1 - np.mean([nc.optics.energies(c, [0.0], nm).R[0] for c in columns], axis=0)
    expected = nc.colour.xyz_from_spectrum(1 - middle + middle * left, "D65")
    image = nc.render(gold, EVEN, size=33, samples=4)
    white = nc.colour.white_xyz("D65")
    seen = nc.colour.xyz_from_rgb(image.linear[16, 16].astype(float))
    lab = [nc.colour.lab_from_xyz(xyz, white) for xyz in (expected, seen)]
    assert nc.colour.delta_e_2000(*lab) < 1.0
    assert expected[1] < 0.9


def test_depth_carries_colour_and_shininess_sharpness() -> None:
    scene = Scene.load("paper")

    def contrast(name: str, **given: object) -> float:
        layer = nc.render(pearl(**given), scene, size=64, samples=4).layers[name]
        return float(
            np.ptp(layer[..., 0] - layer[..., 1]) if name == "interference" else layer.max()
        )

    depths = [contrast("interference", depth=depth) for depth in (0.05, 0.3, 0.7)]
    assert depths == sorted(depths)
    glints = [contrast("mirror", shininess=shininess) for shininess in (0.1, 0.5, 1.0)]
    assert glints == sorted(glints)


def test_columns_are_those_of_the_seeds_that_follow() -> None:
    columns = columns_of(pearl(film={"columns": 3, "outer_um": 20.0}), 20.0)
    for column, seed in zip(columns, (1, 2, 3), strict=True):
        grown = nc.grow("akoya-rg-1.0", seed=seed)
        assert np.array_equal(column.thickness_nm, grown.thickness_nm[: len(column)])


def test_listed_layers_are_spread_from_column_to_column() -> None:
    listed = Pearl(nacre={"thickness_nm": [400.0] * 100})
    columns = columns_of(listed, 50.0)
    thickness_nm = np.array([column.thickness_nm for column in columns])
    assert abs(thickness_nm.std() - 10.0) < 0.5
    assert abs(thickness_nm.mean() - 400.0) < 1.0
    assert np.array_equal(columns_of(listed, 50.0)[5].thickness_nm, columns[5].thickness_nm)


def test_no_spread_is_needed_to_be_finite() -> None:
    thin = Pearl(nacre={"thickness_nm": [1.0]}, film={"column_spread_nm": 200.0})
    assert np.isfinite(nc.render(thin, size=16, samples=1).linear).all()


def test_the_overtone_of_a_black_pearl_covers_it_beyond_the_lamps_image() -> None:
    """Median chroma outside the highlight: half of that inside at least; level, it is a sixth."""

    def share(waviness_rad: float) -> float:
        pearl = Pearl.load("tahitian", [("surface.waviness_rad", waviness_rad)])
        image = nc.render(pearl, "north-window-black", size=160)
        whole = image.layers["coverage"][..., 0] > 0.99
        xyz = nc.colour.xyz_from_rgb(image.linear[whole].astype(float))
        lightness, a, b = nc.colour.lab_from_xyz(xyz, nc.colour.white_xyz("D65")).T
        chroma, highlight = np.hypot(a, b), lightness > 60.0
        return float(np.median(chroma[~highlight]) / np.median(chroma[highlight]))

    assert share(nc.load("tahitian").surface.waviness_rad) > 0.5
    assert share(0.0) < 0.2


def test_the_overtone_of_a_peacock_pearl_changes_its_hue_from_centre_to_rim() -> None:
    image = nc.render("tahitian", "north-window-black", size=160)
    middle = np.arange(160) - 79.5
    radius = np.hypot(middle[:, None], middle) / (160 / 3)
    xyz = nc.colour.xyz_from_rgb(image.linear.astype(float))
    lightness, a, b = np.moveaxis(nc.colour.lab_from_xyz(xyz, nc.colour.white_xyz("D65")), -1, 0)

    def hue_deg(where: np.ndarray) -> float:
        seen = where & (lightness < 60.0)
        return float(np.degrees(np.arctan2(b[seen].mean(), a[seen].mean())))

    turn = hue_deg(radius < 0.4) - hue_deg((radius > 0.75) & (radius < 0.98))
    assert abs((turn + 180) % 360 - 180) > 60
