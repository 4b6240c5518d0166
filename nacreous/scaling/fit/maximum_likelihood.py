"""Fits by the likelihood, the same for both models: check, fit, make a `Scale` of it."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nacreous._core import PairModel
from nacreous.number import array_of, number_of, said
from nacreous.problem import InputError
from nacreous.scaling.data.answers import Answers
from nacreous.scaling.data.comparisons import Comparisons
from nacreous.scaling.data.given import counted
from nacreous.scaling.fit.bias_reduction import bias_reduced
from nacreous.scaling.fit.existence import pair_model, require_maximum
from nacreous.scaling.fit.scale import Scale
from nacreous.scaling.fit.separation import require_design
from nacreous.scaling.fit.spread import HIERARCHICAL, Prior, spread_posterior
from nacreous.scaling.fit.tie import fits_ties
from nacreous.scaling.fit.unit import Model


def fitted(
    data: Any,
    model: Model,
    ties: bool | None = None,
    order: bool = False,
    prior: Prior = None,
    design: ArrayLike | None = None,
) -> Scale:
    """The most likely scale in the model's own unit; see `thurstone` for the arguments."""
    answers, comparisons = counted(data)
    _check_order(order, comparisons)
    spread = _prior_of(prior)
    table = None if design is None else _design_of(design, comparisons)
    if spread == HIERARCHICAL and table is not None:
        raise InputError("prior is 'hierarchical'; allowed with a design: a spread, or None")
    ties = fits_ties(ties, [comparisons], model, order)
    with_ties = ties and bool(comparisons.ties.any())
    # Whatever the spread, a prior holds the same fits.
    held = 1.0 if spread == HIERARCHICAL else spread
    room = pair_model(comparisons, model, with_ties, order, held, table)
    if table is None:
        require_maximum(comparisons, room)
    else:
        require_design(comparisons, table, with_ties, order, held)
    posterior = None
    if spread == HIERARCHICAL:
        posterior = spread_posterior(comparisons, model, with_ties, order)
        room = pair_model(comparisons, model, with_ties, order)
    parameters = room.fit()[0] if posterior is None else posterior.mean
    found = _scale(answers, comparisons, room, model, parameters, order, table)
    # Without a tie the most likely threshold is 0.
    threshold = _threshold(parameters, model, with_ties) if ties else None
    return replace(found, tie_threshold=threshold, prior=spread, posterior=posterior)


def reduced(data: Any, model: Model, ties: bool | None = None, order: bool = False) -> Scale:
    """The scale by bias reduction in the model's own unit; see `thurstone` for the arguments."""
    answers, comparisons = counted(data)
    _check_order(order, comparisons)
    if ties:
        raise InputError(
            "ties is True; allowed with method 'bias-reduced': False, each counts half"
        )
    room = pair_model(comparisons, model, False, order)
    parameters = bias_reduced(room, comparisons, model, order)
    found = _scale(answers, comparisons, room, model, parameters, order, None)
    return replace(found, method="bias-reduced")


def require_plain(prior: Prior, design: ArrayLike | None) -> None:
    """Raise `InputError` for what bias reduction does not take."""
    for name, value in (("prior", prior), ("design", design)):
        if value is not None:
            raise InputError(f"{name} is given; allowed with method 'bias-reduced': None")


def _scale(
    answers: Answers | None,
    comparisons: Comparisons,
    room: PairModel,
    model: Model,
    parameters: NDArray[np.float64],
    order: bool,
    design: NDArray[np.float64] | None,
) -> Scale:
    """The parameters as a scale, still without ties and prior."""
    count = len(comparisons.stimuli) if design is None else design.shape[1]
    values = parameters[:count] if design is None else design @ parameters[:count]
    return Scale(
        stimuli=comparisons.stimuli,
        scale=values - values.mean(),
        unit="z" if model == "probit" else "logit",
        model=model,
        method="maximum-likelihood",
        comparisons=comparisons,
        log_likelihood=room.log_likelihood(parameters),
        order_effect=float(parameters[count]) if order else None,
        coefficients=None if design is None else parameters[:count],
        design=design,
        answers=answers,
        parameters=parameters,
        pair_model=room,
    )


def _threshold(parameters: NDArray[np.float64], model: Model, with_ties: bool) -> float:
    width = float(parameters[-1]) if with_ties else 0.0
    return float(np.exp(width)) if model == "logit" and with_ties else width


def _check_order(order: bool, comparisons: Comparisons) -> None:
    if not isinstance(order, bool):
        raise InputError(f"order is {said(order)}; allowed: True, False")
    if order and not comparisons.sided:
        raise InputError("order=True, but left and right are no sides here; allowed: order=False")


def _prior_of(prior: Prior) -> Prior:
    if prior is None:
        return None
    if isinstance(prior, str) and prior == HIERARCHICAL:
        return HIERARCHICAL
    if isinstance(prior, str) or not 1e-3 <= number_of("prior", prior) <= 1e3:
        raise InputError(
            f"prior is {said(prior)}; allowed: a spread, 0.001 to 1000, 'hierarchical', or None"
        )
    return float(prior)


def _design_of(design: ArrayLike, comparisons: Comparisons) -> NDArray[np.float64]:
    table = array_of("design", design)
    if table.ndim != 2 or len(table) != len(comparisons.stimuli) or table.shape[1] == 0:
        shape = " x ".join(map(str, table.shape)) or "a single number"
        raise InputError(
            f"design is {shape}; allowed: {len(comparisons.stimuli)} rows, one a stimulus, and "
            "one column or more"
        )
    if not np.isfinite(table).all() or np.abs(table).max() > 1e6:
        raise InputError(
            "design holds a value that is no number or above 1e6; allowed: -1e6 to 1e6"
        )
    return np.ascontiguousarray(table)
