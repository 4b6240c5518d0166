"""From choices to a scale, with honest doubt: paired comparisons of anything.

>>> import nacreous as nc
>>> nc.scaling.paper()
Comparisons(2184 answers, 7 stimuli, 21 pairs)
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from nacreous.scaling.check.checkup import Consistency, consistency
    from nacreous.scaling.check.kendall import Agreement, agreement
    from nacreous.scaling.check.misfit import Goodness, Misfit, goodness
    from nacreous.scaling.check.person import PersonalTriads, triads_by_person
    from nacreous.scaling.check.repetition import Retest, retest
    from nacreous.scaling.check.response import ResponseTime, response_time
    from nacreous.scaling.check.share import Share
    from nacreous.scaling.check.side import SideBias, side_bias
    from nacreous.scaling.check.transitive import Transitivity, Violation, transitivity
    from nacreous.scaling.check.triads import Triads, circular_triads
    from nacreous.scaling.compare.attribute_line import Prediction
    from nacreous.scaling.compare.attributes import (
        AttributeFit,
        AttributeTest,
        AttributeWeight,
        fit_attributes,
    )
    from nacreous.scaling.compare.groups import (
        GroupComparison,
        GroupDifference,
        GroupTest,
        compare_groups,
    )
    from nacreous.scaling.compare.ratio import (
        ClusterRatio,
        RatioChange,
        cluster_ratio,
        compare_ratios,
    )
    from nacreous.scaling.compare.sets import SetComparison, compare_sets
    from nacreous.scaling.data.answers import Answers
    from nacreous.scaling.data.column import Grouping
    from nacreous.scaling.data.comparisons import Comparisons, comparisons_of
    from nacreous.scaling.data.example import paper, paper_proportions
    from nacreous.scaling.figure import interval_plot, matrix_plot, scale_plot
    from nacreous.scaling.fit.bootstrap import Bootstrap
    from nacreous.scaling.fit.bradley import bradley_terry
    from nacreous.scaling.fit.case_v import thurstone
    from nacreous.scaling.fit.scale import Scale
    from nacreous.scaling.fit.uncertainty import Difference
    from nacreous.scaling.planning.design import (
        PairDesign,
        cyclic_design,
        full_design,
        random_design,
    )
    from nacreous.scaling.planning.forecast import Needed, Power, Precision
    from nacreous.scaling.planning.plan import Plan
    from nacreous.scaling.planning.selection import NextPair, next_pairs
    from nacreous.scaling.planning.simulation import simulate
    from nacreous.scaling.report.analysis import Analysis, analyse

#: Where each public name lives. Loaded when first asked for, so that nothing heavy is until then.
_HOME = {
    "Agreement": "check.kendall",
    "Analysis": "report.analysis",
    "Answers": "data.answers",
    "AttributeFit": "compare.attributes",
    "AttributeTest": "compare.attributes",
    "AttributeWeight": "compare.attributes",
    "Bootstrap": "fit.bootstrap",
    "ClusterRatio": "compare.ratio",
    "Comparisons": "data.comparisons",
    "Consistency": "check.checkup",
    "Design": "planning.design",
    "Difference": "fit.uncertainty",
    "Goodness": "check.misfit",
    "Group": "data.column",
    "GroupComparison": "compare.groups",
    "GroupDifference": "compare.groups",
    "GroupTest": "compare.groups",
    "Grouping": "data.column",
    "Misfit": "check.misfit",
    "Needed": "planning.forecast",
    "NextPair": "planning.selection",
    "PairDesign": "planning.design",
    "PersonalTriads": "check.person",
    "Plan": "planning.plan",
    "Power": "planning.forecast",
    "Precision": "planning.forecast",
    "Prediction": "compare.attribute_line",
    "RatioChange": "compare.ratio",
    "ResponseTime": "check.response",
    "Retest": "check.repetition",
    "Scale": "fit.scale",
    "SetComparison": "compare.sets",
    "Share": "check.share",
    "SideBias": "check.side",
    "Study": "report.analysis",
    "Transitivity": "check.transitive",
    "Triads": "check.triads",
    "Violation": "check.transitive",
    "agreement": "check.kendall",
    "analyse": "report.analysis",
    "bradley_terry": "fit.bradley",
    "circular_triads": "check.triads",
    "cluster_ratio": "compare.ratio",
    "compare_groups": "compare.groups",
    "compare_ratios": "compare.ratio",
    "compare_sets": "compare.sets",
    "comparisons_of": "data.comparisons",
    "consistency": "check.checkup",
    "cyclic_design": "planning.design",
    "fit_attributes": "compare.attributes",
    "full_design": "planning.design",
    "goodness": "check.misfit",
    "interval_plot": "figure",
    "matrix_plot": "figure",
    "next_pairs": "planning.selection",
    "paper": "data.example",
    "paper_proportions": "data.example",
    "random_design": "planning.design",
    "response_time": "check.response",
    "retest": "check.repetition",
    "scale_plot": "figure",
    "side_bias": "check.side",
    "simulate": "planning.simulation",
    "study": "report.analysis",
    "thurstone": "fit.case_v",
    "transitivity": "check.transitive",
    "triads_by_person": "check.person",
}

__all__ = [
    "Agreement",
    "Analysis",
    "Answers",
    "AttributeFit",
    "AttributeTest",
    "AttributeWeight",
    "Bootstrap",
    "ClusterRatio",
    "Comparisons",
    "Consistency",
    "Difference",
    "Goodness",
    "GroupComparison",
    "GroupDifference",
    "GroupTest",
    "Grouping",
    "Misfit",
    "Needed",
    "NextPair",
    "PairDesign",
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
    "Transitivity",
    "Triads",
    "Violation",
    "agreement",
    "analyse",
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
