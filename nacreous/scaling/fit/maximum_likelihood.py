"""Maximum likelihood, the same for both models: check, fit, make a `Scale` of it."""

from __future__ import annotations

from os import PathLike
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nacreous.number import array_of, number_of, said
from nacreous.problem import InputError
from nacreous.scaling.data.answers import Answers
from nacreous.scaling.data.comparisons import Comparisons, comparisons_of
from nacreous.scaling.data.table import is_table
from nacreous.scaling.fit.existence import pair_model, require_maximum
from nacreous.scaling.fit.scale import Scale
from nacreous.scaling.fit.separation import require_design
from nacreous.scaling.fit.tie import fits_ties
from nacreous.scaling.fit.unit import Model


def fitted(
    data: Any,
    model: Model,
    ties: bool | None = None,
    order: bool = False,
    prior: float | None = None,
    design: ArrayLike | None = None,
) -> Scale:
    """The most likely scale in the model's own unit; see `thurstone` for the arguments."""
    data, comparisons = counted(data)
    if not isinstance(order, bool):
        raise InputError(f"order is {said(order)}; allowed: True, False")
    if order and not comparisons.sided:
        raise InputError("order=True, but left and right are no sides here; allowed: order=False")
    if prior is not None and not 1e-3 <= number_of("prior", prior) <= 1e3:
        raise InputError(f"prior is {said(prior)}; allowed: a spread, 0.001 to 1000, or None")
    table = None if design is None else _design_of(design, comparisons)
    ties = fits_ties(ties, [comparisons], model, order)
    with_ties = ties and bool(comparisons.ties.any())
    spread = None if prior is None else float(prior)
    room = pair_model(comparisons, model, with_ties, order, spread, table)
    if table is None:
        require_maximum(comparisons, room)
    else:
        require_design(comparisons, table, with_ties, order, spread)
    parameters, values, log_likelihood, _ = room.fit()
    count = len(comparisons.stimuli) if table is None else table.shape[1]
    threshold = None
    if ties:  # without a tie the most likely threshold is 0
        width = float(parameters[-1]) if with_ties else 0.0
        threshold = float(np.exp(width)) if model == "logit" and with_ties else width
    return Scale(
        stimuli=comparisons.stimuli,
        scale=values,
        unit="z" if model == "probit" else "logit",
        model=model,
        method="maximum-likelihood",
        comparisons=comparisons,
        log_likelihood=log_likelihood,
        order_effect=float(parameters[count]) if order else None,
        tie_threshold=threshold,
        prior=spread,
        coefficients=None if table is None else parameters[:count],
        design=table,
        answers=data if isinstance(data, Answers) else None,
        parameters=parameters,
        pair_model=room,
    )


def counted(data: Any) -> tuple[Any, Comparisons]:
    """The data, as `Answers` where they are a file or table of answers, and their counts."""
    if isinstance(data, str | PathLike):
        data = Answers.read(data)
    elif is_table(data) and {"left", "right", "chosen"} <= {str(c) for c in _columns(data)}:
        data = Answers.of_table(data)
    return data, comparisons_of(data)


def _columns(table: Any) -> list[Any]:
    if isinstance(table, dict):
        return list(table)
    names = getattr(table, "column_names", None)
    return list(getattr(table, "columns", ()) if names is None else names)


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
