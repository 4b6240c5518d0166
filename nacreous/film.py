"""The film of a pearl: columns of tablets of its outer nacre, side by side."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from nacreous.nacre import LayerStack, stack_of
from nacreous.spec import Growth, Pearl

__all__ = ["columns_of"]

#: Spread of listed layers from column to column: orderly nacre has 10 to 20 nm (Pearl Science
#: Laboratory). Grown layers have their own noise.
_LISTED_SPREAD_NM = 10.0

#: No layer gets thinner than this by the spread.
_THINNEST_NM = 1.0


def columns_of(pearl: Pearl, outer_um: float) -> list[LayerStack]:
    """The columns of a pearl's film, the outer `outer_um` of each, on nacre as their core.

    Grown nacre: each column grows by the same season with a seed of its own, the first with the
    pearl's. Listed layers are the same in all. Both are spread by film.column_spread_nm, layer by
    layer (uniform noise of that standard deviation). Same pearl, same columns.

    >>> columns = columns_of(Pearl(), 10.0)
    >>> len(columns), len(columns[0])
    (64, 24)
    """
    nacre, film = pearl.nacre, pearl.film
    default_nm = 0.0 if isinstance(nacre, Growth) else _LISTED_SPREAD_NM
    spread_nm = default_nm if film.column_spread_nm is None else film.column_spread_nm
    noise = np.random.Generator(np.random.PCG64(nacre.seed if isinstance(nacre, Growth) else 1))
    columns, stack = [], stack_of(pearl)
    for column in range(film.columns):
        if isinstance(nacre, Growth) and column:
            seed = (nacre.seed + column) % 2**63
            sown = nacre.model_copy(update={"seed": seed})
            stack = stack_of(pearl.model_copy(update={"nacre": sown}))
        layers = stack.thickness_nm[: stack.outer(outer_um)[0]]
        columns.append(_like(stack, _spread(layers, spread_nm, noise)))
    return columns


def _spread(
    thickness_nm: NDArray[np.float64], spread_nm: float, noise: np.random.Generator
) -> NDArray[np.float64]:
    if spread_nm == 0.0:
        return thickness_nm
    shift = (2.0 * noise.random(thickness_nm.size) - 1.0) * math.sqrt(3.0) * spread_nm
    return np.maximum(thickness_nm + shift, _THINNEST_NM)


def _like(stack: LayerStack, thickness_nm: NDArray[np.float64]) -> LayerStack:
    return LayerStack(
        thickness_nm,
        stack.protein_nm,
        stack.aragonite,
        stack.protein,
        stack.ambient,
        stack.substrate,
    )
