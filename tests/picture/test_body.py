"""Body colour: pigments, Kubelka and Munk's limits, and what a nucleus does below thin nacre."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import ArrayLike, NDArray

import nacreous as nc
from nacreous.film import columns_of
from nacreous.spec import Body, Pearl

ROOT = Path(__file__).parent.parent.parent
NM = nc.colour.WAVELENGTH_NM
WHITE = nc.colour.white_xyz("D65")


def lab(reflectance: ArrayLike) -> NDArray[np.float64]:
    return nc.colour.lab_from_xyz(nc.colour.xyz_from_spectrum(reflectance, "D65"), WHITE)


def chroma(reflectance: ArrayLike) -> float:
    return float(np.hypot(*lab(reflectance)[1:]))


def refusal(act: Any) -> str:
    with pytest.raises(nc.InputError) as caught:
        act()
    message = str(caught.value)
    assert "\n" not in message
    return message


# --- pigments


def test_the_table_of_pigments_is_what_its_script_makes(tmp_path: Path) -> None:
    script, made = ROOT / "data" / "make_pigments.py", tmp_path / "pigments.csv"
    subprocess.run([sys.executable, script, made], check=True)
    assert made.read_bytes() == (ROOT / "data" / "pigments.csv").read_bytes()


def test_absorption_goes_through_the_table_by_straight_lines() -> None:
    text = (ROOT / "data" / "pigments.csv").read_text(encoding="utf-8")
    names, *rows = [line.split(",") for line in text.splitlines() if not line.startswith("#")]
    table = np.array(rows, dtype=float)
    assert tuple(names[1:]) == nc.body.PIGMENTS[1:]
    for column, name in enumerate(names[1:], start=1):
        expected = np.interp(NM, table[:, 0], table[:, column])
        np.testing.assert_allclose(nc.body.absorption(name), expected, atol=1e-12)
    assert not nc.body.absorption("none").any()


#: What nacre returns inwards of light from all sides, on average under the film of akoya-rg-1.0.
R_INT = 0.68


def seen(reflectance: NDArray[np.float64]) -> NDArray[np.float64]:
    """Through an even film: light that the film returns meets the body again."""
    return reflectance * (1 - R_INT) / (1 - R_INT * reflectance)


@pytest.mark.parametrize(
    ("pigment", "least", "most"),
    [
        ("white", (92, -2, -2), (94, 2, 2.2)),
        ("cream", (86, -2, 8), (90, 2, 12)),
        ("pink", (83, 5, -4), (87, 8, 4)),
        ("gold", (75, 3, 30), (80, 8, 40)),
        ("black-lip", (35, -4, 0), (45, -2, 5)),
        ("dyed-blue", (50, -10, -32), (65, 0, -18)),
    ],
)
def test_half_a_millimetre_of_each_pigment_is_seen_in_its_trade_name_s_colour(
    pigment: str, least: tuple[float, ...], most: tuple[float, ...]
) -> None:
    found = lab(seen(nc.body.reflectance(pigment, 0.5)))
    assert np.all(found >= least)
    assert np.all(found <= most)


def test_a_film_of_nacre_returns_as_much_inwards_as_the_pigments_are_made_for() -> None:
    """1 - T / N: T from all sides through the film, N = (n_o^2 + n_e^2) / 2 waves for the air's."""
    cosine = (np.arange(24) + 0.5) / 24
    columns = columns_of(Pearl.load("akoya-rg-1.0", [("film.columns", "8")]), 50.0)
    film = np.mean([nc.optics.reflectance(c, np.arccos(cosine), NM) for c in columns], axis=0)
    through = np.mean(2 * cosine[:, None] * (1 - film), axis=0)
    inwards = 1 - through / ((1.683**2 + 1.530**2) / 2)
    assert inwards.mean() == pytest.approx(R_INT, abs=0.01)
    assert inwards.min() > 0.64
    assert inwards.max() < 0.75


# --- the formula


@pytest.mark.parametrize("pigment", nc.body.PIGMENTS[1:])
def test_reflectance_is_the_textbooks_formula(pigment: str) -> None:
    """Kubelka 1948, with the hyperbolic cotangent as he prints it."""
    a = 1 + 1.7 * nc.body.absorption(pigment) / 4.0
    b = np.sqrt(a * a - 1)
    coth = 1 / np.tanh(b * 4.0 * 0.35)
    expected = (1 - 0.8 * (a - b * coth)) / (a - 0.8 + b * coth)
    found = nc.body.reflectance(pigment, 0.35, 1.7, 4.0, np.full(401, 0.8))
    np.testing.assert_allclose(found, expected, atol=1e-12)


def test_a_lossless_white_body_is_white_to_the_last_bit() -> None:
    for nacre_mm in (0.0, 0.01, 0.5, 15.0):
        for scattering in (0.0, 3.0, 1000.0):
            white = nc.body.reflectance("none", nacre_mm, 10.0, scattering, "#ffffff")
            assert np.all(white == 1.0)


