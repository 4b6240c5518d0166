"""How many people a power takes: few tries, each where the ones before point."""

from __future__ import annotations

from collections.abc import Callable
from math import ceil
from typing import Protocol

from nacreous.problem import InputError
from nacreous.scaling.distribution import norm

__all__ = ["people_for"]

#: Tries, at most: the first ones find the region, the last ones lie in it and are averaged.
_TRIES = 10


class _Tried(Protocol):
    @property
    def power(self) -> float: ...
    @property
    def se(self) -> float: ...


def people_for(
    tried: Callable[[int, int, float], _Tried],
    start: int,
    target: float,
    alpha: float,
    most: int,
    seed: int,
) -> tuple[int, int, int]:
    """People needed for a power, and the ends of a 95 % interval of that number.

    The difference in standard errors grows as the root of the number of people, so a power p at n
    people says that (z(p) + z(1 - alpha / 2)) / sqrt(n) is about the same everywhere. Tries near
    the goal, within a third of it, are averaged until there are three.

    tried(people, seed, done): the power found with so many people; done: share of the work.
    """
    people = start
    near: list[tuple[float, float, int]] = []
    for index in range(_TRIES):
        found = tried(people, seed + index, index / (_TRIES + 2))
        rate, error = _rate(found, people, alpha)
        if rate <= 2 * error:  # nothing seen yet: far more people
            if people >= most:
                break
            people = min(8 * people, most)
            continue
        goal = _people(rate, target, alpha)
        near = [one for one in near if abs(one[2] / goal - 1) < 1 / 3]
        if abs(people / goal - 1) < 1 / 3:
            near.append((rate, error, people))
        if len(near) == 3:
            break
        people = max(2, min(ceil(goal), 16 * people, most))
    if not near:
        raise InputError(
            f"{most} people would not reach a power of {target:g}, as far as simulated studies "
            "tell; allowed: stimuli that differ more"
        )
    weights = [1 / error**2 for _, error, _ in near]
    rate = sum(w * one[0] for w, one in zip(weights, near, strict=True)) / sum(weights)
    error = sum(weights) ** -0.5
    low, high = (
        _people(max(rate + way * error, rate / 10), target, alpha) for way in (1.96, -1.96)
    )
    return max(2, ceil(_people(rate, target, alpha))), max(2, int(low)), ceil(high)


def _rate(found: _Tried, people: int, alpha: float) -> tuple[float, float]:
    """Standard errors of difference per root of a person, and how sure that is."""
    power = min(max(found.power, found.se), 1 - found.se)
    lead = float(norm.ppf(power) + norm.ppf(1 - alpha / 2))
    # The other tail is left out: below 1e-3 of the power from 10 % on.
    slope = float(norm.pdf(norm.ppf(power)))
    return lead / people**0.5, found.se / slope / people**0.5


def _people(rate: float, target: float, alpha: float) -> float:
    return (float(norm.ppf(target) + norm.ppf(1 - alpha / 2)) / rate) ** 2
