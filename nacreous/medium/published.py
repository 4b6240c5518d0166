"""Media as refractiveindex.info publishes them."""

from __future__ import annotations

from os import PathLike

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nacreous.file import named, read_text
from nacreous.medium.dispersion import ALLOWED, Dispersion, fits
from nacreous.medium.record import parts_of_yaml
from nacreous.medium.table import parts_of_csv
from nacreous.number import array_of
from nacreous.problem import InputError
from nacreous.value import value_class

_LARGEST_MB = 10
_ENDINGS = (".yml", ".yaml", ".csv", ".txt", ".tsv")


@value_class
class PublishedIndex:
    """A medium of refractiveindex.info, isotropic; a pair of them is a uniaxial medium.

    Called with wavelengths in nm it gives n + ik. `first_nm` and `last_nm` are the range in which
    n, and k where it is given, are known; nothing is known beyond. `source` is the publication.
    """

    n: Dispersion
    k: Dispersion | None
    source: str

    @property
    def first_nm(self) -> float:
        """Shortest known wavelength."""
        return max(part.with_range()[0] for part in (self.n, self.k) if part is not None)

    @property
    def last_nm(self) -> float:
        """Longest known wavelength."""
        return min(part.with_range()[1] for part in (self.n, self.k) if part is not None)

    def __call__(self, wavelength_nm: ArrayLike) -> NDArray[np.complex128]:
        """Indices n + ik at these wavelengths, in their shape, a number for a number.

        Raises `InputError` where the medium is not known, and for what is no number.
        """
        nm = array_of("wavelength_nm", wavelength_nm)
        # Decimal um and binary nm: the last digit must not shut out a range's own ends.
        ends = self.first_nm * (1 - 1e-12), self.last_nm * (1 + 1e-12)
        beyond = ~((nm >= ends[0]) & (nm <= ends[1]))
        if beyond.any():
            raise InputError(
                f"wavelength_nm is {nm[beyond].flat[0]:g}; allowed with this medium: "
                f"{self.first_nm:g} to {self.last_nm:g} nm"
            )
        with np.errstate(all="ignore"):  # at a formula's poles, which are refused just below
            n = np.asarray(self.n.at(nm))
        if not np.isfinite(n).all():
            raise InputError(
                f"formula {self.n.formula} has no n at {nm[~np.isfinite(n)].flat[0]:g} nm"
            )
        _check("n", n, nm)
        self._check_rows(nm)
        index = n.astype(np.complex128)
        if self.k is not None:
            index.imag = self.k.at(nm)
            _check("k", index.imag, nm)
        return index[()]

    def _check_rows(self, nm: NDArray[np.float64]) -> None:
        """Refuse a wavelength beside a row whose n no medium has: the line to it means nothing."""
        if self.n.formula or fits("n", self.n.numbers).all():
            return
        wrong = np.interp(nm, self.n.nm, np.where(fits("n", self.n.numbers), 0.0, 1.0)) > 0
        if wrong.any():
            raise InputError(
                f"wavelength_nm is {nm[wrong].flat[0]:g}, beside a row of the file "
                f"whose n is not {ALLOWED['n']}; allowed: between rows with n {ALLOWED['n']}"
            )

    def __repr__(self) -> str:
        """How n is given, and the range."""
        n = f"formula {self.n.formula}" if self.n.formula else f"{self.n.nm.size} rows"
        k = "" if self.k is None else ", k"
        return f"PublishedIndex({n}{k}, {self.first_nm:g} to {self.last_nm:g} nm)"


def read(path: str | PathLike[str]) -> PublishedIndex:
    r"""A medium from a file of refractiveindex.info, as published: YAML or CSV.

    path: a `.yml` or `.yaml` of the database, or a `.csv` (`.txt`, `.tsv`) of its download.
    UTF-8, UTF-16 or Latin-1, at most 10 MB. All nine dispersion formulas and the tables of n, of k
    and of both are read; between the rows of a table lie straight lines. A CSV's first column is a
    wavelength in um, or in nm where its name says so; another quantity there is refused by its
    name. Without k the medium is lossless. Wavelengths are taken as in vacuum and n as absolute: in
    air both would differ by 0.03 %.

    Raises `InputError` that names the file and what is wrong in it, such as a table in which no n
    is above 0, or every k below it. Single rows of that kind are refused in a
    CSV by their number; in YAML, as some tables of the database have them, where a wavelength is
    asked for that needs them.

    >>> from pathlib import Path
    >>> from tempfile import TemporaryDirectory
    >>> text = "DATA:\n  - type: formula 2\n    wavelength_range: 0.3 2.5\n    coefficients: "
    >>> bk7 = "0 1.03961212 0.00600069867 0.231792344 0.0200179144 1.01046945 103.560653"
    >>> with TemporaryDirectory() as folder:
    ...     file = Path(folder) / "N-BK7.yml"
    ...     _ = file.write_text(text + bk7)
    ...     glass = read(file)
    >>> glass
    PublishedIndex(formula 2, 300 to 2500 nm)
    >>> round(float(glass(np.array([587.6]))[0].real), 4)
    1.5168
    """
    place = named(path)
    is_yaml = place.suffix.lower() in _ENDINGS[:2]
    if place.suffix.lower() not in _ENDINGS:
        raise InputError(
            f"{path}: the ending is {place.suffix or 'missing'}; allowed: {', '.join(_ENDINGS)}"
        )
    text = read_text(place, _LARGEST_MB)
    try:
        parts, source = parts_of_yaml(text) if is_yaml else (parts_of_csv(text), "")
        if "n" not in parts:
            raise InputError("n is missing; allowed: n, or n and k")
        found = PublishedIndex(parts["n"], parts.get("k"), source)
        if found.first_nm > found.last_nm:
            raise InputError("n and k share no wavelength; allowed: ranges that overlap")
    except InputError as problem:
        raise InputError(f"{path}: {problem}") from None
    return found


def _check(name: str, values: NDArray[np.float64], nm: NDArray[np.float64]) -> None:
    wrong = ~fits(name, values)
    if wrong.any():
        raise InputError(
            f"{name} is {values[wrong].flat[0]:g} at {nm[wrong].flat[0]:g} nm in the medium's "
            f"file; allowed: {ALLOWED[name]}"
        )
