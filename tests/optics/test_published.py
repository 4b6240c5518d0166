"""Media as refractiveindex.info publishes them: its own database, tables and their forms."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import nacreous as nc
from nacreous import medium
from nacreous.problem import InputError
from tests.optics.published_files import DATABASE, formula, written


def test_the_database_is_read_as_published() -> None:
    """Every 40th file, tables of n, k, nk and formulas; those without n are refused by name."""
    read = refused = 0
    for file in sorted((DATABASE / "data").rglob("*.yml"))[::40]:
        if file.name == "about.yml" or "n2" in file.parts:
            continue
        try:
            found = medium.read(file)
        except nc.InputError as problem:
            # One glass states a range of its formula in which its k is not known.
            known = ("n is missing", "n and k share no wavelength")
            assert any(reason in str(problem) for reason in known)  # noqa: PT017, most files pass
            refused += 1
            continue
        n = found(np.array([found.first_nm, found.last_nm]))
        assert np.isfinite(n).all()
        read += 1
    assert read > 70
    assert refused <= 3


def test_tables_and_their_csv_are_straight_lines_between_rows(tmp_path: Path) -> None:
    nk = (
        "DATA:\n  - type: tabulated nk\n    data: |\n        0.4 1.47 1.95\n        0.6 0.25 3.07\n"
    )
    gold = medium.read(written(tmp_path, nk))
    blocks = "wl,n\n0.4,1.47\n0.6,0.25\n\nwl,k\n0.4,1.95\n0.6,3.07\n"
    columns = "wavelength [nm];n;k\n600;0.25;3.07\n400;1.47;1.95\n"
    bare = "0.4\t1.47\t1.95\n0.6\t0.25\t3.07\n"
    at = np.array([400.0, 500.0, 600.0])
    expected = [1.47 + 1.95j, 0.86 + 2.51j, 0.25 + 3.07j]
    np.testing.assert_allclose(gold(at), expected, rtol=1e-12)
    for text in (blocks, columns, bare):
        again = medium.read(written(tmp_path, text, "gold.csv"))
        np.testing.assert_allclose(again(at), expected, rtol=1e-12)
    # Where two measurements meet, their mean.
    twice = medium.read(written(tmp_path, "wl,n\n0.4,1.5\n0.5,1.6\n0.5,1.8\n0.6,1.9\n", "n.csv"))
    assert twice(np.array([500.0]))[0] == pytest.approx(1.7)


def test_published_media_are_media_of_layers(tmp_path: Path) -> None:
    """A pair of files is a uniaxial medium, and equal to a table of its indices."""
    o = formula(tmp_path, 5, "1.68 0.002 -2", "0.3 1")
    e = formula(tmp_path, 5, "1.53 0.001 -2", "0.3 1")
    nm = np.array([450.0, 550.0, 650.0])
    table = medium.IndexTable(nm, o(nm), e(nm))
    layers = [380.0, 402.0, 391.0]
    ours = nc.optics.energies(nc.LayerStack(layers, aragonite=(o, e)), [0.0, 1.0], nm)
    assert ours == nc.optics.energies(nc.LayerStack(layers, aragonite=table), [0.0, 1.0], nm)
    half = nc.optics.energies(nc.LayerStack(layers, aragonite=(o, 1.53)), 0.0, nm)
    whole = nc.optics.energies(nc.LayerStack(layers, aragonite=o), 0.0, nm)
    np.testing.assert_allclose(half.R, whole.R, rtol=0, atol=1e-13)  # head on n_e plays no part
    with pytest.raises(
        nc.InputError, match="wavelength_nm is 1200; allowed with this medium: 300 to 1000"
    ):
        nc.optics.energies(nc.LayerStack(layers, aragonite=o), 0.0, 1200.0)


def test_a_mediums_function_may_return_a_number() -> None:
    nm = [450.0, 550.0]
    for constant, one in (
        (lambda nm: 1.53, 1.53),
        (lambda nm: 1.53 + 0.01j, 1.53 + 0.01j),
        (lambda nm: np.float64(1.6), 1.6),
        (lambda nm: (1.68, 1.53), (1.68, 1.53)),
        (lambda nm: (1.68 + 0 * nm, 1.53), (1.68, 1.53)),
    ):
        called = nc.optics.energies(nc.LayerStack([400.0] * 5, aragonite=constant), [0.0, 1.0], nm)
        given = nc.optics.energies(nc.LayerStack([400.0] * 5, aragonite=one), [0.0, 1.0], nm)
        np.testing.assert_allclose(called.R, given.R, rtol=0, atol=1e-13)


def test_a_medium_takes_a_number_as_it_takes_an_array(tmp_path: Path) -> None:
    found = medium.read(written(tmp_path, "wl,n,k\n0.4,1.5,0.1\n0.6,1.7,0.3\n", "nk.csv"))
    for nm in (500.0, 500, np.float32(500), np.array(500.0)):
        assert found(nm) == pytest.approx(1.6 + 0.2j)
    assert found([[500.0], [600.0]]).shape == (2, 1)
    with pytest.raises(InputError, match="wavelength_nm is 'a'; allowed: numbers"):
        found("a")


@pytest.mark.parametrize(
    "text",
    [
        "wl,n\r0.4,1.5\r0.6,1.6\r",
        "wl;n\n0,4;1,5\n0,6;1,6\n",
        "wl n\n0.4 1.5\n0.6  1.6\n",
        "# from a bench\nwl,n,\n0.4,1.5,\n0.6,1.6, # last\n",
    ],
    ids=["CR", "decimal commas", "blanks", "comments"],
)
def test_tables_say_the_same_however_they_are_written(tmp_path: Path, text: str) -> None:
    assert medium.read(written(tmp_path, text, "n.csv"))(500.0) == pytest.approx(1.55)


def test_exponents_of_fortran_are_read(tmp_path: Path) -> None:
    bk7 = "1.03961212 0.00600069867 0.231792344 0.0200179144 1.01046945 103.560653"
    fortran = "0.D0 1.03961212 0.600069867D-02 0.231792344D+0 2.00179144d-2 1.01046945 103.560653"
    assert formula(tmp_path, 2, fortran, "0.3D0 2.5") == formula(tmp_path, 2, f"0 {bk7}", "0.3 2.5")
    plain = medium.read(written(tmp_path, "0.4,1.5\n0.7,1.6\n", "plain.csv"))
    assert medium.read(written(tmp_path, "4.0D-01,1.5\n0.7,0.16D+01\n", "d.csv")) == plain


def test_older_copies_of_the_database_call_the_range_range(tmp_path: Path) -> None:
    text = "DATA:\n  - type: formula 5\n    wavelength_range: 0.3 2\n    coefficients: 1.5\n"
    new = medium.read(written(tmp_path, text, "new.yml"))
    older = text.replace("wavelength_range", "range")
    assert medium.read(written(tmp_path, older, "old.yml")) == new
    lacking = text.replace("    wavelength_range: 0.3 2\n", "")
    with pytest.raises(
        InputError, match=r"DATA\[0\]: wavelength_range is missing; allowed: two num"
    ):
        medium.read(written(tmp_path, lacking, "lacking.yml"))


@pytest.mark.parametrize(
    "header",
    [
        "wl,n,k",
        "Wavelength [\u00b5m],Refractive index n,Extinction coefficient k",
        "Wavelength (\u03bcm),Refractive index (n),Extinction coefficient (k)",
        "\u03bb/\u00b5m,n (refractive index),k (extinction coefficient)",
        "lambda (\u03bcm),Refractive index,Extinction coefficient",
        "Wellenlänge in \u00b5m,Brechungsindex n,Extinktionskoeffizient k",
        "波長 (\u00b5m),屈折率,消衰係数",
    ],
)
def test_a_header_in_words_says_what_letters_say(tmp_path: Path, header: str) -> None:
    rows = [(0.4, 1.5, 0.1), (0.7, 1.4, 0.0)]
    lines = "".join("{},{},{}\n".format(*row) for row in rows)
    read = medium.read(written(tmp_path, f"{header}\n{lines}", "words.csv"))
    assert read(400.0) == 1.5 + 0.1j
    if "\u00b5m" in header or "\u03bcm" in header:
        in_nm = header.replace("\u00b5m", "nm").replace("\u03bcm", "nm")
        lines = "".join(f"{1e3 * um:g},{n},{k}\n" for um, n, k in rows)
        assert medium.read(written(tmp_path, f"{in_nm}\n{lines}", "nm.csv"))(400.0) == 1.5 + 0.1j


def test_columns_in_another_order_are_taken_by_their_names(tmp_path: Path) -> None:
    text = "Wavelength [nm],Extinction coefficient k,Refractive index n\n400,0.1,1.5\n700,0,1.4\n"
    assert medium.read(written(tmp_path, text, "turned.csv"))(400.0) == 1.5 + 0.1j
