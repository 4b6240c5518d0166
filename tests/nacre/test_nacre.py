"""Layers: what a stack refuses, and growth against a second, plain reading of the paper."""

from __future__ import annotations

import datetime as dt
import math
import subprocess
import sys
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest

import nacreous as nc
from nacreous.nacre import diary, stack_of
from nacreous.spec import Growth, Layers, Pearl

ABOVE_0 = "allowed: above 0, up to 1000000 nm"
ASIDE = "allowed: n, n + ik, (n_o, n_e), IndexTable, function, name"


def refusal(act: Any) -> str:
    with pytest.raises(nc.InputError) as caught:
        act()
    message = str(caught.value)
    assert "\n" not in message
    assert len(message) < 300
    return message


# --- LayerStack: the table of what it refuses


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"thickness_nm": []}, "the stack has 0 layers; allowed: 1 to 5000"),
        ({"thickness_nm": [400.0] * 5001}, "the stack has 5001 layers; allowed: 1 to 5000"),
        ({"thickness_nm": [400.0, -1.0]}, f"thickness_nm[1] is -1; {ABOVE_0}"),
        ({"thickness_nm": [0.0]}, f"thickness_nm[0] is 0; {ABOVE_0}"),
        ({"thickness_nm": [400.0, math.nan]}, f"thickness_nm[1] is NaN; {ABOVE_0}"),
        ({"thickness_nm": [math.inf]}, f"thickness_nm[0] is inf; {ABOVE_0}"),
        ({"thickness_nm": [1.1e6]}, f"thickness_nm[0] is 1100000; {ABOVE_0}"),
        ({"thickness_nm": [[400.0], [410.0]]}, "thickness_nm has 2 dimensions; allowed: 1"),
        ({"thickness_nm": "thick"}, "thickness_nm is 'thick'; allowed: numbers"),
        ({"thickness_nm": ["400"]}, "thickness_nm is ['400']; allowed: numbers"),
        ({"thickness_nm": [True, True]}, "thickness_nm is [True, True]; allowed: numbers"),
        ({"thickness_nm": [400j]}, "thickness_nm is [400j]; allowed: numbers"),
        ({"thickness_nm": None}, "thickness_nm is None; allowed: numbers"),
        ({"thickness_nm": [[400.0], [1, 2]]}, "thickness_nm is [[400.0], [1, 2]]; allowed: num"),
        ({"thickness_nm": [10**400]}, "thickness_nm is [1000000"),
        ({"protein_nm": -1.0}, "protein_nm is -1; allowed: 0 to 1000000 nm"),
        ({"protein_nm": math.nan}, "protein_nm is NaN; allowed: 0 to 1000000 nm"),
        ({"protein_nm": "20"}, "protein_nm is '20'; allowed: a number"),
        ({"protein_nm": None}, "protein_nm is None; allowed: a number"),
        ({"protein_nm": 10**400}, "protein_nm is 1000000"),
        ({"aragonite": 0.0}, "aragonite: n is 0; allowed: above 0, up to 100"),
        ({"aragonite": -1.53}, "aragonite: n is -1.53; allowed: above 0, up to 100"),
        ({"aragonite": math.nan}, "aragonite: n is NaN; allowed: above 0, up to 100"),
        ({"aragonite": 101}, "aragonite: n is 101; allowed: above 0, up to 100"),
        ({"aragonite": 1.53 - 0.1j}, "aragonite: k is -0.1; allowed: 0 to 100"),
        ({"protein": complex(1.43, math.inf)}, "protein: k is inf; allowed: 0 to 100"),
        ({"ambient": 0}, "ambient: n is 0; allowed: above 0, up to 100"),
        ({"substrate": 0}, "substrate: n is 0; allowed: above 0, up to 100"),
        ({"aragonite": (1.683, 1.53, 1)}, f"aragonite is (1.683, 1.53, 1); {ASIDE}"),
        ({"aragonite": (1.683, "x")}, "aragonite: n_e is 'x'; allowed: a number n or a complex"),
        ({"aragonite": (1.683, -1)}, "aragonite: n is -1; allowed: above 0, up to 100"),
        ({"aragonite": "granite"}, "aragonite is 'granite'; allowed: aragonite, aragonite-iso"),
        ({"aragonite": True}, f"aragonite is True; {ASIDE}"),
        ({"aragonite": 10**400}, "aragonite is 1000000"),
    ],
    ids=lambda case: str(case)[:40],
)
def test_a_stack_says_what_is_wrong(given: dict[str, Any], message: str) -> None:
    assert refusal(lambda: nc.LayerStack(**{"thickness_nm": [400.0], **given})).startswith(message)


