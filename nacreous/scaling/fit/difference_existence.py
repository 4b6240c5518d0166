"""Whether judged differences have one most likely scale, and if not, which stimuli are to blame."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from nacreous.problem import InputError
from nacreous.scaling.data.fault import listed, quoted
from nacreous.scaling.fit.difference_model import design_of
from nacreous.scaling.fit.separation import recession

Array = NDArray[np.float64]

#: What counts as no part of a direction.
_NOTHING = 1e-7


def require_placed(stimuli: tuple[str, ...], design: Array) -> None:
    """Refuse judgements that leave open where some stimuli are; design: [question, stimulus]."""
    unseen = [stimuli[at] for at in np.flatnonzero(~design.any(axis=0))]
    if unseen:
        raise InputError(
            f"no scale holds {listed(unseen)}: no judgement tells of it; allowed: judgements with "
            "every stimulus, of pairs that do not repeat each other"
        )
    sets = _placed_together(design)
    if len(sets) == 1:
        return
    named = " | ".join(listed(stimuli[at] for at in part) for part in sets[:4])
    more = f" and {len(sets) - 4} more" if len(sets) > 4 else ""
    raise InputError(
        f"no scale joins all stimuli: no judgement tells how far apart {named}{more} are; allowed: "
        "judgements that join them"
    )


def are_placed(pairs: NDArray[np.int64], count: int) -> bool:
    """Whether questions [question, 4], each in order, place so many stimuli."""
    return len(_placed_together(design_of(pairs, count))) == 1


def _placed_together(design: Array) -> list[list[int]]:
    """Sets of stimuli whose distances are known; another set may move without a judgement's saying.

    Directions that leave all questions as they are move stimuli of one set alike.
    """
    sizes, directions = np.linalg.eigh(design.T @ design)
    free = directions[:, sizes <= _NOTHING * max(float(sizes[-1]), 1.0)]  # among them all alike
    sets: list[list[int]] = []
    for at, moves in enumerate(free):
        near = [part for part in sets if np.abs(free[part[0]] - moves).max() < _NOTHING]
        near[0].append(at) if near else sets.append([at])
    return sets


def require_end(stimuli: tuple[str, ...], design: Array, counts: Array) -> None:
    """Refuse judgements to which some scale without bounds, or without noise, does full justice.

    In steps from each stimulus to the next a direction without loss names those that have no end
    (a linear programme: Konis 2007).
    """
    steps = design[:, ::-1].cumsum(axis=1)[:, ::-1][:, 1:]
    first, second = counts.T > 0
    both = first & second
    rising = np.vstack((steps[first & ~both], -steps[second & ~both]))
    direction = recession(steps[both], rising)
    if direction is None:
        return
    if not both.any() and (rising @ direction).min() > _NOTHING:
        raise InputError(
            "no judgement contradicts any other: a scale without noise explains all, so that its "
            "unit, the noise, has no lower end; allowed: more judgements, of differences that are "
            "nearly alike, until some are judged either way"
        )
    endless = np.flatnonzero(np.abs(direction) > _NOTHING)
    named = ", ".join(f"{quoted(stimuli[at])} to {quoted(stimuli[at + 1])}" for at in endless[:6])
    more = f" and {len(endless) - 6} more" if len(endless) > 6 else ""
    raise InputError(
        f"no scale holds the distances {named}{more}: all judgements that tell of them agree, so "
        "that they have no end; allowed: more judgements of these, until some are judged either way"
    )
