"""Media as refractiveindex.info publishes them: its own database, published numbers, bad files."""

from __future__ import annotations

import math
import re
from importlib.util import find_spec
from pathlib import Path

import numpy as np
import pytest
import yaml

import nacreous as nc
from nacreous import medium
from nacreous.problem import InputError

#: In pyElli's folder, which is found without reading pyElli: every worker reads this file.
ELLI = Path(find_spec("elli").origin).parent
DATABASE = ELLI / "database" / "refractiveindexinfo-database" / "database"


def written(folder: Path, text: str, name: str = "medium.yml") -> Path:
    file = folder / name
    file.write_text(text, encoding="utf-8")
    return file


def formula(folder: Path, number: int, coefficients: str, span_um: str) -> medium.PublishedIndex:
    text = f"REFERENCES: |\n    a <i>book</i>\nDATA:\n  - type: formula {number}\n"
    text += f"    wavelength_range: {span_um}\n    coefficients: {coefficients}\n"
    return medium.read(written(folder, text))


#: Of formula 4: the first resonance's exponent, and no second one.
ONE_RESONANCE = "1 0 0 0 1"

#: Number, coefficients, range in um, a wavelength in um, its published index, and to how much.
PUBLISHED = [
    # Malitson 1965, table II: fused silica at D and at 1.06 um.
    (
        1,
        "0 0.6961663 0.0684043 0.4079426 0.1162414 0.8974794 9.896161",
        "0.21 6.7",
        0.5892938,
        1.458404,
        2e-6,
    ),
    (
        1,
        "0 0.6961663 0.0684043 0.4079426 0.1162414 0.8974794 9.896161",
        "0.21 6.7",
        1.06,
        1.449681,
        2e-6,
    ),
    # Schott's data sheet of N-BK7: n_d.
    (
        2,
        "0 1.03961212 0.00600069867 0.231792344 0.0200179144 1.01046945 103.560653",
        "0.3 2.5",
        0.5875618,
        1.51680,
        5e-6,
    ),
    # Hikari's J-PSK03: n_d.
    (
        3,
        "2.53267453 -0.00950416844 2 -0.000106883723 4 0.013439736 -2 0.000141770605 -4 "
        "4.7304388e-06 -6 -8.6200083e-08 -8",
        "0.37 2.05",
        0.5875618,
        1.603,
        5e-6,
    ),
    # Yttrium orthovanadate, both rays: sheets of its makers print equation and indices
    # (as quoted in Wikipedia).
    (4, f"3.77834 0.069736 0 0.04724 {ONE_RESONANCE} -0.0108133 2", "0.4 4", 1.30, 1.9500, 1e-4),
    (4, f"3.77834 0.069736 0 0.04724 {ONE_RESONANCE} -0.0108133 2", "0.4 4", 1.55, 1.9447, 1e-4),
    (4, f"4.59905 0.110534 0 0.04813 {ONE_RESONANCE} -0.012267612 2", "0.4 4", 1.30, 2.1554, 1e-4),
    (4, f"4.59905 0.110534 0 0.04813 {ONE_RESONANCE} -0.012267612 2", "0.4 4", 1.55, 2.1486, 1e-4),
    # Rheims et al. 1997: ethanol at 20 degrees; Chronological Scientific Tables 2000: n_D = 1.3618.
    (5, "1.35265 0.00306 -2 0.00002 -4", "0.4765 0.83", 0.5893, 1.3618, 3e-4),
    # Mansfield and Peck 1969: helium; Weber, Handbook of Optical Materials, 6.3, prints indices
    # that are all lower by 5e-8.
    (6, "0 0.01470091 423.98", "0.4799 2.0586", 0.479992, 1.00003498, 6e-8),
    (6, "0 0.01470091 423.98", "0.4799 2.0586", 1.013979, 1.00003470, 6e-8),
    (6, "0 0.01470091 423.98", "0.4799 2.0586", 2.058128, 1.00003464, 6e-8),
    # Edwards and Ochoa 1980: silicon; a maker of windows (PLIR Optics) prints 3.423 at 4.58 um, and
    # samples differ by 5e-3 (Frey, Leviton and Madison 2006).
    (7, "3.41983 0.159906 -0.123109 1.26878E-6 -1.95104E-9", "2.4373 25", 4.58, 3.423, 5e-3),
    # Schroeter 1931: silver bromide; a maker of windows (Crystran) prints 2.313, 2.25 and 2.24.
    (8, "0.452505 0.09939 0.070537 -0.000150", "0.495 0.67", 0.496, 2.313, 5e-4),
    (8, "0.452505 0.09939 0.070537 -0.000150", "0.495 0.67", 0.6, 2.25, 5e-3),
    (8, "0.452505 0.09939 0.070537 -0.000150", "0.495 0.67", 0.65, 2.24, 5e-3),
]


@pytest.mark.parametrize(("number", "coefficients", "span", "um", "index", "within"), PUBLISHED)
def test_every_formula_gives_the_published_index(
    tmp_path: Path,
    number: int,
    coefficients: str,
    span: str,
    um: float,
    index: float,
    within: float,
) -> None:
    found = formula(tmp_path, number, coefficients, span)
    assert found.source == "a <i>book</i>"
    n = found(np.array([1e3 * um]))[0]
    assert n.imag == 0
    assert n.real == pytest.approx(index, abs=within)


