"""Dispersion formulas: published indices, and those of another program."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
import yaml

from nacreous import medium
from nacreous.problem import InputError
from tests.optics.published_files import DATABASE, formula, written

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


def test_a_pole_of_a_formula_is_refused_without_a_warning(
    tmp_path: Path, recwarn: pytest.WarningsRecorder
) -> None:
    text = "DATA:\n  - type: formula 1\n    wavelength_range: 0.3 2\n    coefficients: 0 1 0.5\n"
    with pytest.raises(InputError, match="formula 1 has no n at 500 nm"):
        medium.read(written(tmp_path, text, "pole.yml"))(500.0)
    assert not recwarn.list
