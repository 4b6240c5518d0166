"""What a new study may call its parts, so that an export as CSV holds each of them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from nacreous.problem import InputError
from nacreous.scaling.data.column import group_column, text_column
from nacreous.scaling.data.nothing import is_nothing
from nacreous.scaling.data.table import table_of
from nacreous.spec.complaint import shown
from nacreous.study.design.design import Design

#: What exports put before a group that is called as a column of theirs.
PREFIX = "group_"


def check_exported_names(design: Design, where: str) -> None:
    """Refuse what an export would call by another's name, or write as others write an empty cell.

    Asked before a study is frozen: one that is frozen already keeps what it has. Raises
    `InputError` with a line for each.

    >>> group = {"name": "region", "values": ["na", "eu"]}
    >>> design = Design(
    ...     purpose="demo",
    ...     questions=[{"id": "q", "text": {"en": "Which?", "ja": "どちら?"}}],
    ...     stimuli=[{"label": name, "pearl": "paper"} for name in "ab"],
    ...     groups=[group],
    ... )
    >>> check_exported_names(design, "my.toml")
    Traceback (most recent call last):
    nacreous.problem.InputError: my.toml: groups.0.values are ["na", "eu"], of which programs ...
    """
    found = [f"{where}: {one}" for one in (*_group_names(design), *_empty_cells(design))]
    if found:
        raise InputError("\n".join(found))


def _group_names(design: Design) -> Iterator[str]:
    for place, group in enumerate(design.groups):
        if group.name.startswith(PREFIX):
            yield (
                f"groups.{place}.name is {shown(group.name)}; allowed: a name that does not begin "
                f"with {PREFIX}, by which exports tell groups from columns of their own"
            )


def _empty_cells(design: Design) -> Iterator[str]:
    for place, group in enumerate(design.groups):
        words = group_column(table_of({"value": list(group.values)}), "value").nothing
        if words:
            yield (
                f"groups.{place}.values are {shown(group.values)}, of which programs read "
                f"{' and '.join(words)} as an empty cell; allowed: other words"
            )
    labels = [(place, one) for place, each in enumerate(design.stimuli) for one in each.labels]
    for place, label in _nothing(labels):
        yield _read_as_empty(f"stimuli.{place}.label", label)
    for place, name in _nothing([(place, one.id) for place, one in enumerate(design.questions)]):
        yield _read_as_empty(f"questions.{place}.id", name)


def _nothing(named: Sequence[tuple[int, str]]) -> list[tuple[int, str]]:
    """Those of the texts, each with its place, that are words for nothing."""
    empty = is_nothing(text_column(table_of({"text": [text for _, text in named]}), "text"))
    return [one for one, nothing in zip(named, empty, strict=True) if nothing]


def _read_as_empty(key: str, text: str) -> str:
    return f"{key} is {shown(text)}, which programs read as an empty cell; allowed: another word"
