"""Thurstone's case V (1927): every stimulus leaves an impression of the same spread."""

from __future__ import annotations

from typing import Any

from numpy.typing import ArrayLike

from nacreous.number import said
from nacreous.problem import InputError
from nacreous.scaling.fit.least_squares import least_squares
from nacreous.scaling.fit.maximum_likelihood import fitted, reduced, require_plain
from nacreous.scaling.fit.scale import Scale
from nacreous.scaling.fit.spread import Prior


def thurstone(
    data: Any,
    method: str = "maximum-likelihood",
    ties: bool | None = None,
    order: bool = False,
    prior: Prior = None,
    design: ArrayLike | None = None,
    extremes: float = 0.5,
) -> Scale:
    """The case V scale in z: i is chosen over j with probability Phi(v_i - v_j).

    - `data`: `Answers`, `Comparisons`, a file or table of answers, a matrix of counts, or a list of
      (winner, loser)
    - `method`: "maximum-likelihood"; "bias-reduced", which few answers do not stretch (Firth 1993),
      ties counted half; or "least-squares", the row means of z of the paper (1996)
    - `ties`: True fits a threshold below which nobody chooses (Glenn and David 1960); False counts
      a tie as half a choice for either; None, the default, fits it where ties are more than 5 % of
      the answers and tell how wide it is
    - `order`: True fits how much being on the left helps, in z; needs answers with sides
    - `prior`: None; the spread in z of a normal prior on each value (on each coefficient), 0.001 to
      1000, which pulls the scale together and is always there if the answers alone give none; or
      "hierarchical", where the spread has a prior too, for pairs chosen by the answers so far
    - `design`: None, or [stimulus, coefficient]: the values are then design x coefficients
    - `extremes`: for least squares only: a pair on which all n agree counts as this many answers
      against it, p = 0.5 / n by default; 0.001 to 1

    Raises `InputError` for bad values, and where no finite scale is the most likely one: which
    stimuli cannot be placed, why, and what would help.

    >>> thurstone([("a", "b")] * 84 + [("b", "a")] * 16).difference("a", "b").value.__round__(3)
    0.994
    >>> thurstone([("a", "b"), ("a", "c"), ("b", "c"), ("c", "b")])
    Traceback (most recent call last):
    nacreous.problem.InputError: no scale holds "a": was always preferred when compared with \
"b", "c", so the distance has no upper end; allowed: more answers between these, until another \
is preferred, or a prior, as prior=1.0
    """
    if method == "maximum-likelihood":
        return fitted(data, "probit", ties, order, prior, design)
    if method == "bias-reduced":
        require_plain(prior, design)
        return reduced(data, "probit", ties, order)
    if method != "least-squares":
        raise InputError(
            f"method is {said(method)}; allowed: maximum-likelihood, bias-reduced, least-squares"
        )
    if ties or order or prior is not None or design is not None:
        raise InputError(
            "method is 'least-squares', which has no ties, order, prior or design of its own; "
            "allowed with them: maximum-likelihood"
        )
    return least_squares(data, extremes)