UM = "(is it in um?)"


@pytest.mark.parametrize("thickness_nm", [[0.38, 0.41], [0.41]])
def test_layers_in_micrometres_are_refused(thickness_nm: list[float]) -> None:
    message = f"thickness_nm is at most 0.41; allowed: a layer of 1 nm or more {UM}"
    assert refusal(lambda: nc.LayerStack(thickness_nm, 0.02)) == message
    nacre = {"thickness_nm": thickness_nm}
    assert refusal(lambda: nc.Pearl(nacre=nacre)) == f"Pearl: nacre.{message}"


def test_a_pearls_protein_in_micrometres_is_refused() -> None:
    message = f"nacre.protein_nm is 0.02; allowed: 0, or 0.1 nm or more {UM}"
    assert refusal(lambda: nc.grow("paper", protein_nm=0.02)) == f"grow: {message}"
    nacre = {"thickness_nm": [400.0], "protein_nm": 0.02}
    assert refusal(lambda: nc.Pearl(nacre=nacre)) == f"Pearl: {message}"


def test_a_last_days_layer_may_be_as_thin_as_one_likes_beside_others() -> None:
    assert nc.LayerStack([1e-3, 400.0], 0.0).total_um == pytest.approx(0.400001)
    assert len(nc.LayerStack([1.0], 0.01, cover=[(1.33, 500.0), (1.5, 0.01)])) == 1


def test_a_cover_in_micrometres_is_refused() -> None:
    message = f"cover's thickness is at most 0.5; allowed: a layer of 1 nm or more {UM}"
    for cover in ([(1.33, 0.5)], [(1.33, 0.5), (1.5, 0.1)]):
        assert refusal(lambda cover=cover: nc.LayerStack([400.0], cover=cover)) == message
    assert nc.LayerStack([400.0], cover=[(1.33, 0.0)]).cover == ((1.33, 0.0),)


def test_a_billion_layers_are_refused_without_a_copy_of_them() -> None:
    """Measured in a process of its own: a copy takes 8 GB.

    A new process starts with its parent's peak, so what counts is by how much it grows.
    """
    code = """
import resource, numpy as np, nacreous as nc
nc.LayerStack([400.0])
before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
try:
    nc.LayerStack(np.broadcast_to(400.0, 10**9))
except nc.InputError as problem:
    print(problem, resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before, sep="|")
"""
    done = subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, text=True)
    message, grown_kb = done.stdout.split("|")
    assert message == "the stack has 1000000000 layers; allowed: 1 to 5000"
    assert int(grown_kb) < 500_000


def test_what_is_refused_later_stays_short() -> None:
    assert len(refusal(lambda: nc.LayerStack(["thick"] * 100_000))) < 120


@pytest.mark.parametrize(
    "thickness_nm", [[1.0], [1e-3, 1.0], [1e6], [400] * 5000, 400.0, range(400, 410)]
)
def test_a_stack_takes_its_bounds_whole_numbers_and_a_single_layer(thickness_nm: Any) -> None:
    stack = nc.LayerStack(thickness_nm, protein_nm=0, aragonite=np.float64(1.53), protein=2 + 1j)
    np.testing.assert_array_equal(stack.thickness_nm, np.atleast_1d(np.array(thickness_nm, float)))


def test_one_thickness_of_protein_in_a_list_is_that_of_every_layer() -> None:
    stack = nc.LayerStack([380.0, 300.0], [50.0])
    assert stack == nc.LayerStack([380.0, 300.0], 50.0)
    assert stack.total_um == pytest.approx(0.780)
    assert repr(stack) == "LayerStack(2 layers, 0.780 um)"
    assert stack.outer(0.4) == nc.LayerStack([380.0, 300.0], 50.0).outer(0.4)


