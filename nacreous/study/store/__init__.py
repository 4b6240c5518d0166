"""Where a study's sessions and answers are kept: nothing lost, nothing counted twice."""

from nacreous.study.store.backup import Copied, backup, restore
from nacreous.study.store.coded import Coded
from nacreous.study.store.export import answers_of, counts, export
from nacreous.study.store.fault import StoreError
from nacreous.study.store.progress import PersonProgress, Progress
from nacreous.study.store.record import Answer, Event, Invitation, Receipt, Session
from nacreous.study.store.refusal import Conflict, NotAllowed, OutOfTurn, UnknownToken
from nacreous.study.store.store import Store
from nacreous.study.task.response import Response

__all__ = [
    "Answer",
    "Coded",
    "Conflict",
    "Copied",
    "Event",
    "Invitation",
    "NotAllowed",
    "OutOfTurn",
    "PersonProgress",
    "Progress",
    "Receipt",
    "Response",
    "Session",
    "Store",
    "StoreError",
    "UnknownToken",
    "answers_of",
    "backup",
    "counts",
    "export",
    "restore",
]


def __dir__() -> list[str]:
    """The public names, for completion."""
    return __all__
