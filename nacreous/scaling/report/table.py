"""Tables of a page."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from nacreous.scaling.report.translation import Html, markup

__all__ = ["facts", "table"]


def table(
    heads: Sequence[object], rows: Iterable[Sequence[object]], kinds: Sequence[str] = ()
) -> Html:
    """A table; the first column names its row. kinds: a class for each column, "n" for numbers."""
    classes = [f' class="{kind}"' if kind else "" for kind in kinds] or [""] * len(heads)
    head = "".join(
        f'<th scope="col"{look}>{markup(text)}</th>'
        for text, look in zip(heads, classes, strict=True)
    )
    body = "".join(_row(row, classes) for row in rows)
    return Html(
        f'<div class="scroll"><table><thead><tr>{head}</tr></thead>'
        f"<tbody>{body}</tbody></table></div>\n"
    )


def _row(cells: Sequence[object], classes: Sequence[str]) -> str:
    first, *others = cells
    rest = "".join(
        f"<td{look}>{markup(cell)}</td>" for cell, look in zip(others, classes[1:], strict=True)
    )
    return f'<tr><th scope="row"{classes[0]}>{markup(first)}</th>{rest}</tr>\n'


def facts(items: Iterable[tuple[object, object]]) -> Html:
    """Names with their values."""
    rows = "".join(f"<dt>{markup(name)}</dt><dd>{markup(value)}</dd>\n" for name, value in items)
    return Html(f'<dl class="facts">{rows}</dl>\n')
