"""What is no published medium, each refused in one line."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

import nacreous as nc
from nacreous import medium
from nacreous.problem import InputError
from tests.optics.published_files import written


@pytest.mark.parametrize(
    ("name", "text", "message"),
    [
        ("a.yml", "DATA: [\n", "no YAML in line 2; allowed: a file of refractiveindex.info"),
        (
            "a.yml",
            "DATA:\n  - type: tabulated n\nDATA:\n  - type: formula 1",
            "DATA is given in lines 1 and 3; allowed: once",
        ),
        (
            "a.yml",
            "DATA:\n  - type: formula 5\n    coefficients: 1.5\n    coefficients: 1.6",
            "coefficients is given in lines 3 and 4; allowed: once",
        ),
        ("a.yml", "- 1", "YAML that holds a list; allowed: a file of refractiveindex.info"),
        (
            "a.yml",
            "DATA:\n  - type: formula 10",
            "DATA[0]: type is 'formula 10'; allowed: formula 1 to",
        ),
        ("a.yml", "DATA:\n  - 7", "DATA[0]: type is 'missing'; allowed: formula 1 to"),
        (
            "a.yml",
            "DATA:\n  - type: tabulated k\n    data: |\n      0.4 0.1",
            "n is missing; allowed: n, or",
        ),
        (
            "a.yml",
            "DATA:\n  - type: tabulated n\n    data: |\n      0.4 x",
            "DATA[0]: data, row 1 has 'x'",
        ),
        (
            "a.yml",
            "DATA:\n  - type: formula 5\n    wavelength_range: 1 0.3\n    coefficients: 1.5",
            "DATA[0]: wavelength_range is 1 to 0.3; allowed: rising",
        ),
        ("a.csv", "wl,m\n0.4,1.5\n", "row 1: columns are ['m']; allowed: wl, then n, k or both"),
        ("a.csv", "wl,n\n0.4,1.5,2\n", "row 2 has 3 numbers; allowed: 2"),
        ("a.csv", "", "n is missing; allowed: n, or n and k"),
        ("a.json", "{}", "the ending is .json; allowed: .yml, .yaml, .csv, .txt, .tsv"),
    ],
)
def test_what_is_no_published_medium_is_refused_in_one_line(
    tmp_path: Path, name: str, text: str, message: str
) -> None:
    file = written(tmp_path, text, name)
    with pytest.raises(nc.InputError) as caught:
        medium.read(file)
    assert str(caught.value).startswith(f"{file}: {message}")
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(
    ("name", "text", "message"),
    [
        ("a.csv", "wl,n\n0.4,1_5\n", "row 2 has '1_5'; allowed: finite numbers"),
        ("a.csv", "wl,n\n0.4,1.5\nnan,1.6\n", "row 3 has 'nan'; allowed: finite numbers"),
        ("a.csv", "wl,n\n0.0,1.5\n", "row 2 has wavelength 0; allowed: above 0"),
        ("a.csv", 'wl,n\n0.4,"' + "1" * 200_000, "no table (field larger than field limit"),
        (
            "a.yml",
            "DATA:\n  - type: tabulated n\n    data: |\n      # wl n\n      -0.4 1.5\n",
            "data, row 1 has wavelength -0.4; allowed: above 0",
        ),
        ("a.csv", "wl,n\n0.4,-1.5\n0.6,0\n", "row 2 has n = -1.5, and no row has above 0"),
        ("a.csv", "wl,n,k\n0.4,1.5,-0.1\n", "row 2 has k = -0.1, and no row has 0 or more"),
        (
            "a.yml",
            "DATA:\n  - type: tabulated nk\n    data: |\n      0.4 1.5 -1\n      0.5 1.5 -2\n",
            "DATA[0]: data, row 1 has k = -1, and no row has 0 or more; allowed: k 0 or more",
        ),
    ],
)
def test_a_row_that_cannot_be_is_named(tmp_path: Path, name: str, text: str, message: str) -> None:
    with pytest.raises(InputError, match=re.escape(message)):
        medium.read(written(tmp_path, text, name))


def test_an_index_that_cannot_be_is_refused_where_it_is_asked(tmp_path: Path) -> None:
    """Published tables of metals and glasses hold a few such rows among good ones."""
    text = "DATA:\n  - type: formula 5\n    wavelength_range: 0.3 2\n    coefficients: -1.5\n"
    with pytest.raises(
        InputError, match=r"n is -1.5 at 500 nm in the medium's file; allowed: above"
    ):
        medium.read(written(tmp_path, text, "below.yml"))(500.0)
    text = "DATA:\n  - type: tabulated nk\n    data: |\n"
    text += "      0.4 -6 0\n      0.5 1.5 0\n      0.6 1.5 -1e-6\n"
    noisy = medium.read(written(tmp_path, text))
    assert noisy(500.0) == 1.5
    for nm, message in ((400.0, "n is -6 at 400 nm"), (600.0, "k is -1e-06 at 600 nm")):
        with pytest.raises(InputError, match=message):
            noisy(nm)
        with pytest.raises(InputError, match=message):
            nc.optics.energies(nc.LayerStack([300.0], 20.0, noisy, 1.43), 0.0, np.array([nm]))


@pytest.mark.parametrize("path", [None, 5, "a\0.yml"])
def test_a_path_that_cannot_be_is_refused_in_words(path: object) -> None:
    for reader in (medium.read, nc.colour.spectrum_from_csv, nc.file.read_panorama):
        with pytest.raises(InputError, match=r"path is .*; allowed: the path"):
            reader(path)  # type: ignore[operator]


@pytest.mark.parametrize("text", ["[" * 50_000, "{a: " * 50_000, "- " * 50_000 + "a"])
def test_what_is_nested_too_deeply_is_refused_before_it_is_parsed(tmp_path, text):
    with pytest.raises(InputError, match=r"line 1: nested too deeply; allowed: 32 levels$"):
        medium.read(written(tmp_path, text))


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("- - a\n  - b\n", "YAML that holds a list"),
        ("just words", "YAML that holds no keys"),
        ("DATA: []\n---\nDATA: []\n", "line 2 begins another document"),
        ("---\nDATA: []\n...\n---\nDATA: []\n", "line 4 begins another document"),
    ],
)
def test_yaml_of_another_kind_is_called_what_it_is(tmp_path, text, told):
    with pytest.raises(InputError, match=rf"medium\.yml: {told}.*; allowed: "):
        medium.read(written(tmp_path, text))
