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
    from nacreous.scaling.attribute_line import Prediction
    from nacreous.scaling.attributes import (
        AttributeFit,
        AttributeTest,
        AttributeWeight,
        fit_attributes,
    )
    from nacreous.scaling.bootstrap import Bootstrap
    from nacreous.scaling.bradley import bradley_terry
    from nacreous.scaling.case_v import thurstone
    from nacreous.scaling.checkup import Consistency, consistency
    from nacreous.scaling.column import Group
    from nacreous.scaling.comparisons import Comparisons, comparisons_of
    from nacreous.scaling.design import Design, cyclic_design, full_design, random_design
    from nacreous.scaling.example import paper, paper_proportions
    from nacreous.scaling.figure import interval_plot, matrix_plot, scale_plot
    from nacreous.scaling.forecast import Needed, Power, Precision
    from nacreous.scaling.groups import GroupComparison, GroupDifference, GroupTest, compare_groups
    from nacreous.scaling.kendall import Agreement, agreement
    from nacreous.scaling.misfit import Goodness, Misfit, goodness
    from nacreous.scaling.person import PersonalTriads, triads_by_person
    from nacreous.scaling.plan import Plan
    from nacreous.scaling.ratio import ClusterRatio, RatioChange, cluster_ratio, compare_ratios
    from nacreous.scaling.repetition import Retest, retest
    from nacreous.scaling.report.analysis import Study, study
    from nacreous.scaling.response import ResponseTime, response_time
    from nacreous.scaling.scale import Scale
    from nacreous.scaling.selection import NextPair, next_pairs
    from nacreous.scaling.sets import SetComparison, compare_sets
    from nacreous.scaling.share import Share
    from nacreous.scaling.side import SideBias, side_bias
    from nacreous.scaling.simulation import simulate
    from nacreous.scaling.transitive import Transitivity, Violation, transitivity
    from nacreous.scaling.triads import Triads, circular_triads
    from nacreous.scaling.uncertainty import Difference

#: Where each public name lives. Loaded when first asked for, so that nothing heavy is until then.
_HOME = {
    "Agreement": "kendall",
    "Answers": "answers",
    "AttributeFit": "attributes",
    "AttributeTest": "attributes",
    "AttributeWeight": "attributes",
    "Bootstrap": "bootstrap",
    "ClusterRatio": "ratio",
    "Comparisons": "comparisons",
    "Consistency": "checkup",
    "Design": "design",
    "Difference": "uncertainty",
    "Goodness": "misfit",
    "Group": "column",
    "GroupComparison": "groups",
    "GroupDifference": "groups",
    "GroupTest": "groups",
    "Misfit": "misfit",
    "Needed": "forecast",
    "NextPair": "selection",
    "PersonalTriads": "person",
    "Plan": "plan",
    "Power": "forecast",
    "Precision": "forecast",
    "Prediction": "attribute_line",
    "RatioChange": "ratio",
    "ResponseTime": "response",
    "Retest": "repetition",
    "Scale": "scale",
    "SetComparison": "sets",
    "Share": "share",
    "SideBias": "side",
    "Study": "report.analysis",
    "Transitivity": "transitive",
    "Triads": "triads",
    "Violation": "transitive",
    "agreement": "kendall",
    "bradley_terry": "bradley",
    "circular_triads": "triads",
    "cluster_ratio": "ratio",
    "compare_groups": "groups",
    "compare_ratios": "ratio",
    "compare_sets": "sets",
    "comparisons_of": "comparisons",
    "consistency": "checkup",
    "cyclic_design": "design",
    "fit_attributes": "attributes",
    "full_design": "design",
    "goodness": "misfit",
    "interval_plot": "figure",
    "matrix_plot": "figure",
    "next_pairs": "selection",
    "paper": "example",
    "paper_proportions": "example",
    "random_design": "design",
    "response_time": "response",
    "retest": "repetition",
    "scale_plot": "figure",
    "side_bias": "side",
    "simulate": "simulation",
    "study": "report.analysis",
    "thurstone": "case_v",
    "transitivity": "transitive",
    "triads_by_person": "person",
}

__all__ = [
    "Agreement",
    "Answers",
    "AttributeFit",
    "AttributeTest",
    "AttributeWeight",
    "Bootstrap",
    "ClusterRatio",
    "Comparisons",
    "Consistency",
    "Design",
    "Difference",
    "Goodness",
    "Group",
    "GroupComparison",
    "GroupDifference",
    "GroupTest",
    "Misfit",
    "Needed",
    "NextPair",
    "PersonalTriads",
    "Plan",
    "Power",
    "Precision",
    "Prediction",
    "RatioChange",
    "ResponseTime",
    "Retest",
    "Scale",
    "SetComparison",
    "Share",
    "SideBias",
    "Study",
    "Transitivity",
    "Triads",
    "Violation",
    "agreement",
    "bradley_terry",
    "circular_triads",
    "cluster_ratio",
    "compare_groups",
    "compare_ratios",
    "compare_sets",
    "comparisons_of",
    "consistency",
    "cyclic_design",
    "fit_attributes",
    "full_design",
    "goodness",
    "interval_plot",
    "matrix_plot",
    "next_pairs",
    "paper",
    "paper_proportions",
    "random_design",
    "response_time",
    "retest",
    "scale_plot",
    "side_bias",
    "simulate",
    "study",
    "thurstone",
    "transitivity",
    "triads_by_person",
]


def __getattr__(name: str) -> Any:
    if name in _HOME:
        return getattr(import_module(f"nacreous.scaling.{_HOME[name]}"), name)
    raise AttributeError(f"module 'nacreous.scaling' has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted({*__all__, *globals()})
