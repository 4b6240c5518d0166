"""The columns of an export, each described; and what describes them to machines (Psych-DS)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from nacreous.scaling.data.spreadsheet import NOTE
from nacreous.study.design.exported_names import PREFIX
from nacreous.study.store.person_columns import IDENTIFYING, PERSON
from nacreous.study.store.progress import Progress
from nacreous.study.task.column import Column
from nacreous.study.task.counting import KINDS
from nacreous.study.task.tasks import TASKS, columns_of_tasks

_TIME = "UTC, ISO 8601; of an erased person the day only"

COLUMNS = (
    Column("sequence", "Order in which the answers were stored, whatever any clock said."),
    Column(
        "person",
        "Number of the participant in order of entry, from 0; of an erased person a random name, "
        "the same for all of that person's answers.",
    ),
    Column("trial", "Number of the trial in the person's plan, from 0; empty for erased people."),
    Column("kind", "Training and catch trials are no data for a scale.", None, KINDS),
    Column("question", "Id of the question asked."),
    *columns_of_tasks(),
    Column("response_ms", "From showing to choosing; empty where unknown or erased.", "ms"),
    Column("shown_at", f"When the pair was shown, by the participant's clock; {_TIME}."),
    Column("answered_at", f"When one was chosen, by the participant's clock; {_TIME}."),
    Column("received_at", f"When the answer arrived, by the server's clock; {_TIME}."),
    Column("language", "Language of the pages that the person saw."),
    Column("excluded", "Why this person's answers are not to be counted; empty: they are."),
    Column("simulated", "Whether a program gave this answer.", None, ("true", "false")),
    Column("erased", "Whether the person was erased.", None, ("true", "false")),
    Column(
        "flags",
        "What was noticed while the answer was given, as JSON: early, away (how often), resized, "
        "not_kept (true), shrunk (the factor). Only with what may identify a person: whatever else "
        "a page sent.",
    ),
)

#: Of people, a row for everyone who has entered, before and after `PERSON`.
PEOPLE = (
    Column("person", "Number of the participant in order of entry, from 0."),
    Column("language", "Language of the pages that the person saw."),
    Column("excluded", "Why this person's answers are not to be counted; empty: they are."),
    Column("simulated", "Whether a program gave any of the answers.", None, ("true", "false")),
    Column("erased", "Whether the person was erased.", None, ("true", "false")),
    Column("slot", "From which the person's trials and groups follow; of a drop-out given again."),
    Column("answers", "How many answers of the person are stored."),
    Column("trials", "How many trials the person's plan has."),
)
PLAN = Column("plan", "The trials that the person was to see, in order, as JSON.")

#: Of the log of the store, a row a line; and what may identify somebody.
LOG = (
    Column("at", f"When it happened, by the server's clock; {_TIME}."),
    Column("what", "What was done, or refused."),
    Column("person", "Number of the participant whom it was done by or to; empty: none."),
)
LOG_IDENTIFYING = (
    Column("who", "Who did it: participant, or the experimenter's name."),
    Column("detail", "More of it, as JSON: reasons, and each answer that was refused, whole."),
)

#: Of a study whose plans hang on no answers.
BEFOREHAND = "beforehand"
#: Of every export, so that one that lacks it is known not to be whole.
CHOSEN_BY = Column(
    "pairs_chosen_by",
    "How pairs were chosen: by the answers so far the most telling ones (greedy), or such drawn by "
    "lot (drawn); or beforehand.",
    None,
    ("greedy", "drawn", BEFOREHAND),
)

_OWN = (*COLUMNS, CHOSEN_BY, *PERSON, *IDENTIFYING, *PEOPLE, PLAN, *LOG, *LOG_IDENTIFYING)
_NAMES = frozenset(column.name for column in _OWN)


def group_column(name: str) -> Column:
    """The column of a group; one that is called as a column of ours gets a prefix.

    No two groups have one column: a name that is such a column already gets a prefix too.

    >>> [group_column(name).name for name in ("sex", "left", "group_left")]
    ['sex', 'group_left', 'group_group_left']
    """
    plain = name
    while plain not in _NAMES and plain.startswith(PREFIX):
        plain = plain.removeprefix(PREFIX)
    column = f"{PREFIX}{name}" if plain in _NAMES else name
    return Column(column, f"The person's group: {name}.")


def description(
    name: str, study: str, columns: Sequence[Column], progress: Progress
) -> Mapping[str, Any]:
    """`dataset_description.json` of Psych-DS, JSON-LD in schema.org's words."""
    called = " and ".join(task.called for task in TASKS.values())
    return {
        "@context": "https://schema.org",
        "@type": "Dataset",
        "name": name,
        "description": (
            f"Answers to {called}, a row an answer; in description-people everyone who entered, in "
            f"description-log what was done: {progress.answers} answers of "
            f"{progress.entered} people. {progress.excluded} people were excluded; their rows are "
            f"here and say why. {progress.erased} people were erased; {progress.erased_answers} "
            f"answers of theirs are here without anything that leads to them. "
            f"{progress.simulated} answers are simulated. {NOTE}"
        ),
        "identifier": f"sha256:{study}",
        "variableMeasured": [column.property_value() for column in columns],
    }
