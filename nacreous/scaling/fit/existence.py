"""Whether a scale can be had from the answers, and if not, why and what would help.

The likelihood has one finite maximum if, and only if, there is no way to split the stimuli in two
so that no one of the one part was ever preferred to one of the other (L. R. Ford, Amer. Math.
Monthly 64 (1957), 28); a tie counts both ways. An order effect and ties of their own need more: see
crates/scaling/src/existence.rs.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from nacreous._core import PairModel
from nacreous.problem import InputError
from nacreous.scaling.data.comparisons import Comparisons
from nacreous.scaling.data.fault import listed
from nacreous.scaling.data.given import comparisons_of

REMEDY = ", or a prior, as prior=1.0"


def parts(data: Any) -> list[tuple[str, ...]]:
    """The stimuli in sets inside which a scale exists, from the least preferred set on.

    Nobody of a set was ever preferred to anybody of a later one; sets that never met each other
    stand in any order. One set means that the scale exists.

    >>> parts([("a", "b"), ("b", "a"), ("a", "c")])
    [('c',), ('a', 'b')]
    """
    comparisons = comparisons_of(data)
    part = pair_model(comparisons, "probit").components().astype(np.int64)
    return [_named(comparisons, part == index) for index in range(int(part.max()) + 1)]


def pair_model(
    comparisons: Comparisons,
    link: str,
    ties: bool = False,
    order: bool = False,
    prior: float | None = None,
    design: NDArray[np.float64] | None = None,
) -> PairModel:
    """The model and its counts, as the compiled room holds them."""
    answers = np.column_stack((comparisons.left_wins, comparisons.right_wins, comparisons.ties))
    return PairModel(
        link,
        len(comparisons.stimuli),
        np.ascontiguousarray(comparisons.left, np.int64),
        np.ascontiguousarray(comparisons.right, np.int64),
        np.ascontiguousarray(answers, np.float64),
        ties,
        order,
        prior,
        design,
    )


def require_maximum(comparisons: Comparisons, model: PairModel, remedy: str = REMEDY) -> None:
    """Raise `InputError` naming what cannot be placed if the likelihood has no finite maximum.

    remedy: what would help besides answers.
    """
    if len(comparisons.stimuli) < 2:
        raise InputError(
            f"there is one stimulus, {listed(comparisons.stimuli)}; allowed: 2 or more"
        )
    verdict = model.existence()
    if verdict == "apart":
        require_joined(comparisons)
        part = model.components().astype(np.int64)
        raise InputError(_why_apart(comparisons, part, remedy))
    if verdict == "order":
        raise InputError(
            "order=True: the answers cannot tell the effect of the side from the stimuli; allowed: "
            "answers in which the same pairs stand both ways round and neither side always wins"
        )
    if verdict == "ties":
        raise InputError(
            "ties=True: the answers put no upper end to how wide ties are, for no pair was "
            "answered both ways; allowed: more answers, or ties=False, which halves each tie"
        )


def require_joined(comparisons: Comparisons) -> None:
    """Raise `InputError` naming stimuli that no chain of answers joins to the others.

    How far apart such sets are, and which is ahead, only a prior would say.

    >>> require_joined(comparisons_of([("a", "b"), ("c", "d"), ("d", "e")]))
    Traceback (most recent call last):
    nacreous.problem.InputError: no scale joins all stimuli: "a", "b" were never compared with \
"c", "d", "e"; allowed: answers that join them
    """
    met = islands(comparisons)
    if met.max() == 0:
        return
    apart = _smallest([met == index for index in range(int(met.max()) + 1)])
    one, other = _named(comparisons, apart), _named(comparisons, ~apart)
    raise InputError(
        f"no scale joins all stimuli: {listed(one)} {_were(one)} never compared with "
        f"{listed(other)}; allowed: answers that join them"
    )


def require_choices(comparisons: Comparisons) -> None:
    """Raise `InputError` where every answer is a tie: nobody chose anything.

    >>> require_choices(comparisons_of({"left": ["a"], "right": ["b"], "chosen": ["tie"]}))
    Traceback (most recent call last):
    nacreous.problem.InputError: nobody chose anything: all answers are ties (1 of 1). Nothing can \
be told but that all stimuli were called equal; allowed: answers with choices among them
    """
    ties, total = float(comparisons.ties.sum()), comparisons.total
    if ties == total:
        raise InputError(
            f"nobody chose anything: all answers are ties ({ties:g} of {total:g}). Nothing can be "
            "told but that all stimuli were called equal; allowed: answers with choices among them"
        )


def _why_apart(comparisons: Comparisons, part: NDArray[np.int64], remedy: str) -> str:
    """In one line which stimuli cannot be placed, why, and what would help."""
    lowest, highest = part == 0, part == part.max()
    if lowest.sum() <= highest.sum():
        one, other, did = _named(comparisons, lowest), _named(comparisons, ~lowest), "never"
    else:
        one, other, did = _named(comparisons, highest), _named(comparisons, ~highest), "always"
    count = int(part.max()) + 1
    how_many = f" (there are {count} such sets)" if count > 2 else ""
    return (
        f"no scale holds {listed(one)}: {_were(one)} {did} preferred when compared with "
        f"{listed(other)}{how_many}, so the distance has no upper end; allowed: more answers "
        f"between these, until {'one' if did == 'never' else 'another'} is preferred{remedy}"
    )


def _were(labels: tuple[str, ...]) -> str:
    return "was" if len(labels) == 1 else "were"


def _named(comparisons: Comparisons, chosen: NDArray[np.bool_]) -> tuple[str, ...]:
    return tuple(comparisons.stimuli[index] for index in np.flatnonzero(chosen))


def _smallest(sets: list[NDArray[np.bool_]]) -> NDArray[np.bool_]:
    return min(sets, key=lambda members: int(members.sum()))


def islands(comparisons: Comparisons) -> NDArray[np.int64]:
    """The number of the set of stimuli, connected by any answers, that each one belongs to."""
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import connected_components

    size = len(comparisons.stimuli)
    graph = coo_array(
        (np.ones(len(comparisons)), (comparisons.left, comparisons.right)), shape=(size, size)
    )
    return np.asarray(connected_components(graph, directed=False)[1], np.int64)