def test_a_wavelength_is_said_with_the_digits_that_are_read() -> None:
    measured = nc.medium.IndexTable([321.80716809692075, 500.0], [1.5, 1.6])
    stack = nc.LayerStack([400.0], aragonite=measured)
    message = refusal(lambda: nc.optics.reflectance(stack, 0.0, 321.80716809692070 - 1e-3))
    assert "wavelength_nm is 321.806168; allowed" in message
    assert "321.807168 to 500 nm" in message


def test_a_stack_keeps_its_own_layers() -> None:
    thickness_nm = np.array([400.0, 410.0])
    stack = nc.LayerStack(thickness_nm)
    thickness_nm[0] = 0.0
    assert stack == nc.LayerStack([400.0, 410.0])
    with pytest.raises(ValueError, match="read-only"):
        stack.thickness_nm[0] = 0.0


def test_equal_stacks_are_equal_in_sets_too() -> None:
    stacks = {nc.LayerStack([400.0]), nc.LayerStack([400]), nc.LayerStack([400.0], protein=1.5)}
    assert len(stacks) == 2
    assert nc.LayerStack([400.0]) != 400.0


def test_statistics_are_those_of_the_layers_that_begin_within_the_depth() -> None:
    thickness_nm = np.linspace(300.0, 500.0, 41)
    stack = nc.LayerStack(thickness_nm, protein_nm=20.0)
    begins_um = np.concatenate([[0.0], np.cumsum(thickness_nm + 20.0)[:-1]]) / 1e3
    for depth_um in (0.1, 3.0, 10.0, 1e6, math.inf):
        inside = thickness_nm[begins_um <= depth_um]
        layers, mean_nm, spread_nm = stack.outer(depth_um)
        assert layers == len(inside)
        assert mean_nm == pytest.approx(inside.mean(), rel=1e-13)
        assert spread_nm == pytest.approx(inside.std(), abs=1e-9)
    assert stack.total_um == pytest.approx((thickness_nm.sum() + 41 * 20.0) / 1e3, rel=1e-13)


@pytest.mark.parametrize("depth_um", [-1.0, math.nan, "10", None])
def test_a_depth_is_a_number_of_um(depth_um: Any) -> None:
    message = refusal(lambda: nc.LayerStack([400.0]).outer(depth_um))
    assert message.startswith("depth_um is ")


# --- growth, against a second reading of the paper and of RFC 8439's cipher


def chacha8_words(seed: int) -> Iterator[int]:
    """Words of 32 bits of ChaCha with 8 rounds, the seed as key, counted from block 0."""
    key = seed.to_bytes(8, "little") + bytes(24)
    key_words = [int.from_bytes(key[i : i + 4], "little") for i in range(0, 32, 4)]
    constants = [0x61707865, 0x3320646E, 0x79622D32, 0x6B206574]
    columns = [(0, 4, 8, 12), (1, 5, 9, 13), (2, 6, 10, 14), (3, 7, 11, 15)]
    diagonals = [(0, 5, 10, 15), (1, 6, 11, 12), (2, 7, 8, 13), (3, 4, 9, 14)]
    block = 0
    while True:
        start = [*constants, *key_words, block & 0xFFFFFFFF, block >> 32, 0, 0]
        x = start.copy()
        for _ in range(4):
            for a, b, c, d in columns + diagonals:
                for p, q, r, bits in ((a, b, d, 16), (c, d, b, 12), (a, b, d, 8), (c, d, b, 7)):
                    x[p] = (x[p] + x[q]) & 0xFFFFFFFF
                    turned = x[r] ^ x[p]
                    x[r] = (turned << bits | turned >> (32 - bits)) & 0xFFFFFFFF
        yield from ((new + old) & 0xFFFFFFFF for new, old in zip(x, start, strict=True))
        block += 1


def noise(seed: int) -> Iterator[float]:
    """Uniform in -1..1, from 53 bits of each pair of words."""
    words = chacha8_words(seed)
    while True:
        low, high = next(words), next(words)
        yield ((high << 32 | low) >> 11) / 2**52 - 1.0


