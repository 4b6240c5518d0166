"""How consistent the answers are: circles, agreement, people, sides, repeats, times."""

from __future__ import annotations

import numpy as np

from nacreous.scaling.check.triads import Triads
from nacreous.scaling.report.analysis import Analysis
from nacreous.scaling.report.translation import Html, Words, number, percent, thousands

__all__ = ["chapter"]

_MOST_CIRCLES, _MOST_PEOPLE = 4, 12


def chapter(analysis: Analysis, words: Words) -> Html:
    """One sentence or two for each thing that these answers allow to say."""
    found = [
        *_triads(analysis, words),
        *_agreement(analysis, words),
        *_people(analysis, words),
        *_retest(analysis, words),
        *_side(analysis, words),
        *_always_tied(analysis, words),
        *_response(analysis, words),
    ]
    return Html("".join(f"<p>{said}</p>\n" for said in found or [words("consistency.nothing")]))


def _triads(analysis: Analysis, words: Words) -> list[Html]:
    triads, broken = analysis.consistency.triads, analysis.consistency.transitivity
    if triads is None or broken is None or not triads.complete:
        return []
    if triads.tied == analysis.pairs:
        return [words("consistency.no_majority")]
    if triads.tied:
        said = _circles_of_coins(triads, words)
    elif triads.circular:
        said = words(
            "consistency.triads_some",
            sets=words.count("triad", triads.complete),
            circular=thousands(triads.circular),
            named=_named(triads, words),
        )
    else:
        said = words("consistency.triads_none")
    if triads.zeta is not None:
        said = words.sentences(said, words("consistency.zeta", zeta=number(triads.zeta)))
    rules = words(
        "consistency.transitivity",
        weak=broken.weak,
        moderate=broken.moderate,
        strong=broken.strong,
        sets=words.count("triad", broken.triads),
    )
    return [said, rules]


def _circles_of_coins(triads: Triads, words: Words) -> Html:
    """Circles where pairs have no majority: a mean, and said to be one."""
    return words(
        "consistency.triads_tied",
        tied=words.count("pair", triads.tied),
        sets=words.count("triad", triads.complete),
        circular=thousands(triads.circular),
        named=_named(triads, words),
    )


def _named(triads: Triads, words: Words) -> Html:
    """The circles in brackets; nothing where none is known by name."""
    named = [
        words("consistency.triad", **dict(zip("abc", map(words.name, triad), strict=True)))
        for triad in triads.named
    ]
    if not named:
        return Html("")
    return words("consistency.named", inside=words.listed(named, _MOST_CIRCLES))


def _agreement(analysis: Analysis, words: Words) -> list[Html]:
    agreed = analysis.consistency.agreement
    if agreed is None:
        return []
    said = [words("consistency.agreement", u=number(agreed.u), same=percent((1 + agreed.u) / 2))]
    if agreed.ties:
        said.append(words("consistency.agreement_ties", ties=percent(agreed.ties)))
    return [words.sentences(*said)]


def _people(analysis: Analysis, words: Words) -> list[Html]:
    people = analysis.consistency.people
    full = len(analysis.fit.stimuli)
    # Only those who saw all the things: a zeta of three things says little beside one of seven.
    known = [
        (own.triads.zeta, own.person, own.triads.tied)
        for own in people
        if own.triads.zeta is not None and len(own.triads.wins) == full
    ]
    if not people or full < 3:
        return []
    if not known:
        return [words("consistency.people_none")]
    zetas = np.array([zeta for zeta, _, _ in known])
    least = int(zetas.argmin())
    said = words(
        "consistency.people",
        median=number(float(np.median(zetas))),
        least=number(float(zetas[least])),
        person=words.name(known[least][1]),
    )
    if any(tied for _, _, tied in known):
        said = words.sentences(said, words("consistency.people_tied"))
    return [said]


def _retest(analysis: Analysis, words: Words) -> list[Html]:
    again = analysis.consistency.retest
    if again is None:
        return []
    return [words("consistency.retest", **_share(again.agreement))]


def _side(analysis: Analysis, words: Words) -> list[Html]:
    side = analysis.consistency.side
    if side is None:
        return []
    if side.p_value is None:
        verdict = "untold"
    else:
        verdict = "some" if side.p_value < 1 - analysis.settings.level else "none"
        verdict = verdict if side.exchanged else f"within_{verdict}"
    said = [
        words("consistency.side", **_share(side.left), verdict=words(f"consistency.side_{verdict}"))
    ]
    if analysis.fit.order_effect is not None:
        said.append(
            words("consistency.order_effect", value=number(analysis.fit.order_effect, sign=True))
        )
    if side.biased:
        people = words.names(side.biased, _MOST_PEOPLE)
        said.append(words("consistency.side_people", people=people))
    return [words.sentences(*said)]


def _always_tied(analysis: Analysis, words: Words) -> list[Html]:
    """Who never chose, one by one."""
    return [
        words("consistency.always_tied", person=words.name(one.person), ties=one.ties, of=one.of)
        for one in analysis.consistency.always_tied[:_MOST_PEOPLE]
    ]


def _response(analysis: Analysis, words: Words) -> list[Html]:
    times = analysis.consistency.response
    if times is None:
        return []
    said = [words("consistency.response", median=number(times.median_s))]
    if len(times.too_fast):
        values = {
            "count": words.count("answer", len(times.too_fast)),
            "fastest": f"{times.fastest_s:g}",
        }
        if times.hasty:
            people = words.names(times.hasty, _MOST_PEOPLE)
            said.append(words("consistency.response_hasty", people=people, **values))
        else:
            said.append(words("consistency.response_fast", **values))
    if times.correlation is not None and times.p_value is not None:
        near = times.correlation < 0 and times.p_value < 1 - analysis.settings.level
        key = "consistency.response_near" if near else "consistency.response_flat"
        said.append(words(key, r=number(times.correlation)))
    return [words.sentences(*said)]


def _share(share: object) -> dict[str, str]:
    return {
        "share": percent(share.share),  # type: ignore[attr-defined]
        "low": percent(share.low),  # type: ignore[attr-defined]
        "high": percent(share.high),  # type: ignore[attr-defined]
    }