def test_without_scattering_the_nucleus_is_seen_through_a_filter() -> None:
    nucleus = np.linspace(0.2, 0.9, 401)
    found = nc.body.reflectance("gold", 0.4, 1.0, 0.0, nucleus)
    np.testing.assert_allclose(found, np.exp(-0.8 * nc.body.absorption("gold")) * nucleus, 1e-13)


def test_thick_nacre_hides_its_nucleus() -> None:
    black, white = (nc.body.reflectance("gold", 15.0, 1, 20, c) for c in ("#000000", "#ffffff"))
    assert np.abs(black - white).max() < 1e-4
    thin = [nc.body.reflectance("gold", 0.05, 1, 20, c) for c in ("#000000", "#ffffff")]
    assert np.abs(thin[0] - thin[1]).max() > 0.3


def test_thinner_golden_nacre_is_steadily_paler() -> None:
    """The trade: below 0.3 mm the nucleus shows."""
    found = [chroma(nc.body.reflectance("gold", mm)) for mm in np.arange(0.5, 0.09, -0.02)]
    assert np.all(np.diff(found) < 0)
    assert found[-1] < 0.6 * found[0]


def test_more_pigment_is_darker_at_every_wavelength() -> None:
    steps = [nc.body.reflectance("black-lip", 0.5, strength) for strength in (0, 0.3, 1, 3, 10)]
    assert np.all(np.diff(steps, axis=0) < 0)


# --- the nucleus


@pytest.mark.parametrize("code", ["#f4f1ea", "#ffffff", "#d8c9a8", "#e8c8c0", "#8fb0c8", "#404040"])
def test_a_bare_nucleus_has_the_colour_that_was_asked(code: str) -> None:
    bare = nc.body.reflectance("none", 0.0, nucleus=code)
    wanted = nc.colour.lab_from_xyz(
        nc.colour.xyz_from_rgb(nc.colour.linear_from_hex(code)), nc.colour.xyz_from_rgb([1, 1, 1])
    )
    assert nc.colour.delta_e_2000(lab(bare), wanted) < 0.5


def test_a_nucleus_is_smooth_and_grey_is_level() -> None:
    tinted = nc.body.reflectance("none", 0.0, nucleus="#e8c8c0")
    assert np.abs(np.diff(tinted)).max() < 0.01
    assert np.ptp(nc.body.reflectance("none", 0.0, nucleus="#808080")) < 2e-3


# --- of a pearl, and refusals


def test_the_body_of_a_pearl_is_what_its_file_says() -> None:
    body = Body(
        pigment="gold", pigment_strength=0.5, nacre_mm=0.3, scattering_per_mm=6, nucleus="#fff0e0"
    )
    expected = nc.body.reflectance("gold", 0.3, 0.5, 6, "#fff0e0")
    np.testing.assert_array_equal(nc.body.reflectance_of_body(Pearl(body=body), 0.1), expected)


def test_nacre_is_as_thick_as_the_stack_where_the_file_leaves_it_out() -> None:
    pearl = Pearl(diameter_mm=2.0, body=Body(pigment="gold"))
    for stack_mm, nacre_mm in ((0.2, 0.2), (0.6, 0.6), (3.0, 1.0)):
        np.testing.assert_array_equal(
            nc.body.reflectance_of_body(pearl, stack_mm), nc.body.reflectance("gold", nacre_mm)
        )


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"pigment": "golden"}, "pigment is 'golden'; allowed: none, white, cream, pink, gold, "),
        ({"pigment": 3}, "pigment is 3; allowed: none, white"),
        ({"nacre_mm": -0.1}, "nacre_mm is -0.1; allowed: 0 to 15"),
        ({"nacre_mm": float("nan")}, "nacre_mm is nan; allowed: 0 to 15"),
        ({"nacre_mm": "thick"}, "nacre_mm is 'thick'; allowed: a number"),
        ({"strength": 11}, "strength is 11; allowed: 0 to 10"),
        ({"scattering_per_mm": 1001}, "scattering_per_mm is 1001; allowed: 0 to 1000"),
        ({"nucleus": "white"}, 'colour is "white"; allowed: "#rrggbb"'),
        ({"nucleus": [0.9, 0.9]}, "nucleus has shape [2]; allowed: [401]"),
        ({"nucleus": np.full(401, 1.1)}, "nucleus[0] is 1.1; allowed: 0 to 1"),
        ({"nucleus": np.full(401, np.nan)}, "nucleus[0] is nan; allowed: 0 to 1"),
        ({"nucleus": None}, "nucleus is None; allowed: numbers"),
    ],
    ids=lambda case: str(case)[:40],
)
def test_a_body_says_what_is_wrong(given: dict[str, Any], message: str) -> None:
    assert refusal(lambda: nc.body.reflectance(**given)).startswith(message)


def test_the_thickness_of_a_stack_is_checked() -> None:
    assert refusal(lambda: nc.body.reflectance_of_body(Pearl(), -1.0)).startswith(
        "nacre_mm_of_stack is -1; "
    )
