"""Units of a scale: what a difference of 1 means, by how often one is then preferred.

| unit  | a difference of 1 means |
|-------|---|
| z     | preferred by Phi(1) = 84.1 %: Thurstone's case V with spread 1 of a difference |
| d'    | z times the root of 2: spread 1 of each single impression, as in detection theory |
| logit | preferred by 1 / (1 + 1/e) = 73.1 %: Bradley and Terry's model |
| JOD   | preferred by 75 %: just objectionable differences (Perez-Ortiz and Mantiuk 2017) |
| JND   | preferred by 75 %: the same, called just noticeable differences |

Probit scales turn to z and logit scales to logit exactly; the other kind of unit is matched where
75 % prefer one, so that 1 JOD is the same in both models.
"""

from __future__ import annotations

import math
from typing import Literal

from nacreous.number import said
from nacreous.problem import InputError

Unit = Literal["z", "d'", "JOD", "JND", "logit"]
Model = Literal["probit", "logit"]

#: The inverse normal of 0.75.
Z_AT_75 = 0.6744897501960817
#: How long one unit is, in JOD.
JOD_PER: dict[str, float] = {
    "z": 1 / Z_AT_75,
    "d'": 1 / (math.sqrt(2) * Z_AT_75),
    "logit": 1 / math.log(3),
    "JOD": 1.0,
    "JND": 1.0,
}


def unit_of(unit: object) -> Unit:
    """The unit of that name, or one clear message."""
    for known in ("z", "d'", "JOD", "JND", "logit"):
        if unit == known:
            return known
    raise InputError(f"unit is {said(unit)}; allowed: {', '.join(JOD_PER)}")


def factor(from_unit: str, to_unit: str) -> float:
    """What a value in one unit is multiplied by to be one in another.

    >>> round(factor("z", "d'"), 4), round(factor("z", "JOD"), 4), round(factor("logit", "z"), 4)
    (1.4142, 1.4826, 0.6139)
    """
    return JOD_PER[unit_of(from_unit)] / JOD_PER[unit_of(to_unit)]


def check_model(model: object) -> None:
    """Refuse any model but "probit" and "logit"."""
    if model not in ("probit", "logit"):
        raise InputError(f"model is {said(model)}; allowed: probit, logit")
