"""From choices to a scale, with honest doubt: paired comparisons of anything.

>>> import nacreous as nc
>>> nc.scaling.paper()
Comparisons(2184 answers, 7 stimuli, 21 pairs)
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from nacreous.scaling.answers import Answers
    from nacreous.scaling.column import Group
    from nacreous.scaling.comparisons import Comparisons, comparisons_of
    from nacreous.scaling.example import paper, paper_proportions

#: Where each public name lives. Loaded when first asked for, so that nothing heavy is until then.
_HOME = {
    "Answers": "answers",
    "Comparisons": "comparisons",
    "Group": "column",
    "comparisons_of": "comparisons",
    "paper": "example",
    "paper_proportions": "example",
}

__all__ = [
    "Answers",
    "Comparisons",
    "Group",
    "comparisons_of",
    "paper",
    "paper_proportions",
]


def __getattr__(name: str) -> Any:
    if name in _HOME:
        return getattr(import_module(f"nacreous.scaling.{_HOME[name]}"), name)
    raise AttributeError(f"module 'nacreous.scaling' has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted({*__all__, *globals()})
