"""Lights from the CIE's tables, and spectra from files as instruments write them."""

import warnings
from pathlib import Path

import numpy as np
import pytest

from nacreous import colour as nc
from nacreous.problem import InputError

with warnings.catch_warnings():
    # It warns of optional packages (plots, graphs) that it does not find.
    warnings.simplefilter("ignore")
    import colour as peer

#: x, y for the observer of 1931 (CIE 015:2018, tables 10 and 12 and 8.3).
CHROMATICITY = {
    "C": (0.31006, 0.31616),
    "D55": (0.33243, 0.34744),
    "D75": (0.29903, 0.31488),
    "FL1": (0.3131, 0.3371),
    "FL2": (0.3721, 0.3751),
    "FL3": (0.4091, 0.3941),
    "FL4": (0.4402, 0.4031),
    "FL5": (0.3138, 0.3452),
    "FL6": (0.3779, 0.3882),
    "FL7": (0.3129, 0.3292),
    "FL8": (0.3458, 0.3586),
    "FL9": (0.3741, 0.3727),
    "FL10": (0.3458, 0.3588),
    "FL11": (0.3805, 0.3769),
    "FL12": (0.4370, 0.4042),
    "LED-B1": (0.4560, 0.4078),
    "LED-B2": (0.4357, 0.4012),
    "LED-B3": (0.3756, 0.3723),
    "LED-B4": (0.3422, 0.3502),
    "LED-B5": (0.3118, 0.3236),
    "LED-BH1": (0.4474, 0.4066),
    "LED-RGB1": (0.4557, 0.4211),
    "LED-V1": (0.4548, 0.4044),
    "LED-V2": (0.3781, 0.3775),
}


@pytest.mark.parametrize("name", CHROMATICITY)
def test_lights_of_the_cie_have_their_published_chromaticity(name: str) -> None:
    x, y, z = nc.white_xyz(name)
    found = np.array([x, y]) / (x + y + z)
    # Tables by 5 nm, sums by 1 nm: the narrow lines of FL10 to FL12 move by 2e-4.
    np.testing.assert_allclose(found, CHROMATICITY[name], atol=4e-4)


@pytest.mark.parametrize("name", CHROMATICITY)
def test_lights_of_the_cie_are_those_of_the_peer(name: str) -> None:
    table = peer.SDS_ILLUMINANTS[name]
    expected = np.interp(nc.WAVELENGTH_NM, table.wavelengths, table.values) / table[560]
    np.testing.assert_allclose(nc.illuminant(name), expected, rtol=1e-12)
    if name.startswith("FL"):
        np.testing.assert_array_equal(nc.illuminant(name.replace("FL", "F")), nc.illuminant(name))


# --- files as instruments write them


def spectrum_of(folder: Path, content: str, encoding: str = "utf-8") -> np.ndarray:
    file = folder / "measured.csv"
    file.write_bytes(content.encode(encoding))
    return nc.spectrum_from_csv(file)


def test_what_spectrometers_write_is_one_spectrum(tmp_path: Path) -> None:
    nm = np.arange(360, 831, 10)
    value = 0.2 + 0.6 / (1 + np.exp((600 - nm) / 20))
    expected = np.interp(nc.WAVELENGTH_NM, nm, value)
    plain = [f"{a:.1f},{b:.15f}" for a, b in zip(nm, value, strict=True)]
    comma = [row.replace(",", ";").replace(".", ",") for row in plain]
    tabs = [row.replace(",", "\t") for row in plain]
    for content in (
        "\n".join(plain),
        "sep=;\r\nWellenl\u00e4nge [nm];R\u00fcckstrahlung\r\n" + "\r\n".join(comma) + "\r\n",
        "\n".join(["Data from a file", "Integration Time (usec): 100000", "", *tabs[::-1]]),
        ">>>>>Begin Spectral Data<<<<<\n" + "\n".join(tabs) + "\n>>>>>End Spectral Data<<<<<\n",
        "\n".join(row.replace("\t", "   ") for row in tabs),
        "\n".join('"' + row.replace(",", '","') + '"' for row in plain),
        "\n".join(row.replace(".", ",") for row in tabs),
    ):
        for encoding in ("utf-8", "utf-8-sig", "utf-16", "latin-1"):
            found = spectrum_of(tmp_path, content, encoding)
            np.testing.assert_allclose(found, expected, rtol=0, atol=1e-12)


