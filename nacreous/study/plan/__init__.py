"""What one participant sees, in which order and on which side; and the groups drawn by lot.

Everything follows from the study's design and the number of the participant's slot, 0, 1, 2, ...:
whoever comes back goes on where they were. The store gives slots (`nacreous.study.store.slots`).

>>> from nacreous.study.design import Design
>>> design = Design.load("paper")
>>> shown = trials(design, 0)
>>> len(shown), repetitions(shown), [trial.kind for trial in shown[:4]]
(28, 0, ['training', 'training', 'training', 'pair'])
"""

from nacreous.study.plan.allocation import drawn_groups
from nacreous.study.plan.sequence import trials
from nacreous.study.plan.trial import Trial, repetitions

__all__ = ["Trial", "drawn_groups", "repetitions", "trials"]


def __dir__() -> list[str]:
    """The public names, for completion."""
    return __all__
