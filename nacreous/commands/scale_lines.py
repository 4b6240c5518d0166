"""What `nacreous scale` says in the terminal."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from nacreous.scaling.fit.scale import Scale
    from nacreous.scaling.report.analysis import Analysis


def told(found: Analysis, seconds: float) -> str:
    """In a few lines what was found."""
    fit, doubt = found.fit, found.doubt
    width = max(len(label) for label in fit.stimuli)
    lines = _people_told(found)
    lines += [
        f"{found.comparisons.total:g} answers on {len(fit.stimuli)} stimuli, {fit.model}, "
        f"{_fit_told(fit)}, in {fit.unit}; {100 * found.settings.level:g} % intervals by "
        f"{_BY[doubt.by]}, {seconds:.1f} s"
    ]
    for at in found.order:
        low, high = doubt.intervals[at]
        lines.append(f"{fit.stimuli[at]:{width}}  {fit.scale[at]:7.3f}  {low:7.3f} to {high:.3f}")
    if doubt.samples:
        lines.append(
            f"samples without a scale of their own: {doubt.without_maximum} of {doubt.samples}"
        )
    if doubt.too_few:
        lines.append(
            "these answers cannot tell how people differ; the intervals hold for these people alone"
        )
    together = "all people together: " if found.people_differ else ""
    lines.append(together + found.goodness.verdict)
    return "\n".join(lines)


def _fit_told(fit: Scale) -> str:
    """How it was fitted."""
    if fit.posterior is None:
        return fit.method
    spread = fit.posterior.spread
    return f"prior over the spread ({spread:.2f} {fit.own_unit})"


def _people_told(found: Analysis) -> list[str]:
    """Before the scale, that it is not that of each of the people; nothing where it may be."""
    people = found.people
    if people is None or not people.differ:
        return []
    shared, risk = people.shared, 1 - found.settings.level
    ways = ["other orders"] if shared.order_p_value < risk else []
    ways += ["sharper, or the other way round"] if shared.sharper_p_value < risk else []
    way = f" ({'; '.join(ways)})" if ways else ""
    lines = [f"people do not share one scale, p {shared.p_value:.3g}{way}"]
    described = people.population
    if described is None:
        return lines
    if described.kind == "classes":
        shares = ", ".join(f"{one.share:.2f}" for one in described.classes)
        said = f"{len(described.classes)} classes of people: {shares}"
        last = described.classes[1].correlation
        said += f"; correlation {last:.2f}" if len(described.classes) == 2 else ""
    elif described.kind == "spread":
        own = "z" if described.model == "probit" else "logit"
        said = f"values of their own, standard deviation {described.spread:.2f} {own}, no classes"
    else:
        said = "too slightly to describe how"
    return [*lines, said]


_BY = {
    "people": "resampling people",
    "answers": "resampling answers",
    "clusters": "people as clusters, Student's t",
    "information": "the model",
}
