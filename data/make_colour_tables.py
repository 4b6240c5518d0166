"""Make the colour tables of this folder again from colour-science (a development dependency).

Run `python data/make_colour_tables.py` in the repository root; the files come out byte for byte.
"""

import warnings
from collections.abc import Iterable
from pathlib import Path

import numpy as np

with warnings.catch_warnings():
    warnings.simplefilter("ignore")  # colour-science warns of optional packages it does not find
    import colour
    from colour.colorimetry import SDS_BASIS_FUNCTIONS_CIE_ILLUMINANT_D_SERIES

FOLDER = Path(__file__).parent
WAVELENGTH_NM = np.arange(380, 781)
TAKEN = f"Taken from colour-science {colour.__version__} by make_colour_tables.py."
LINEAR = (
    "Tabulated by the CIE every 5 nm, here at 1 nm by linear interpolation, as CIE 015 says\n"
    "for illuminants of the D series."
)


def write(name: str, about: str, columns: str, rows: Iterable[Iterable[object]]) -> None:
    """Write one table: its source as comments, then the column names, then the rows."""
    comments = [f"# {line}" for line in f"{about}\n{TAKEN}".splitlines()]
    lines = [",".join(str(cell) for cell in row) for row in rows]
    text = "\n".join([*comments, columns, *lines]) + "\n"
    (FOLDER / name).write_text(text, encoding="utf-8", newline="\n")


def spectral_rows(*tables: colour.SpectralDistribution) -> list[list[object]]:
    """Rows of wavelength_nm and one value a table; twelve decimals hold all that is published."""
    columns = [
        np.interp(WAVELENGTH_NM, table.wavelengths, np.asarray(table.values)) for table in tables
    ]
    return [
        [nm, *(f"{value:.12g}" for value in np.round(row, 12) + 0.0)]  # + 0.0: no "-0"
        for nm, row in zip(WAVELENGTH_NM, np.stack(columns, axis=1), strict=True)
    ]


def write_observers() -> None:
    """Both observers are published at 1 nm: nothing is interpolated."""
    for name, key, source in (
        (
            "cie_1931_2_degree.csv",
            "CIE 1931 2 Degree Standard Observer",
            "CIE 1931 2-degree standard observer at 1 nm (ISO/CIE 11664-1).",
        ),
        (
            "cie_1964_10_degree.csv",
            "CIE 1964 10 Degree Standard Observer",
            "CIE 1964 10-degree standard observer at 1 nm (ISO/CIE 11664-1).",
        ),
    ):
        functions = colour.MSDS_CMFS[key].to_sds()
        write(name, source, "wavelength_nm,x,y,z", spectral_rows(*functions))


def write_illuminants() -> None:
    """D50, D65 and the three components that daylight of any temperature is made of."""
    for name in ("D50", "D65"):
        write(
            f"cie_{name.lower()}.csv",
            f"CIE illuminant {name}, 100 at 560 nm (ISO/CIE 11664-2).\n{LINEAR}",
            "wavelength_nm,value",
            spectral_rows(colour.SDS_ILLUMINANTS[name]),
        )
    components = SDS_BASIS_FUNCTIONS_CIE_ILLUMINANT_D_SERIES
    write(
        "cie_daylight_components.csv",
        "CIE daylight components S0, S1, S2 (CIE 015, Judd, MacAdam and Wyszecki 1964).\n" + LINEAR,
        "wavelength_nm,s0,s1,s2",
        spectral_rows(*(components[name] for name in ("S0", "S1", "S2"))),
    )


def write_lamps() -> None:
    """Illuminants C, D55 and D75, fluorescent lamps and LEDs, as the CIE tabulates them."""
    names = [
        *("C", "D55", "D75"),
        *(f"FL{number}" for number in range(1, 13)),
        *(f"LED-B{number}" for number in range(1, 6)),
        *("LED-BH1", "LED-RGB1", "LED-V1", "LED-V2"),
    ]
    rows = [
        [nm, *(f"{float(colour.SDS_ILLUMINANTS[name][nm]):.12g}" for name in names)]
        for nm in range(380, 781, 5)
    ]
    write(
        "cie_lamps.csv",
        "CIE illuminants C, D55, D75, fluorescent lamps FL1 to FL12 and LEDs at 5 nm (CIE "
        "015:2018,\ntables 5, 6, 10 and 12), as tabulated; the program interpolates linearly.",
        ",".join(["wavelength_nm", *names]),
        rows,
    )


def write_renotation() -> None:
    """The Munsell colours that exist as pigments, of value 2 and more."""
    rows = [
        [hue, f"{value:g}", f"{chroma:g}", *(f"{number:.12g}" for number in xyY)]
        for (hue, value, chroma), xyY in colour.MUNSELL_COLOURS["Munsell Colours Real"]
        if value >= 2
    ]
    write(
        "munsell_renotation.csv",
        "Munsell renotation, real colours of value 2 and more, under illuminant C, 2-degree\n"
        "observer (Newhall, Nickerson and Judd 1943; file real.dat of the Munsell Color Science\n"
        "Laboratory, Rochester). Y is in percent of magnesium oxide: times 0.975 it is in percent\n"
        "of the perfect reflecting diffuser.",
        "hue,value,chroma,x,y,luminance_percent",
        rows,
    )


if __name__ == "__main__":
    write_observers()
    write_illuminants()
    write_lamps()
    write_renotation()
