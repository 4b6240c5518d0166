"""The paper's estimator: case V by least squares on z, the inverse normal of the proportions.

With every pair compared, the values are the row means of z (Mosteller 1951; paper, table 1). Where
pairs are missing, the least squares over those that are there (Gulliksen 1956), each with the same
weight. A proportion of 0 or 1 has no z; such a pair counts as `extremes` answers out of n against
the unanimous choice: p = 0.5 / n by default.
"""

from __future__ import annotations

from typing import Any

from nacreous.number import number_of, said
from nacreous.problem import InputError
from nacreous.scaling.data.given import counted
from nacreous.scaling.fit.existence import islands, pair_model, require_maximum
from nacreous.scaling.fit.row_means import projection, z_of_pairs
from nacreous.scaling.fit.scale import Scale


def least_squares(data: Any, extremes: float = 0.5) -> Scale:
    """The scale in z; a tie counts half for either. Errors as `thurstone`.

    >>> from nacreous.scaling import paper_proportions, Comparisons
    >>> fit = least_squares(Comparisons.of_proportions(paper_proportions(), 104))
    >>> fit.scale.round(3).tolist()
    [0.278, 0.809, 0.324, 0.419, -0.308, -0.623, -0.9]
    """
    if not 1e-3 <= number_of("extremes", extremes) <= 1:
        raise InputError(f"extremes is {said(extremes)}; allowed: 0.001 to 1 answer")
    answers, comparisons = counted(data)
    room = pair_model(comparisons, "probit")
    if len(comparisons.stimuli) < 2 or islands(comparisons).max() > 0:
        require_maximum(comparisons, room)
    pairs = comparisons.unsided()
    values = projection(pairs) @ z_of_pairs(pairs, float(extremes))
    return Scale(
        stimuli=comparisons.stimuli,
        scale=values,
        unit="z",
        model="probit",
        method="least-squares",
        comparisons=comparisons,
        log_likelihood=room.log_likelihood(values),
        answers=answers,
        parameters=values,
        pair_model=room,
    )
