"""Lights by name, and spectra from files."""

from __future__ import annotations

from pathlib import Path

from nacreous import _core
from nacreous.colour.samples import Array
from nacreous.file import read_text

_LARGEST_MB = 1


def illuminant(name: str) -> Array:
    """Relative spectrum of a light, float64 `[401]`, 1 at 560 nm.

    `name` is `A` (tungsten), `D50`, `D55`, `D65`, `D75` (daylight), `C` (daylight by filter, of
    1931), `E` (equal energy), a fluorescent lamp `FL1` to `FL12`, a white LED `LED-B1` to `LED-B5`,
    `LED-BH1`, `LED-RGB1`, `LED-V1`, `LED-V2`, all from the tables of CIE 015:2018; or a colour
    temperature from `1000K` to `25000K`: CIE daylight from 4000 K up, Planck's law below.

    Raises `InputError` for any other name.

    >>> from nacreous.colour import WAVELENGTH_NM
    >>> lamp = illuminant("2700K")
    >>> bool(lamp[WAVELENGTH_NM == 650] > lamp[WAVELENGTH_NM == 450])
    True
    """
    return _core.illuminant_spectrum(str(name))


def spectrum_from_csv(path: str | Path) -> Array:
    r"""Spectrum in a file as instruments write it, float64 `[401]`, 380 to 780 nm by 1 nm.

    Two columns, wavelength in nm and value, between semicolons, tabs, commas or blanks, with
    decimal points or commas, one of them in the whole file, and exponents with E or D; wavelengths
    rise or fall, in any steps.
    Lines before and after the numbers are passed over, `#` begins a comment. UTF-8, UTF-16 or
    Latin-1, at most 1 MB.

    Values between samples lie on straight lines. Of samples finer than 1 nm each value is the mean
    over the nm around it, so that no line of a spectrum is missed. The file covers at least 400 to
    700 nm; beyond its ends the nearest value stands, as CIE 015 allows. Values below 0 down to -5 %
    of the largest are noise and count as 0 **(ours)**.

    Raises `InputError` naming the file, and the line where one is at fault.

    >>> import tempfile
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     file = Path(folder) / "lamp.csv"
    ...     _ = file.write_text("Wavelength [nm];Counts\n780,0;4,0\n380,0;-0,1\n")
    ...     float(spectrum_from_csv(file)[100])
    1.0
    """
    return _core.spectrum_from_csv(read_text(path, _LARGEST_MB), str(path))


def light(name_or_path: str) -> Array:
    """Relative spectrum of a light given as files of scenes give it: a name, or a table's path.

    >>> bool((light("D65") == illuminant("D65")).all())
    True
    """
    if name_or_path.lower().endswith(".csv"):
        return spectrum_from_csv(name_or_path)
    return illuminant(name_or_path)
