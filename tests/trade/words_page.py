"""The table of docs/words.md from the package; `python -m tests.trade.words_page` writes it."""

from __future__ import annotations

from pathlib import Path

from nacreous.trade import Factor, Range, Word, factors

PAGE = Path(__file__).parents[2] / "docs/words.md"
BEGIN, END = "<!-- the table: begin -->\n", "<!-- the table: end -->\n"
HEAD = (
    "| word | 日本語 | quantity | from | to below | key | source |\n|---|---|---|---|---|---|---|\n"
)


def table() -> str:
    return "\n".join(f"### {one.name} / {one.ja}\n\n{HEAD}{_rows(one)}" for one in factors())


def _rows(factor: Factor) -> str:
    words = factor.words
    if factor.name == "size":  # a class for each half millimetre, of which three say enough
        words = (*words[:2], words[-1])
    return "".join(_row(word, one) for word in words for one in word.ranges)


def _row(word: Word, one: Range) -> str:
    upper = "" if one.upper == float("inf") else f"{one.upper:g}"
    unit = f", {one.unit}" if one.unit else ""
    key = f"`{one.key}` = {one.sets:g}" if one.key else ""
    cells = word.en, word.ja, f"`{one.quantity}`{unit}", f"{one.lower:g}", upper, key, one.source
    return f"| {' | '.join(cells)} |\n"


def shown() -> str:
    """The table on the page."""
    return PAGE.read_text("utf-8").partition(BEGIN)[2].partition(END)[0]


if __name__ == "__main__":
    before, _, rest = PAGE.read_text("utf-8").partition(BEGIN)
    PAGE.write_text(f"{before}{BEGIN}\n{table()}\n{END}{rest.partition(END)[2]}", "utf-8")
