"""The curve from a lead to a choice: its logarithm and derivatives, for models of people."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


class Slopes(NamedTuple):
    """ln F at leads, and its first three derivatives, each of the leads' shape."""

    log: Array
    first: Array
    second: Array
    third: Array


def slopes_at(lead: Array, model: str) -> Slopes:
    """Of ln F, with F normal for "probit" and logistic for "logit"; any finite leads.

    >>> at = slopes_at(np.zeros(1), "logit")
    >>> [float(part[0]) for part in at[1:3]]
    [0.5, -0.25]
    """
    from scipy.special import expit, log_expit, log_ndtr

    if model == "logit":
        high, low = expit(lead), expit(-lead)
        return Slopes(log_expit(lead), low, -high * low, -high * low * (low - high))
    log = log_ndtr(lead)
    mills = np.exp(-(lead**2) / 2 - np.log(2 * np.pi) / 2 - log)
    gain = mills + lead
    return Slopes(log, mills, -mills * gain, mills * (gain * (mills + gain) - 1))