def test_fine_samples_are_averaged_so_that_noise_and_lines_are_not_picked(tmp_path: Path) -> None:
    """0.1 nm steps: the noise of a value falls to about its root of 10; the sum over all stays."""
    nm = np.arange(3700, 7901) / 10
    noisy = 1 + np.random.default_rng(2).normal(0, 0.1, nm.size)
    found = spectrum_of(tmp_path, "\n".join(f"{a};{b:.9f}" for a, b in zip(nm, noisy, strict=True)))
    assert (found - 1).std() == pytest.approx(0.1 / np.sqrt(10), rel=0.15)
    inside = (nm > 379.45) & (nm < 780.55)
    assert found.sum() == pytest.approx(np.trapezoid(noisy[inside], nm[inside]), rel=1e-6)


def test_exponents_of_fortran_are_read(tmp_path: Path) -> None:
    found = spectrum_of(tmp_path, " 0.38000D+03   0.11833D+00\n 0.78000D+03   0.11833D+00\n")
    assert (found == 0.11833).all()


def test_noise_counts_as_zero_and_short_ends_are_the_nearest_value(tmp_path: Path) -> None:
    found = spectrum_of(tmp_path, "400;-0,002\n500;0,5\n700;0,9\n")
    assert found[:21].tolist() == [0.0] * 21
    assert found[320:].tolist() == [0.9] * 81


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (b"", ": 0 rows of numbers; allowed: at least 2"),
        (
            b"nm,value\n380 nm,1\n780 nm,1\n",
            ': 0 rows of numbers, and line 2 has "380 nm"; allowed: at least 2 of numbers alone',
        ),
        (b"380,1\n690,1\n", ": wavelength_nm is 380.0 to 690.0; missing: 690.0 to 700.0 nm"),
        (
            b"380,1\n780,-1\n",
            ", line 2: value is -1.0; allowed: 0 to 1e12 (noise down to -0.05 counts as 0)",
        ),
        (b"\x89PNG\r\n\xff\xfe", ": not text; allowed: a table in UTF-8, UTF-16 or Latin-1"),
        (b"#" * 1_000_001, ": more than 1 MB; allowed: up to 1 MB"),
    ],
)
def test_spectrum_files_are_refused_by_name(tmp_path: Path, content: bytes, message: str) -> None:
    file = tmp_path / "lamp.csv"
    file.write_bytes(content)
    with pytest.raises(InputError) as refusal:
        nc.spectrum_from_csv(file)
    assert str(refusal.value) == f"{file}{message}"


def test_a_folder_and_a_missing_file_are_no_spectra(tmp_path: Path) -> None:
    for path in (tmp_path, tmp_path / "none.csv"):
        with pytest.raises(InputError, match=r"is a folder|does not exist"):
            nc.spectrum_from_csv(path)


def test_spectrum_file_is_interpolated_linearly(tmp_path: Path) -> None:
    file = tmp_path / "lamp.csv"
    wavelength_nm = np.array([300.0, 400.0, 401.5, 620.0, 800.0])
    values = np.array([0.0, 2.0, 1.0, 5.0, 0.5])
    rows = [f"{nm},{value}" for nm, value in zip(wavelength_nm, values, strict=True)]
    file.write_text("\n".join(["# lamp", "wavelength_nm,value", *rows]))
    expected = np.interp(nc.WAVELENGTH_NM, wavelength_nm, values)
    np.testing.assert_allclose(nc.spectrum_from_csv(file), expected, rtol=1e-13)