#: Number, coefficients and range as the database has them (its data are CC0), and what another
#: program (Optiland, tests/materials/test_file.py) makes of them, {wavelength in um: index}.
ELSEWHERE = [
    # Loiko et al. 2017: CaGdAlO4, ordinary ray.
    (
        4,
        "3.64863 0.03926 0 0.02239 1 0 0 0 0 -0.01121 2",
        "0.35 2.1",
        {0.4: 1.9829612788706874, 0.6: 1.9392994674994937, 1.5: 1.9081487808757178},
    ),
    # Amotchkina et al. 2020: ytterbium fluoride.
    (
        5,
        "1.484489 5.4996e-5 -2 2.6266e-3 -4",
        "0.4 14",
        {0.4: 1.5874342875, 1.0: 1.487170596, 5.0: 1.4844954023999999},
    ),
    # Bideau-Mehu et al. 1973: carbon dioxide.
    (
        6,
        "0 6.99100e-2 166.175 1.44720e-3 79.609 6.42941e-5 56.3064 5.21306e-5 46.0196 1.46847e-6 "
        "0.0584738",
        "0.1807 1.6945",
        {0.4: 1.0004592281255849, 1.0: 1.0004424189669583, 1.5: 1.0004386003514163},
    ),
    # Made up, with all six coefficients.
    (
        7,
        "1.0 0.58 0.12 0.87 0.21 0.81",
        "0.4 1.5",
        {0.4: 12.428885495537186, 1.0: 3.6137209774932684, 1.5: 13.532362213339358},
    ),
    # Schroeter 1931: silver bromide.
    (
        8,
        "0.452505 0.09939 0.070537 -0.000150",
        "0.495 0.67",
        {0.5: 2.3094520454859557, 0.55: 2.275584479878346, 0.65: 2.237243954654548},
    ),
    # Rosker, Cheng and Tang 1985: urea, extraordinary ray.
    (
        9,
        "2.51527 0.0240 0.0300 0.020 1.52 0.8771",
        "0.3 1.06",
        {0.3: 1.7043928702073146, 0.6: 1.605403788031452, 1.0: 1.5908956870937045},
    ),
]


@pytest.mark.parametrize(("number", "coefficients", "span", "index"), ELSEWHERE)
def test_every_formula_gives_another_programs_index(
    tmp_path: Path, number: int, coefficients: str, span: str, index: dict[float, float]
) -> None:
    found = formula(tmp_path, number, coefficients, span)
    n = found(1e3 * np.array(list(index)))
    np.testing.assert_allclose(n, list(index.values()), rtol=1e-12)


def test_terms_that_a_formula_leaves_out_are_0(tmp_path: Path) -> None:
    um = 0.55
    short = formula(tmp_path, 4, "2.25 0.01 0 0.02 1", "0.3 1")
    assert short(np.array([550.0]))[0] == pytest.approx(math.sqrt(2.25 + 0.01 / (um**2 - 0.02)))


#: By formula, how many coefficients "Dispersion formulas.pdf" has in whole terms.
WHOLE_TERMS = {
    **dict.fromkeys((1, 2, 3), (1, 3, 5, 7, 9, 11, 13, 15, 17)),
    4: (1, 5, 9, 11, 13, 15, 17),
    **dict.fromkeys((5, 6), (1, 3, 5, 7, 9, 11)),
    7: (1, 2, 3, 4, 5, 6),
    8: (1, 3, 4),
    9: (1, 3, 6),
}


@pytest.mark.parametrize("number", WHOLE_TERMS)
def test_half_a_term_of_a_formula_and_more_than_it_has_are_refused(
    tmp_path: Path, number: int
) -> None:
    for count in range(19):
        coefficients = " ".join(["0.01"] * count)
        if count in WHOLE_TERMS[number]:
            formula(tmp_path, number, coefficients, "0.3 1")
            continue
        has = f"formula {number} has {count} coefficients?; allowed: 1, .* or "
        with pytest.raises(InputError, match=rf"medium\.yml: DATA\[0\]: {has}"):
            formula(tmp_path, number, coefficients, "0.3 1")


def test_a_published_file_that_lacks_half_a_term_is_refused(tmp_path: Path) -> None:
    """Ordinary AgGaSe2 of Boyd as in the database; its extraordinary one has 1600 at the end."""
    with pytest.raises(InputError, match="formula 2 has 4 coefficients; allowed: 1, 3, 5, "):
        formula(tmp_path, 2, "3.6453 2.2057 0.1879 1.8377", "0.725 13.5")


def test_glasses_of_the_database_have_the_index_their_makers_publish() -> None:
    """Every 20th file with `nd`; two of the database's own have another n_d than their formula."""
    differences = []
    for file in sorted((DATABASE / "data" / "specs").rglob("*.yml"))[::20]:
        record = yaml.load(file.read_text(encoding="utf-8"), yaml.CSafeLoader)
        published = (record.get("PROPERTIES") or {}).get("nd") if "DATA" in record else None
        if published is None:
            continue
        glass = medium.read(file)
        if glass.first_nm <= 587.5618 <= glass.last_nm:
            n = glass(np.array([587.5618]))[0].real
            differences.append(abs(n - float(published)))
    assert len(differences) > 50
    assert np.median(differences) < 2e-6
    assert np.quantile(differences, 0.9) < 2e-5


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


def test_a_pole_of_a_formula_is_refused_without_a_warning(
    tmp_path: Path, recwarn: pytest.WarningsRecorder
) -> None:
    text = "DATA:\n  - type: formula 1\n    wavelength_range: 0.3 2\n    coefficients: 0 1 0.5\n"
    with pytest.raises(InputError, match="formula 1 has no n at 500 nm"):
        medium.read(written(tmp_path, text, "pole.yml"))(500.0)
    assert not recwarn.list


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
