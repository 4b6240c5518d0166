"""What was asked for: everything that decides what a report says, besides the data."""

from __future__ import annotations

import shlex

from nacreous.number import number_of, said, seed_of, whole_of
from nacreous.problem import InputError
from nacreous.scaling.fit.spread import Prior
from nacreous.value import value_class

__all__ = ["BOOTSTRAP", "LEVELS", "METHODS", "MODELS", "Settings"]

MODELS = {"probit": "z", "logit": "logit"}
METHODS = ("maximum-likelihood", "bias-reduced", "least-squares")
#: Resamplings allowed; 0: none, margins come from the number of answers alone.
BOOTSTRAP = (100, 100_000)
LEVELS = (0.5, 0.9999)


@value_class
class Settings:
    """How to fit, and what to say of it.

    question: as it was put to people, or None. unit: "z", "d'", "JOD", "JND", "logit"; None: the
    model's own. ties: whether to fit how wide they are; None: where they are more than a few.
    level: of all intervals and tests. bootstrap: resamplings, 0 for none. group: a column of the
    answers, or None. prior: its spread in the model's own unit, "hierarchical" or None. simulated:
    nobody gave the answers, which the report then says first.
    Raises `InputError` for what cannot be.
    """

    question: str | None = None
    model: str = "probit"
    method: str = "maximum-likelihood"
    ties: bool | None = None
    order: bool = False
    prior: Prior = None
    unit: str | None = None
    level: float = 0.95
    bootstrap: int = 1000
    seed: int = 1
    group: str | None = None
    simulated: bool = False

    def __post_init__(self) -> None:
        """Check every value."""
        for name, value, allowed in (
            ("model", self.model, tuple(MODELS)),
            ("method", self.method, METHODS),
        ):
            if value not in allowed:
                raise InputError(f"{name} is {said(value)}; allowed: {', '.join(allowed)}")
        if self.method == "least-squares" and (self.model != "probit" or self.ties or self.order):
            raise InputError(
                "method is 'least-squares'; allowed: with model='probit', without ties or order"
            )
        level = number_of("level", self.level)
        if not LEVELS[0] <= level <= LEVELS[1]:
            raise InputError(f"level is {level:g}; allowed: {LEVELS[0]:g} to {LEVELS[1]:g}")
        least, most = BOOTSTRAP
        if whole_of("bootstrap", self.bootstrap, 0, most) in range(1, least):
            raise InputError(f"bootstrap is {self.bootstrap}; allowed: 0, or {least} to {most}")
        seed_of(self.seed)

    def options(self, language: str) -> str:
        """The options of `nacreous scale` that stand for these settings.

        >>> Settings(unit="JOD", ties=True).options("en")
        '--ties --unit JOD'
        """
        plain = Settings()
        words = ["--language", language] if language != "en" else []
        for name in ("question", "model", "method", "ties", "order", "prior"):
            words += self._option(name, plain)
        for name in ("unit", "level", "bootstrap", "seed", "group", "simulated"):
            words += self._option(name, plain)
        return shlex.join(words)

    def _option(self, name: str, plain: Settings) -> list[str]:
        value = getattr(self, name)
        if value == getattr(plain, name):
            return []
        if isinstance(value, bool):
            return [f"--{name}" if value else f"--no-{name}"]
        # What begins with a dash would be taken for an option.
        dashed = str(value).startswith("-")
        return [f"--{name}={value}"] if dashed else [f"--{name}", str(value)]
