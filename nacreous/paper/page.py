"""The figures as one HTML page that needs nothing else: pictures inside, no script, no request."""

from __future__ import annotations

import base64
import struct
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING

from nacreous.paper.exhibit import Exhibit, Plate, Quotation
from nacreous.paper.measurement import Measurement

if TYPE_CHECKING:
    from nacreous.paper.make import Paper

__all__ = ["html"]

#: For a picture of a few pixels, of which each shall be seen.
_SMALL = ' class="small"'
_STYLE = Path(__file__).with_name("page.css")


def html(paper: Paper) -> str:
    """The page, as UTF-8 text; the pictures' files must still be there."""
    sections = "".join(_section(shown) for shown in paper.exhibits)
    return f"""<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>The pearl of 1996, made again</title>
<style>
{_STYLE.read_text(encoding="utf-8")}</style>
</head>
<body>
{_header(paper)}
<main>
{sections}</main>
{_footer(paper)}
</body>
</html>
"""


def _header(paper: Paper) -> str:
    links = " ".join(
        f'<a href="#{_anchor(shown)}">{escape(shown.number)}</a>' for shown in paper.exhibits
    )
    return f"""<header>
<h1>The pearl of 1996, made again</h1>
<p class="source"><span lang="ja">長田典子，宇佐美照夫，眞鍋佳嗣，井口征士：
品質評価のためのビジュアルシミュレーションによる真珠の表現，1996年</span><br>
N. Nagata, T. Usami, Y. Manabe and S. Inokuchi: <cite>Modeling and Rendering of Pearl for Quality
Evaluation with Visual Simulation</cite>, 1996.</p>
<p>Each figure of the paper that can be made again stands here beside the sentences it must satisfy
and the numbers measured on our own pictures and tables. The English of the quotations is ours, the
captions are the paper’s; (ours) marks what the paper leaves open. The three qualities by which
inspectors judge are depth <span lang="ja">深み感</span>, shininess
<span lang="ja">輝き感</span> and grain <span lang="ja">きめ感</span>.</p>
<p class="summary">{_summary(paper)}</p>
<nav aria-label="Figures">Figure {links}</nav>
</header>"""


def _summary(paper: Paper) -> str:
    asked = [(shown, measured) for shown in paper.exhibits for measured in shown.asked]
    missed = [shown for shown, measured in asked if not measured.holds]
    if not missed:
        return f"All {len(asked)} criteria hold."
    # Each figure once, in order.
    figures = {_anchor(shown): shown.number for shown in missed}
    links = ", ".join(f'<a href="#{at}">{escape(number)}</a>' for at, number in figures.items())
    held = len(asked) - len(missed)
    return f"{held} of {len(asked)} criteria hold; those that do not belong to figure {links}."


def _section(shown: Exhibit) -> str:
    large = "".join(_plate(shown, plate) for plate in shown.plates if not plate.small)
    small = "".join(_plate(shown, plate) for plate in shown.plates if plate.small)
    row = f'<div class="row">{small}</div>' if small else ""
    quotations = "".join(_quotation(quoted) for quoted in shown.quotations)
    remarks = "".join(f"<p>{escape(remark)}</p>" for remark in shown.remarks)
    return f"""<section id="{_anchor(shown)}">
<h2>Figure {escape(shown.number)}
<small><span lang="ja">{escape(shown.japanese)}</span> {escape(shown.english)}</small></h2>
<div class="pictures">{large}{row}</div>
<div class="text">
{quotations}
{_table(shown.measurements)}
{remarks}
<p>Again: <code>{escape(shown.command)}</code></p>
</div>
</section>
"""


def _plate(shown: Exhibit, plate: Plate) -> str:
    content = plate.path.read_bytes()
    width, height = struct.unpack(">II", content[16:24])  # a PNG's IHDR comes first
    data = base64.b64encode(content).decode("ascii")
    label = f"<figcaption>{escape(plate.label)}</figcaption>" if plate.label else ""
    return (
        f"<figure{_SMALL if plate.small else ''}>"
        f'<img src="data:image/png;base64,{data}" width="{width}" height="{height}" '
        f'alt="{escape(shown.alt(plate))}">{label}</figure>'
    )


def _quotation(quoted: Quotation) -> str:
    return (
        f'<blockquote><p lang="ja">{escape(quoted.japanese)}</p><p>{escape(quoted.english)} '
        f"<cite>Section {escape(quoted.section)}</cite></p></blockquote>"
    )


def _table(measurements: list[Measurement]) -> str:
    rows = "".join(_row(measured) for measured in measurements)
    return (
        '<table><thead><tr><th scope="col">measured</th><th scope="col">value</th>'
        '<th scope="col">wanted</th><th scope="col"></th></tr></thead>'
        f"<tbody>{rows}</tbody></table>"
    )


def _row(measured: Measurement) -> str:
    verdict = {True: ("holds", "holds"), False: ("fails", "does not hold"), None: ("told", "")}
    kind, words = verdict[measured.holds]
    return (
        f'<tr class="{kind}"><th scope="row">{escape(measured.quantity)}</th>'
        f"<td>{escape(measured.shown)}</td><td>{escape(measured.criterion)}</td><td>{words}</td></tr>"
    )


def _footer(paper: Paper) -> str:
    settings = paper.settings
    versions = ", ".join(f"{name} {number}" for name, number in settings["versions"].items())
    files = "".join(
        f"<details><summary>The {name} file</summary><pre>{escape(text)}</pre></details>"
        for name, text in paper.files.items()
    )
    return f"""<footer>
<h2>How it was made</h2>
<p><code>nacreous paper FOLDER --size {settings["size"]}</code>, {settings["samples"]} samples a
pixel, seed of the nacre {settings["seed"]}, seed of the texture {settings["texture_seed"]};
{escape(versions)}. The same seeds give the same pictures. All numbers are also in
<code>measurements.json</code>, and every picture file carries the pearl, the scene, the seeds and
the versions it was made with.</p>
{files}
</footer>"""


def _anchor(shown: Exhibit) -> str:
    return "figure-" + "".join(letter for letter in shown.number if letter.isalnum())
