"""Bradley and Terry's scale (1952): the logistic brother of Thurstone's case V."""

from __future__ import annotations

from typing import Any

from numpy.typing import ArrayLike

from nacreous.number import said
from nacreous.problem import InputError
from nacreous.scaling.fit.maximum_likelihood import fitted, reduced, require_plain
from nacreous.scaling.fit.scale import Scale
from nacreous.scaling.fit.spread import Prior


def bradley_terry(
    data: Any,
    ties: bool | None = None,
    order: bool = False,
    prior: Prior = None,
    design: ArrayLike | None = None,
    method: str = "maximum-likelihood",
) -> Scale:
    """The most likely scale in logit: a leads b by ln(p / (1 - p)), p how often it is chosen.

    Arguments and errors as `thurstone`. ties=True is Davidson's model (1970), order=True Davidson
    and Beaver's (1977). Their tie parameter with order is ours times exp(-order_effect / 2), the
    same model written otherwise.

    >>> bradley_terry([("a", "b")] * 3 + [("b", "a")]).scale.round(4).tolist()  # ln 3, halved
    [0.5493, -0.5493]
    """
    if method == "maximum-likelihood":
        return fitted(data, "logit", ties, order, prior, design)
    if method != "bias-reduced":
        raise InputError(f"method is {said(method)}; allowed: maximum-likelihood, bias-reduced")
    require_plain(prior, design)
    return reduced(data, "logit", ties, order)