def grown_by_the_book(growth: Growth) -> tuple[list[dt.date], list[float]]:
    """Paper 3.2.1: bell curves over the season, highest in summer, plus uniform noise."""
    uniform = noise(growth.seed)
    dates, thickness_nm = [], []
    for day in range(growth.days):
        date = growth.seeding_date + dt.timedelta(days=day)
        to_peak_days = (date - growth.peak_date).days
        to_peak_days -= 365.2425 * round(to_peak_days / 365.2425)
        bell = math.exp(-(to_peak_days**2) / (2 * growth.season_days**2))
        rate = growth.layers_winter + (growth.layers_summer - growth.layers_winter) * bell
        layers = round(rate + growth.layers_noise * next(uniform))
        mean_nm = (
            growth.thickness_winter_nm
            + (growth.thickness_summer_nm - growth.thickness_winter_nm) * bell
        )
        for _ in range(layers):
            dates.append(date)
            thickness_nm.append(mean_nm + growth.thickness_noise_nm * next(uniform))
    return dates, thickness_nm


def test_the_second_cipher_gives_the_published_stream() -> None:
    """draft-strombergson-chacha-test-vectors, ChaCha8, 256-bit key of zeros."""
    words = chacha8_words(0)
    stream = b"".join(next(words).to_bytes(4, "little") for _ in range(8))
    assert stream.hex() == "3e00ef2f895f40d67f5bb8e81f09a5a12c840ec3ce9a7f3b181be188ef711a1e"


@pytest.mark.parametrize(
    "growth",
    [
        Growth(preset="paper", seed=7),
        Growth(preset="paper", seed=2**63 - 1, harvest="02-10"),
        Growth(preset="akoya-g", seed=3, seeding="2022-05-01", harvest="2024-12-20"),
    ],
    ids=["paper", "largest-seed", "three-summers"],
)
def test_growth_is_bell_curves_plus_uniform_noise(growth: Growth) -> None:
    grown = diary(growth)
    dates, thickness_nm = grown_by_the_book(growth)
    assert list(grown.date) == dates
    np.testing.assert_allclose(grown.thickness_nm, thickness_nm, rtol=1e-12, atol=0)


def test_the_stack_counts_from_the_surface_and_the_diary_from_the_nucleus() -> None:
    grown = diary(Growth(preset="paper", seed=7))
    np.testing.assert_array_equal(nc.grow("paper", seed=7).thickness_nm, grown.thickness_nm[::-1])


def test_same_seed_same_bytes_other_seed_other_layers() -> None:
    first, again, other = (nc.grow("paper", seed=seed) for seed in (7, 7, 8))
    assert first.thickness_nm.tobytes() == again.thickness_nm.tobytes()
    assert first.thickness_nm.tobytes() != other.thickness_nm.tobytes()


def test_the_paper_season_stays_within_its_ranges() -> None:
    """400 to 700 nm and 1 to 3 layers a day, each widened by its noise."""
    for name in ("paper", "paper-green"):
        growth = Growth(preset=name, seed=7)
        grown = diary(growth)
        noise_nm = growth.thickness_noise_nm
        assert 400 - noise_nm <= grown.thickness_nm.min() < 500
        assert 700 - noise_nm < grown.thickness_nm.max() <= 700 + noise_nm
        a_day = [grown.date.count(date) for date in dict.fromkeys(grown.date)]
        assert min(a_day) == 1
        assert max(a_day) == 3


def test_winter_lays_thin_even_layers_outside_and_summer_harvest_thick_ones() -> None:
    """Paper 3.2.1: below 500 nm only in late autumn and winter, hence harvest in December."""
    for seed in range(5):
        for name in ("paper", "paper-green"):
            assert nc.grow(name, seed=seed).outer(10)[1] < 500
        grown = diary(Growth(preset="paper", seed=seed))
        late = [date.month >= 11 for date in grown.date]
        assert grown.thickness_nm[late].max() < 500
        summer = nc.grow("paper-summer-harvest", seed=seed)
        assert summer.thickness_nm[0] > 600
        assert summer.outer(10)[1] > 600


@pytest.mark.parametrize(
    ("family", "mean_nm"), [("akoya-r", 330), ("akoya-rg", 360), ("akoya-g", 440), ("akoya", 360)]
)
def test_the_families_have_the_reported_layers_in_the_outer_10_um(
    family: str, mean_nm: float
) -> None:
    outer = np.array([nc.grow(family, seed=seed).outer(10) for seed in range(20)])
    assert outer[:, 1].mean() == pytest.approx(mean_nm, rel=0.03)
    assert 10 <= outer[:, 2].mean() <= 20


