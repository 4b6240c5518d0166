"""What a study has found so far: the people, the scale, the report."""

from nacreous.study.results.exported import exported_answers, exported_settings
from nacreous.study.results.people import people_flags
from nacreous.study.results.report import report
from nacreous.study.results.scale import Placed, ScaleSoFar, scale_so_far
from nacreous.study.task.flag import Flag

__all__ = [
    "Flag",
    "Placed",
    "ScaleSoFar",
    "exported_answers",
    "exported_settings",
    "people_flags",
    "report",
    "scale_so_far",
]


def __dir__() -> list[str]:
    """The public names, for completion."""
    return __all__
