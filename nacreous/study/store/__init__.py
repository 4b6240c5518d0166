"""Where a study's sessions and answers are kept: nothing lost, nothing counted twice."""

from nacreous.study.store.fault import StoreError
from nacreous.study.store.progress import PersonProgress, Progress
from nacreous.study.store.record import Answer, Event, Receipt, Session
from nacreous.study.store.store import Store

__all__ = [
    "Answer",
    "Event",
    "PersonProgress",
    "Progress",
    "Receipt",
    "Session",
    "Store",
    "StoreError",
]