def test_a_preset_grows_with_parameters_over_it() -> None:
    stack = nc.grow("akoya", seed=7, harvest="12-15", protein_nm=15.0, aragonite=1.6)
    assert stack.protein_nm == 15.0
    assert stack.aragonite == 1.6
    assert stack.thickness_nm.tobytes() == nc.grow("akoya", seed=7).thickness_nm.tobytes()
    assert nc.grow(Growth(preset="akoya"), seed=7).thickness_nm.tobytes() == (
        stack.thickness_nm.tobytes()
    )


def test_listed_layers_are_the_stack() -> None:
    pearl = Pearl(nacre=Layers(thickness_nm=[400.0, 410.0], protein=1.5))
    assert stack_of(pearl) == nc.LayerStack([400.0, 410.0], protein=1.5)


@pytest.mark.parametrize(
    ("given", "medium"),
    [
        ("aragonite", "aragonite"),
        ("aragonite-isotropic-1.53", "aragonite-isotropic-1.53"),
        ({"n_o": 1.683, "n_e": 1.53}, (1.683, 1.53)),
    ],
)
def test_crystals_lie_on_a_core_of_the_same_crystal(given: Any, medium: Any) -> None:
    listed = Layers(thickness_nm=[400.0, 410.0], aragonite=given, protein="chitin")
    same = nc.LayerStack([400.0, 410.0], 20.0, medium, "chitin", substrate=medium)
    assert stack_of(Pearl(nacre=listed)) == same
    assert stack_of(Pearl(nacre=listed)).substrate == medium
    grown = nc.grow("paper", seed=3, aragonite=given)
    assert (grown.aragonite, grown.substrate) == (medium, medium)


def test_layers_of_plain_index_lie_on_the_core_of_the_paper() -> None:
    assert nc.grow("paper", aragonite=1.6).substrate == 1.53


def test_growth_takes_media_that_no_model_of_a_pearl_takes() -> None:
    assert nc.grow("paper", protein=[1.43, 0.02]).protein == 1.43 + 0.02j


def test_akoya_is_the_crystal_as_measured() -> None:
    for family in ("akoya", "akoya-r", "akoya-rg", "akoya-g"):
        stack = nc.grow(family)
        assert (stack.aragonite, stack.protein, stack.substrate) == (
            "aragonite",
            "chitin",
            "aragonite",
        )


@pytest.mark.parametrize(
    ("parameters", "message"),
    [
        ({"growth": "akoia"}, 'grow: nacre.preset is "akoia"; '),
        ({"growth": None}, "growth is None; allowed: a nacre preset's name or a Growth"),
        ({"harvst": "12-15"}, "grow: nacre.harvst is not a key here; did you mean harvest?"),
        ({"harvest": "30-02"}, 'grow: nacre.harvest is "30-02"; allowed: "MM-DD"'),
        ({"seed": -1}, "grow: nacre.seed is -1; allowed: 0 to 9223372036854775807"),
        ({"seed": 7.5}, "grow: nacre.seed is 7.5; wanted: a whole number"),
        ({"protein_nm": math.nan}, "grow: nacre.protein_nm is nan; allowed: 0 to 200 nm"),
        ({"thickness_winter_nm": -400}, "grow: nacre.thickness_winter_nm is -400; allowed: 50"),
        (
            {"layers_winter": 0, "layers_summer": 0, "layers_noise": 0},
            "grow: nacre.layers_summer is 0, and so are ",
        ),
        (
            {"layers_winter": 0.1, "layers_summer": 0.1, "layers_noise": 0},
            "the stack has 0 layers; allowed: 1 to 5000",
        ),
        ({"layers_summer": 1e9}, "grow: nacre.layers_summer is 1000000000.0; allowed: 0 to 20"),
        (
            {"layers_winter": 20, "seeding": "2001-01-01", "harvest": "2020-12-31"},
            "the stack has 1",
        ),
        ({"thickness_nm": [400.0]}, "grow: nacre."),
    ],
    ids=lambda case: str(case)[:50],
)
def test_growth_says_what_is_wrong(parameters: dict[str, Any], message: str) -> None:
    assert refusal(lambda: nc.grow(**parameters)).startswith(message)
