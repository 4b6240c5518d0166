"""Drawings inside a page: SVG that is part of the HTML, once wide and once for a phone."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path
from tempfile import TemporaryDirectory

from nacreous.scaling.report.translation import Html, language_of, markup

__all__ = ["WIDE_PT", "picture"]

WIDE_PT, NARROW_PT = 500.0, 255.0

Draw = Callable[[Path, float], None]


def picture(draw: Draw, name: str, alt: str, caption: Html, wide_pt: float = WIDE_PT) -> Html:
    """A figure of the page. draw: makes an SVG file of so many points' width; called twice.

    name: makes the drawing's marks unique on the page. alt: what is to be seen, for those who
    cannot.
    """
    variants = [("wide", wide_pt)]
    variants += [("narrow", NARROW_PT)] if wide_pt > NARROW_PT else []
    shown = ""
    with TemporaryDirectory() as folder:
        for kind, width_pt in variants:
            path = Path(folder, f"{kind}.svg")
            draw(path, width_pt)
            text = path.read_text(encoding="utf-8")
            shown += inline(text, f"{name}-{kind}", kind if len(variants) > 1 else "", alt)
    return Html(f"<figure>{shown}<figcaption>{caption}</figcaption></figure>\n")


def inline(svg: str, prefix: str, kind: str, alt: str) -> str:
    """An SVG of matplotlib as an element of a page: no prologue, no metadata, marks of its own.

    >>> inline('<?xml?><svg width="1pt" viewBox="0 0 1 1"><g id="axes_1"/></svg>', "a", "", "dot")
    '<svg role="img" aria-label="dot" width="1pt" viewBox="0 0 1 1"><g/></svg>'
    """
    svg = svg[svg.index("<svg") :].strip()
    svg = re.sub(r"<metadata>.*?</metadata>|<style.*?</style>", "", svg, flags=re.DOTALL)
    svg = re.sub(r' (?:xmlns(?::xlink)?|version)="[^"]*"', "", svg)
    svg = svg.replace("xlink:href", "href")
    # The page's own fonts and colours of text are set in its style sheet.
    svg = re.sub(r"'DejaVu Sans'[^;\"]*", "sans-serif", svg)
    used = {*re.findall(r"url\(#([^)]+)\)", svg), *re.findall(r'href="#([^"]+)"', svg)}
    svg = re.sub(r' id="([^"]+)"', lambda m: f' id="{prefix}-{m[1]}"' if m[1] in used else "", svg)
    svg = re.sub(r"url\(#([^)]+)\)", rf"url(#{prefix}-\1)", svg)
    svg = re.sub(
        r"<text\b(.*?</text>)",
        lambda found: f"<text{language_of(found[1])}{found[1]}",
        svg,
        flags=re.DOTALL,
    )
    svg = re.sub(r'href="#([^"]+)"', rf'href="#{prefix}-\1"', svg)
    look = f' class="{kind}"' if kind else ""
    head = f'<svg{look} role="img" aria-label="{markup(alt)}"'
    svg = svg.replace("<svg", head, 1)
    return re.sub(r">\s+<(?!tspan)", "><", svg)
