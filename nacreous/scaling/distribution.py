"""Tails and quantiles of the distributions that tests and intervals need.

Named as in `scipy.stats`, and computed as there by `scipy.special`: to import all of `scipy.stats`
takes longer than most scales do.
"""

# ruff: noqa: N801 (the names of scipy.stats)

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike
from scipy import special

__all__ = ["binom", "chi2", "f", "norm", "poisson", "t"]


class norm:
    """The normal distribution with mean 0 and standard deviation 1."""

    @staticmethod
    def sf(x: ArrayLike) -> Any:
        """The chance of more than x."""
        return special.ndtr(np.negative(x))

    @staticmethod
    def pdf(x: ArrayLike) -> Any:
        """The density at x."""
        return np.exp(-np.square(x) / 2) / np.sqrt(2 * np.pi)

    @staticmethod
    def ppf(q: ArrayLike) -> Any:
        """What is exceeded with chance 1 - q."""
        return special.ndtri(q)


class t:
    """Student's distribution; normal with infinitely many degrees of freedom."""

    @staticmethod
    def sf(x: ArrayLike, df: ArrayLike) -> Any:
        """The chance of more than x."""
        return special.stdtr(df, np.negative(x))

    @staticmethod
    def ppf(q: ArrayLike, df: ArrayLike) -> Any:
        """What is exceeded with chance 1 - q."""
        return special.stdtrit(df, q)


class chi2:
    """The sum of the squares of df normal values."""

    @staticmethod
    def sf(x: ArrayLike, df: ArrayLike) -> Any:
        """The chance of more than x, 0 or above."""
        return special.chdtrc(df, x)

    @staticmethod
    def ppf(q: ArrayLike, df: ArrayLike) -> Any:
        """What is exceeded with chance 1 - q."""
        return 2 * special.gammaincinv(np.divide(df, 2), q)


class f:
    """Fisher's ratio of two mean squares."""

    @staticmethod
    def sf(x: ArrayLike, first: ArrayLike, second: ArrayLike) -> Any:
        """The chance of more than x, with degrees of freedom above and below the line."""
        return special.fdtrc(first, second, x)


class binom:
    """How many of n tosses succeed, each with chance p."""

    @staticmethod
    def cdf(k: ArrayLike, n: ArrayLike, p: ArrayLike) -> Any:
        """The chance of k or fewer; k and n whole."""
        return special.bdtr(np.asarray(k, float), n, p)


class poisson:
    """How many rare events there are where mean are expected."""

    @staticmethod
    def sf(k: ArrayLike, mean: ArrayLike) -> Any:
        """The chance of more than k, whole; 1 for k below 0."""
        return np.where(np.less(k, 0), 1.0, special.pdtrc(np.maximum(k, 0), mean))
