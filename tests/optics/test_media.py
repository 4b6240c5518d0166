"""Media of every kind: by name, function and table; what is none."""

from __future__ import annotations

import csv
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import nacreous as nc
from nacreous.optics import absorptance, energies, reflectance
from tests.optics.refusal import NM, refusal

ROOT = Path(__file__).parent.parent.parent


def test_aragonite_by_name_is_the_measured_uniaxial_one() -> None:
    with (ROOT / "data" / "aragonite_lines.csv").open() as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    for row in rows:
        n_o = (float(row["n_beta"]) + float(row["n_gamma"])) / 2
        pair = (n_o, float(row["n_alpha"]))
        nm = float(row["wavelength_nm"])
        by_pair, by_name = (
            reflectance(nc.LayerStack([400.0], 0.0, medium, 1.0, 1.0, medium), [0.0, 1.2], nm, "p")
            for medium in (pair, "aragonite")
        )
        np.testing.assert_allclose(by_name, by_pair, rtol=0, atol=1e-4)
    assert len(rows) == 7


@pytest.mark.parametrize(
    ("name", "index"), [("aragonite-isotropic-1.53", 1.53), ("protein-1.43", 1.43)]
)
def test_the_papers_media_have_names(name: str, index: float) -> None:
    by_name, by_index = (nc.LayerStack([400.0] * 9, 20.0, 1.6, n) for n in (name, index))
    np.testing.assert_array_equal(reflectance(by_name, 0.3, NM), reflectance(by_index, 0.3, NM))


def test_function_table_and_name_of_one_medium_agree() -> None:
    """Leertouwer's chitin; the function sees each wavelength once, and in rising order."""
    seen = []

    def chitin(wavelength_nm: NDArray[np.float64]) -> NDArray[np.float64]:
        seen.append(wavelength_nm)
        return 1.517 + 8.80e3 / wavelength_nm**2

    asked_nm = np.array([600.0, 450.0, 600.0, 500.0])
    known_nm = np.unique(asked_nm)
    table = nc.medium.IndexTable(known_nm, chitin(known_nm))
    seen.clear()
    stacks = [nc.LayerStack([400.0] * 9, 20.0, "aragonite", m) for m in ("chitin", table, chitin)]
    name, tabled, called = (reflectance(stack, [0.0, 1.0], asked_nm) for stack in stacks)
    assert [list(nm) for nm in seen] == [[450.0, 500.0, 600.0]]
    np.testing.assert_allclose(called, name, rtol=0, atol=1e-13)
    np.testing.assert_array_equal(called, tabled)


def test_a_function_may_return_a_complex_pair() -> None:
    def pair(nm: NDArray[np.float64]) -> Any:
        return np.full(nm.shape, 1.683 + 1e-3j), np.full(nm.shape, 1.53)

    by_function, by_pair = (
        energies(nc.LayerStack([400.0] * 9, 20.0, medium), [0.0, 1.0], NM)
        for medium in (pair, (1.683 + 1e-3j, 1.53))
    )
    np.testing.assert_array_equal(by_function.R, by_pair.R)
    np.testing.assert_array_equal(by_function.A, by_pair.A)


def test_tables_are_interpolated_in_straight_lines() -> None:
    table = nc.medium.IndexTable([400.0, 500.0], [1.5, 1.6 + 0.2j])
    halfway = nc.LayerStack([400.0], 0.0, table, 1.4)
    constant = nc.LayerStack([400.0], 0.0, 1.55 + 0.1j, 1.4)
    np.testing.assert_allclose(
        absorptance(halfway, 0.4, 450.0), absorptance(constant, 0.4, 450.0), rtol=1e-12
    )


def test_equal_media_make_equal_stacks() -> None:
    stacks = [
        nc.LayerStack([400.0], aragonite=nc.medium.IndexTable([400, 500], [1.5, n]))
        for n in (1.6, 1.6, 1.7)
    ]
    assert stacks[0] == stacks[1] != stacks[2]
    assert hash(stacks[0]) == hash(stacks[1])
    assert repr(stacks[0].aragonite) == "IndexTable(2 wavelengths, 400 to 500 nm)"


SHAPE = "allowed: a number, that of the wavelengths, (401,), or a pair of them"


@pytest.mark.parametrize(
    ("medium", "message"),
    [
        (lambda nm: nm[1:] / 400, f"protein(wavelength_nm) has shape (400,); {SHAPE}"),
        (
            lambda nm: (nm, nm, nm),
            f"protein(wavelength_nm) has shape (401,), (401,), (401,); {SHAPE}",
        ),
        (lambda nm: [[1.5]], "protein(wavelength_nm) has 2 dimensions; allowed: 1"),
        (lambda nm: None, "protein(wavelength_nm) is None; allowed: numbers"),
        (lambda nm: nm - 400, "protein at 380 nm: n is -20; allowed: above 0, up to 100"),
        (lambda nm: nm / 400 - 1j, "protein at 380 nm: k is -1; allowed: 0 to 100"),
        (lambda nm: nm * math.nan, "protein at 380 nm: n is NaN; allowed: above 0, up to 100"),
        (
            nc.medium.IndexTable([400, 700], [1.4, 1.5]),
            "wavelength_nm is 380; allowed with this protein: 400 to 700 nm",
        ),
        (1e-5, "protein: n is 0.00001; allowed: 0.001 to 100 for exact optics"),
    ],
)
def test_a_medium_without_an_index_is_named(medium: Any, message: str) -> None:
    assert refusal(lambda: reflectance(nc.LayerStack([400.0], protein=medium), 0.0, NM)) == message


@pytest.mark.parametrize(
    ("columns", "message"),
    [
        (
            ([400, 400], [1.4, 1.5]),
            "protein: wavelength_nm has 400 after 400; allowed: rising values",
        ),
        (
            ([400], [1.4, 1.5]),
            "protein has 2 indices for 1 wavelengths; allowed: as many, at least 1",
        ),
        (([], []), "protein has 0 indices for 0 wavelengths; allowed: as many, at least 1"),
        (([400], [0]), "protein at 400 nm: n is 0; allowed: above 0, up to 100"),
        (([400], ["x"]), "ordinary is ['x']; allowed: numbers"),
        (([[400]], [1]), "wavelength_nm has 2 dimensions; allowed: 1"),
        (([0.5], [1]), "protein: wavelength_nm is 0.5; allowed: 1 to 1000000 nm"),
    ],
)
def test_a_table_that_is_none_is_named(columns: Any, message: str) -> None:
    act = lambda: nc.LayerStack([400.0], protein=nc.medium.IndexTable(*columns))  # noqa: E731
    assert refusal(act) == message


def test_in_dispersive_media_each_wavelength_sees_its_own_index() -> None:
    """The model of 1996 mixes no wavelengths: a table is a row of constant media side by side."""
    layers, angles = list(np.linspace(360, 430, 90)), [0.0, 0.7, 1.4]
    n1, n2 = (lambda nm: 1.5 + 9e3 / nm**2), (lambda nm: 1.4 + 5e3 / nm**2)
    nm = NM[::29]
    found = nc.optics.illuminant(nc.LayerStack(layers, 20.0, n1, n2), angles, nm)
    for i, each in enumerate(nm):
        alone = nc.LayerStack(layers, 20.0, float(n1(each)), float(n2(each)))
        expected = nc.optics.illuminant(alone, angles, each)[:, 0]
        np.testing.assert_allclose(found[:, i], expected, rtol=1e-12)
