"""What a study has found so far: the people, the scale, the report."""

from nacreous.study.results.flag import Flag
from nacreous.study.results.people import people_flags
from nacreous.study.results.report import report
from nacreous.study.results.scale import Placed, ScaleSoFar, scale_so_far

__all__ = ["Flag", "Placed", "ScaleSoFar", "people_flags", "report", "scale_so_far"]
