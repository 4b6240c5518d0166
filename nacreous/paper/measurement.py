"""A number measured on our own pictures, beside what the paper asks of it."""

from __future__ import annotations

from dataclasses import dataclass

__all__ = ["Measurement"]


@dataclass(frozen=True)
class Measurement:
    """One measured number and the range in which the paper's sentence holds.

    quantity: what was measured, in words. value: what came out. least, most: the range, its ends
    included; a number without either is told for information only.

    >>> Measurement("reflectance at 0 degrees", 0.0439, least=0.04385, most=0.04395).holds
    True
    >>> Measurement("reflectance at 0 degrees", float("nan"), least=0.0, most=1.0).holds
    False
    """

    quantity: str
    value: float
    unit: str = ""
    least: float | None = None
    most: float | None = None

    @property
    def holds(self) -> bool | None:
        """Whether the value is in range; None where nothing is asked. NaN is never in range."""
        if self.least is None and self.most is None:
            return None
        above = self.least is None or self.value >= self.least
        below = self.most is None or self.value <= self.most
        return bool(self.value == self.value and above and below)

    @property
    def shown(self) -> str:
        """The value as people read it, with its unit.

        >>> Measurement("angle", 40.8132, "°").shown
        '40.81°'
        """
        return self._with_unit(_plain(self.value, 4))

    @property
    def criterion(self) -> str:
        """The range in words; empty where nothing is asked.

        >>> Measurement("peak", 3.0, "°", least=1.0, most=9.0).criterion
        '1 to 9°'
        >>> Measurement("values that differ", 0.0, least=0.0, most=0.0).criterion
        '0'
        """
        if self.least is None and self.most is None:
            return ""
        if self.least is None:
            return self._with_unit(f"at most {_plain(self.most, 7)}")
        if self.most is None:
            return self._with_unit(f"at least {_plain(self.least, 7)}")
        ends = list(dict.fromkeys((_plain(self.least, 7), _plain(self.most, 7))))
        return self._with_unit(" to ".join(ends))

    def record(self) -> dict[str, float | str | bool | None]:
        """The measurement for machines; what is not a number becomes None."""
        value = None if self.value != self.value else float(self.value)
        return {
            "quantity": self.quantity,
            "value": value,
            "unit": self.unit,
            "least": self.least,
            "most": self.most,
            "holds": self.holds,
        }

    def _with_unit(self, number: str) -> str:
        """A degree's sign stands close, words apart."""
        return f"{number}{'' if self.unit == '°' else ' '}{self.unit}".rstrip()


def _plain(number: float | None, digits: int) -> str:
    if number is None or number != number:
        return "not a number"
    if number and abs(number) < 1e-3:
        mantissa, exponent = f"{number:.1e}".split("e")
        text = f"{mantissa.removesuffix('.0')}e{int(exponent)}"
    else:
        text = f"{number:.{digits}g}"
    return text.replace("-", "−")
