"""How it was done, and how to do it again."""

from __future__ import annotations

import platform
import shlex
import tomllib
from base64 import b64encode
from html import escape
from importlib.metadata import version
from pathlib import Path

import nacreous
from nacreous.scaling.fit.spread import HIERARCHICAL
from nacreous.scaling.report import record
from nacreous.scaling.report.analysis import Analysis
from nacreous.scaling.report.translation import Html, Words, markup

__all__ = ["MOST_BYTES", "chapter"]

_REFERENCES = Path(__file__).parent.parent / "references.toml"
#: Data larger than this are not put into the page, which phones should still open.
MOST_BYTES = 2_000_000
#: Three labels in the lines of a JSON text, at the least.
_LEAST_TRIAD_BYTES = 30
_LEAST_ROW_BYTES = 6


def chapter(analysis: Analysis, words: Words) -> Html:
    """The methods, the data, the command, the references."""
    parts = [f"<p>{sentence}</p>\n" for sentence in _methods(analysis, words)]
    parts += [f"<h3>{words('method.again')}</h3>\n", again(analysis, words)]
    parts.append(f"<h3>{words('method.references')}</h3>\n")
    listed = "".join(f"<li>{escape(text)}</li>\n" for text in _cited(analysis))
    parts.append(f'<ol class="quiet">\n{listed}</ol>\n')
    return Html("".join(parts))


def _methods(analysis: Analysis, words: Words) -> list[Html]:
    wanted = analysis.settings
    found = [words(f"method.{wanted.model}.{wanted.method}")]
    with_ties = analysis.fit.tie_threshold is not None
    if with_ties:
        found.append(words("method.ties"))
    elif analysis.comparisons.ties.any():
        found.append(words("method.ties_half"))
        found += [words("method.ties_unfitted")] if analysis.ties_unfitted else []
    if wanted.order:
        found.append(words("method.order"))
    if wanted.prior == HIERARCHICAL:
        found.append(words("method.prior_hierarchical"))
    elif wanted.prior is not None:
        found.append(words("method.prior", prior=f"{wanted.prior:g}"))
    if wanted.prior is None and wanted.method == "maximum-likelihood":
        found.append(words("method.exists"))
    over_people = "method.apart_jackknife" if _left_out(analysis) else "method.apart_people"
    known = analysis.doubt.errors.clusters is not None
    found.append(words(over_people if known else "method.apart"))
    found.append(words("method.fit", risk=words.risk(wanted.level)))
    if analysis.people is not None:
        found.append(words("method.people", samples=analysis.people.shared.permutations))
    if analysis.people is not None and analysis.people.population is not None:
        found.append(words("method.population"))
    if analysis.goodness.mosteller is not None:
        found.append(words("method.mosteller"))
    found.append(words("method.consistency"))
    return found


def _left_out(analysis: Analysis) -> bool:
    """Whether errors come from leaving people out one by one."""
    return analysis.doubt.by == "jackknife"


def again(analysis: Analysis, words: Words) -> Html:
    """The data as a link, the command, the versions."""
    options = analysis.settings.options(words.language)
    if analysis.example:
        text, key = record.data_csv(analysis), "method.data_paper"
        link = _link("paper-counts.csv", "text/csv", text)
        command = f"nacreous scale paper -o report.html {options}"
    else:
        name = "counts.csv" if analysis.answers is None else "answers.csv"
        # Millions of rows, "a,b,a" at the least, need not be written to be found too long.
        rows = 0 if analysis.answers is None else len(analysis.answers)
        text = record.data_csv(analysis) if rows * _LEAST_ROW_BYTES <= MOST_BYTES else ""
        small = 0 < len(text.encode()) <= MOST_BYTES
        link = _link(name, "text/csv", text) if small else Html("")
        kind = "counts" if analysis.answers is None else "answers"
        key = f"method.data_{kind}" if small else "method.data_large"
        flags = shlex.join([*record.data_options(analysis), "-o", "report.html"])
        command = f"nacreous scale {name} {flags} {options}"
    scale = _link("scale.csv", "text/csv", record.csv(analysis))
    text = "" if _is_long(analysis) else record.json_text(analysis)
    if 0 < len(text) <= MOST_BYTES:
        everything = _link("scale.json", "application/json", text)
        numbers = words("method.record", csv=scale, json=everything)
    else:
        numbers = words("method.record_large", csv=scale)
    lines = [
        words(key, link=link) if link else words(key),
        Html(f"<code>{markup(command.strip())}</code>"),
        numbers,
        words("method.versions", versions=versions(), seed=analysis.settings.seed),
    ]
    if analysis.called:
        lines.insert(2, words("method.called"))
    return Html("".join(f"<p>{line}</p>\n" for line in lines))


def _is_long(analysis: Analysis) -> bool:
    """Whether the circular triads of thousands of people, by name, are too many to be written."""
    named = sum(one.triads.untied for one in analysis.consistency.people)
    return named * _LEAST_TRIAD_BYTES > MOST_BYTES


def versions() -> str:
    """The programs whose numbers these are."""
    names = ("numpy", "scipy", "matplotlib")
    own = [f"nacreous {nacreous.__version__}", f"Python {platform.python_version()}"]
    return ", ".join(own + [f"{name} {version(name)}" for name in names])


def _link(name: str, kind: str, text: str) -> Html:
    data = b64encode(text.encode()).decode("ascii")
    return Html(
        f'<a download="{name}" href="data:{kind};charset=utf-8;base64,{data}">{escape(name)}</a>'
    )


def _cited(analysis: Analysis) -> list[str]:
    texts = tomllib.loads(_REFERENCES.read_text(encoding="utf-8"))
    wanted = analysis.settings
    with_ties = analysis.fit.tie_threshold is not None
    used = {
        "thurstone": wanted.model == "probit",
        "ford": wanted.prior is None and wanted.method == "maximum-likelihood",
        "bradley": wanted.model == "logit",
        "glenn": with_ties and wanted.model == "probit",
        "davidson": with_ties and wanted.model == "logit",
        "beaver": wanted.order and wanted.model == "logit",
        "efron": analysis.doubt.samples > 0,
        "bell": analysis.doubt.errors.clusters is not None and not _left_out(analysis),
        "tukey": _left_out(analysis),
        "firth": wanted.method == "bias-reduced",
        "tierney": wanted.prior == HIERARCHICAL,
        "nagata": analysis.example or wanted.method == "least-squares",
        "perez": analysis.fit.unit in ("JOD", "JND"),
        "schwarz": analysis.people is not None and analysis.people.population is not None,
        "dempster": analysis.people is not None and analysis.people.population is not None,
        "mosteller": analysis.goodness.mosteller is not None,
    }
    return [text for key, text in texts.items() if used.get(key, True)]
