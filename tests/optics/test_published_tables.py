"""CSV tables of n and k: what their columns are called, and what stands around them."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import nacreous as nc
from nacreous import medium
from nacreous.problem import InputError
from tests.optics.published_files import written

OTHER_QUANTITIES = [
    *("eV,n,k", "wl (A),n,k", "wavelength [cm-1],n,k", "energy,n,k", "E,n,k", "kx,n,k", "hv,n,k"),
    *("Wavelength in angstrom,n,k", "Angstroms,n,k", "wavenumber,n,k", "frequency,n,k", "k,n,k"),
    *("Wavelength m,n,k", "omega,n,k", "1/um,n,k", "1/nm,n,k", "nm^-1,n,k", "um-1,n,k", ",wl,n,k"),
    *("E,index,loss", "numbers,n,k", "wl (THz),n,k", "wavelength (10^-10 m),n,k", "lambda um^-1,n"),
]


@pytest.mark.parametrize("head", OTHER_QUANTITIES)
def test_wavelengths_in_a_unit_that_is_not_read_are_refused_by_name(
    head: str, tmp_path: Path
) -> None:
    file = tmp_path / "medium.csv"
    file.write_text(f"{head}\n1.5,1.5,0\n3,1.6,0\n", "utf-8")
    with pytest.raises(nc.InputError, match=r"row 1: the first column is .*; allowed: a wavel"):
        nc.medium.read(file)
    for unit in ("wl", "wl,um", "Wavelength (\u00b5m)", "lambda [micron]"):
        name = unit.split(",")[0]
        file.write_text(f"{name},n,k\n0.4,1.5,0\n0.8,1.6,0\n", "utf-8")
        assert nc.medium.read(file).last_nm == pytest.approx(800.0)


@pytest.mark.parametrize(
    ("name", "nm_per_unit"),
    [
        *((name, 1e3) for name in ("wl", "um", "\u00b5m", "\u03bb", "lambda_um", "Wave Length")),
        *(
            (name, 1e3)
            for name in ("WAVELENGTH (micron)", "wl in microns", "Wellenl\u00e4nge [um]")
        ),
        *((name, 1.0) for name in ("nm", "Wavelength/nm", "wl_nm", "\u6ce2\u9577 (nm)", "(nm)")),
        *(
            (name, 1.0)
            for name in ("lambda0 [nanometers]", "vacuum wavelength, nm", "\u03bb in nm")
        ),
    ],
)
def test_a_wavelength_is_known_by_its_name_and_unit(
    tmp_path: Path, name: str, nm_per_unit: float
) -> None:
    found = medium.read(written(tmp_path, f"{name};n\n0,4;1,5\n0,8;1,6\n", "m.csv"))
    assert (found.first_nm, found.last_nm) == pytest.approx((0.4 * nm_per_unit, 0.8 * nm_per_unit))


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("wl;n;k\n0,4;1,5;1.0E-3\n", "row 2 has '0,4' beside '1.0E-3'; allowed: one decimal mark"),
        ("wl;n\n0,4;1,5\n1.100;1,4\n", "row 2 has '0,4' and row 3 '1.100'; allowed: one decimal"),
        (
            "Wavelength (nm);n\n380,0;1,5\n1.100,0;1,4\n",
            "row 3 has '1.100,0'; allowed: finite numbers, without marks between thousands",
        ),
        ("wl,n\n0,4,1,5\n", "row 2 has 4 numbers; allowed: 2 (decimal commas need semicolons or"),
        ("wl,n\n0.4,1.5\n0.7 um,1.4\n", "row 3 has '0.7 um'; allowed: finite numbers"),
        ("wl,n\n0.4,1.5\n?,1.4\n", "row 3 has '?'; allowed: finite numbers"),
        ("wl,n\n0.4,1.5\nwl,k\n", "row 3 names columns, and no row of numbers is below it"),
        ("wl,n\n0.4,1.5\nnote\n0.5,1.6\n", "row 3: the first column is 'note'; allowed: a wavel"),
    ],
)
def test_a_row_of_a_table_that_is_none_is_named_with_what_is_wrong(
    tmp_path: Path, text: str, message: str
) -> None:
    file = written(tmp_path, text, "a.csv")
    with pytest.raises(nc.InputError) as caught:
        medium.read(file)
    assert str(caught.value).startswith(f"{file}: {message}")


@pytest.mark.parametrize(
    "text",
    [
        "Gold, Johnson 1972\nwl,n\n0.4,1.5\n0.6,1.6\n",
        "Gold; Johnson 1972\n\nwl,n\n0.4,1.5\n0.6,1.6\nSource: me\n",
        "Johnson and Christy 1972\nwl n\n0.4 1.5\n0.6 1.6\nSource: me, by hand\n",
    ],
)
def test_titles_above_a_table_and_notes_below_it_are_passed_over(tmp_path: Path, text: str) -> None:
    assert medium.read(written(tmp_path, text, "n.csv"))(500.0) == pytest.approx(1.55)


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16", "latin-1"])
def test_media_are_read_in_the_encodings_of_spectra(tmp_path: Path, encoding: str) -> None:
    file = tmp_path / "n.csv"
    file.write_bytes("Wavelength (\u00b5m),n\r\n0.4,1.5\r\n0.6,1.6\r\n".encode(encoding))
    assert medium.read(file)(500.0) == pytest.approx(1.55)
    file.write_bytes(b"\x89PNG\r\n\xff\xfe")
    with pytest.raises(InputError, match="not text; allowed: a table in UTF-8, UTF-16 or Latin-1"):
        medium.read(file)


@pytest.mark.parametrize("units", ["nm,1,1", "[nm],[],[]", "(nm),(-),(-)", "nm,,", "nm"])
@pytest.mark.parametrize("names", ["wl,n,k", "wavelength (nm),n,k", "lam/nm,refractive_index,k"])
def test_a_row_of_units_below_the_names_is_read(tmp_path: Path, names: str, units: str) -> None:
    found = medium.read(written(tmp_path, f"{names}\n{units}\n400,1.5,0.1\n700,1.4,0\n", "a.csv"))
    assert (found.first_nm, found.last_nm, found(400)) == (400, 700, 1.5 + 0.1j)


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("wl,n\nnm,n\n", "row 1 names columns, and no row of numbers"),
        ("wl (um),n\n[nm],[]\n0.4,1.5\n", "row 2 is a row of units and says '\\[nm\\]', and row 1"),
        ("wl,n\neV,1\n3,1.5\n", "row 2 is a row of units and says 'eV'; allowed: um or nm"),
        ("wl,n\n0.4,1.5\n0.5,0\n0.6,1.5\n", "row 3 has n = 0; allowed: above 0"),
        ("wl,n\n0.4,1.5\n0.5,-1\n", "row 3 has n = -1; allowed: above 0"),
        ("wl,n,k\n0.4,1.5,0\n0.5,1.5,-0.1\n", "row 3 has k = -0.1; allowed: 0 or more"),
    ],
)
def test_units_that_contradict_and_rows_of_no_medium_are_refused(
    tmp_path: Path, text: str, told: str
) -> None:
    with pytest.raises(InputError, match=told):
        medium.read(written(tmp_path, text, "a.csv"))


def test_no_index_is_drawn_towards_a_row_without_one(tmp_path: Path) -> None:
    text = "DATA:\n  - type: tabulated n\n    data: |\n      0.4 1.5\n      0.5 1.5\n      0.6 0\n"
    file = tmp_path / "medium.yml"
    file.write_text(text)
    found = medium.read(file)
    assert found(np.array([400.0, 450.0, 500.0])).real.tolist() == [1.5] * 3
    with pytest.raises(InputError, match="wavelength_nm is 550, beside a row"):
        found(550)
