"""How nacre grows from the seeding of the nucleus to the harvest (paper 3.2.1)."""

from __future__ import annotations

import datetime as dt
from collections.abc import Iterator
from typing import Annotated, Any

from pydantic import AfterValidator, BeforeValidator, Field, model_validator

from nacreous.spec import preset
from nacreous.spec.complaint import Contradiction
from nacreous.spec.key import key, quantity, section
from nacreous.spec.nacre import Nacre
from nacreous.spec.section import Section

#: Any year that is not a leap year stands for "every year".
_EVERY_YEAR = 2001
_MOST_DAYS = 20 * 365 + 5


def _as_text(value: Any) -> Any:
    """TOML also knows dates without quotes; they mean the same."""
    return value.isoformat() if type(value) is dt.date else value


def _on_calendar(text: str) -> str:
    _date(text)  # ValueError for 02-30
    return text


def _date(text: str, year: int = _EVERY_YEAR) -> dt.date:
    return dt.date.fromisoformat(text if len(text) > 5 else f"{year:04}-{text}")


def _known(name: str) -> str:
    if name not in preset.names("nacre"):
        raise ValueError("no such preset")
    return name


_MONTH_DAY = "[0-9]{2}-[0-9]{2}"
MonthDay = Annotated[str, Field(pattern=f"^{_MONTH_DAY}$"), AfterValidator(_on_calendar)]
Day = Annotated[
    str,
    BeforeValidator(_as_text),
    Field(pattern=f"^([0-9]{{4}}-)?{_MONTH_DAY}$"),
    AfterValidator(_on_calendar),
]
_DAY = '"MM-DD" of every year but 02-29, or "YYYY-MM-DD"'
_CURVE = "paper 3.2.1, bell curve; the standard deviation is **(ours)**"


class Growth(Nacre):
    """The season's bell curves of layer thickness and of layers a day, and their noise.

    A value on day d is winter + (summer - winter) exp(-(d - peak)^2 / (2 season_days^2)), plus
    noise that is uniform within its half width.

    >>> Growth().days
    244
    >>> Growth(preset="akoya-r", seed=7).thickness_winter_nm < Growth().thickness_winter_nm
    True
    """

    preset: Annotated[str, AfterValidator(_known)] = key(
        "paper-green",
        "The nacre preset whose values hold wherever this file gives none.",
        allowed="a name that `nacreous presets nacre` lists",
        source="nacreous presets nacre",
        examples=preset.names("nacre"),
    )
    seed: int = quantity(
        1,
        "Seed of the growth's random numbers: same seed, same layers.",
        least=0,
        most=2**63 - 1,
        source="**(ours)**",
    )
    seeding: Day = key(
        "04-15",
        "Day on which the nucleus is put in.",
        allowed=_DAY,
        source="**(ours)**",
    )
    harvest: Day = key(
        "12-15",
        "Day of the harvest; as MM-DD, the first such day after seeding.",
        allowed=_DAY,
        source="paper 3.2.1, December",
    )
    peak: MonthDay = key(
        "08-01",
        "Day of each year on which both bell curves are highest.",
        allowed='"MM-DD" of every year but 02-29',
        source="paper 3.2.1, summer; the day is **(ours)**",
    )
    season_days: float = quantity(
        45.0,
        "Standard deviation of both bell curves.",
        least=1,
        most=365,
        unit="days",
        source=_CURVE,
    )
    thickness_winter_nm: float = quantity(
        400.0,
        "Thickness of an aragonite layer far from the peak.",
        least=50,
        most=5000,
        unit="nm",
        source="paper 3.2.1, 400 to 700 nm",
    )
    thickness_summer_nm: float = quantity(
        700.0,
        "Thickness of an aragonite layer at the peak.",
        least=50,
        most=5000,
        unit="nm",
        source="paper 3.2.1, 400 to 700 nm",
    )
    layers_winter: float = quantity(
        1.0,
        "Layers a day far from the peak.",
        least=0,
        most=20,
        unit="layers a day",
        source="paper 3.2.1, 1 to 3",
    )
    layers_summer: float = quantity(
        3.0,
        "Layers a day at the peak.",
        least=0,
        most=20,
        unit="layers a day",
        source="paper 3.2.1, 1 to 3",
    )
    thickness_noise_nm: float = quantity(
        20.0,
        "Half width of the uniform noise on each layer's thickness.",
        least=0,
        most=1000,
        unit="nm",
        source="paper 3.2.1, uniform random numbers; the width is **(ours)**",
    )
    layers_noise: float = quantity(
        0.5,
        "Half width of the uniform noise on the layers of each day.",
        least=0,
        most=5,
        unit="layers a day",
        source="paper 3.2.1, uniform random numbers; the width is **(ours)**",
    )

    @model_validator(mode="before")
    @classmethod
    def _on_preset(cls, values: Any) -> Any:
        """The preset's values first, the given ones over them."""
        name = values.get("preset") if isinstance(values, dict) else None
        if isinstance(name, str) and name in preset.names("nacre"):
            return {**preset.values("nacre", name), **values}
        return values

    @property
    def seeding_date(self) -> dt.date:
        """The day of seeding; an MM-DD day is placed in a year without a leap day."""
        return _date(self.seeding)

    @property
    def harvest_date(self) -> dt.date:
        """The day of the harvest, after the day of seeding."""
        harvest = _date(self.harvest)
        if len(self.harvest) == 5 and harvest <= self.seeding_date:
            return _date(self.harvest, _EVERY_YEAR + 1)
        return harvest

    @property
    def peak_date(self) -> dt.date:
        """The peak of the year of seeding; it comes back every year."""
        return _date(self.peak, self.seeding_date.year)

    @property
    def days(self) -> int:
        """Days from seeding to harvest: the number of days on which nacre grows."""
        return (self.harvest_date - self.seeding_date).days

    def contradictions(self) -> Iterator[Contradiction]:
        """Dates in two forms or in the wrong order, noise above the thickness, no layers."""
        yield from super().contradictions()
        yield from self._wrong_dates()
        thinnest_nm, other = min(
            (self.thickness_winter_nm, "thickness_winter_nm"),
            (self.thickness_summer_nm, "thickness_summer_nm"),
        )
        if self.thickness_noise_nm >= thinnest_nm:
            yield Contradiction(
                "thickness_noise_nm",
                f"is {self.thickness_noise_nm:g}; "
                f"allowed: less than {{other}}, which is {thinnest_nm:g} nm",
                other,
            )
        if self.layers_winter == self.layers_summer == self.layers_noise == 0:
            yield Contradiction(
                "layers_summer",
                "is 0, and so are layers_winter and layers_noise: no layer would grow; "
                "allowed: at least one of the three above 0",
            )

    def _wrong_dates(self) -> Iterator[Contradiction]:
        if len(self.seeding) != len(self.harvest):
            yield Contradiction(
                "harvest",
                f'is "{self.harvest}" and {{other}} is "{self.seeding}"; '
                "allowed: both with a year or both without",
                "seeding",
            )
        elif not 1 <= self.days <= _MOST_DAYS:
            yield Contradiction(
                "harvest",
                f'is "{self.harvest}"; '
                f'allowed: 1 day to 20 years after {{other}}, which is "{self.seeding}"',
                "seeding",
            )


class Grown(Section):
    """Growth alone, without a pearl whose model would ask more of its media."""

    nacre: Growth = section("The layers, grown over a season.")
