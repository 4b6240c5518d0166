"""A study file: what is shown, what is asked, and of whom."""

from __future__ import annotations

from collections.abc import Iterator
from math import prod
from typing import Annotated, Any, ClassVar, Literal

from pydantic import Field, model_validator

from nacreous.scaling.data.likeness import shape_of
from nacreous.spec.complaint import Contradiction, shown
from nacreous.spec.key import key, quantity, section
from nacreous.spec.specfile import SpecFile
from nacreous.spec.texts import NAME, Name
from nacreous.study.design import demo
from nacreous.study.design.completion import Completion
from nacreous.study.design.display import Display
from nacreous.study.design.entry import Entry
from nacreous.study.design.group import Group
from nacreous.study.design.multilingual import WORDS, Language, Words
from nacreous.study.design.question import Question
from nacreous.study.design.screen import Screen
from nacreous.study.design.sitting import Sitting
from nacreous.study.design.stimulus import Stimulus
from nacreous.study.task.asked import Asked
from nacreous.study.task.pair.catch import Catch
from nacreous.study.task.pair.keys import PairKeys
from nacreous.study.task.pair.pairs import Pairs

#: The most stimuli of a study: 2016 pairs, more than anyone answers at a sitting.
MOST_STIMULI = 64
#: The most combinations of groups that are drawn by lot: half a block of the allocation.
MOST_CELLS = 200
#: The darkest grey on which a ring of the least contrast, 4 %, is a code darker: at a gamma of 2.2
#: that is 1.8 % of the code.
DARKEST_FOR_RINGS = 60


class Design(SpecFile):
    """A study file.

    >>> design = Design.load("paper")
    >>> len(design.labels), design.groups[0].values
    (7, ('shown', 'not-shown'))
    """

    preset_kind: ClassVar[str] = "study"
    #: The task of every question, by its name.
    task: ClassVar[str] = "pair"

    name: Name = key("study", "What the study is called.", allowed=NAME, source="free")
    purpose: Literal["study", "demo"] = key(
        "study",
        "A study, or a demonstration, for which consent and instructions are there already.",
        allowed='"study" or "demo"',
        source="**(ours)**",
    )
    seed: int = quantity(
        1,
        "Seed of every order and every lot: same file and seed, same trials.",
        least=0,
        most=2**63 - 1,
        source="**(ours)**",
    )
    languages: Annotated[tuple[Language, ...], Field(min_length=1, max_length=2)] = key(
        ("en", "ja"),
        "The languages that a participant can choose from, the first as the default.",
        allowed='"en", "ja" or both, each once',
        source="**(ours)**",
        strict=False,
    )
    consent: Words = key(
        ..., "What a participant agrees to before anything else.", allowed=WORDS, source="free"
    )
    instructions: Words = key(
        ..., "What a participant reads before the training.", allowed=WORDS, source="free"
    )
    stimuli: Annotated[tuple[Stimulus, ...], Field(min_length=1, max_length=MOST_STIMULI)] = key(
        ...,
        "What is shown, each headed [[stimuli]].",
        allowed=f"tables, each headed [[stimuli]], of 2 to {MOST_STIMULI} stimuli together",
        source="**(ours)**",
        strict=False,
    )
    questions: Annotated[tuple[Question, ...], Field(min_length=1, max_length=20)] = key(
        ...,
        "What is asked about each pair, each headed [[questions]], one question after the other.",
        allowed="1 to 20 tables, each headed [[questions]]",
        source="paper 2.2",
        strict=False,
    )
    pairs: Pairs = section("Which pairs are shown, and which twice.")
    catches: Annotated[tuple[Catch, ...], Field(max_length=100)] = key(
        (),
        "Pairs whose answer is known, each headed [[catches]].",
        allowed="0 to 100 tables, each headed [[catches]]",
        source="**(ours)**",
        strict=False,
    )
    groups: Annotated[tuple[Group, ...], Field(max_length=12)] = key(
        (),
        "Factors, each headed [[groups]].",
        allowed="0 to 12 tables, each headed [[groups]]",
        source="paper 2.2, a real pearl shown before or not",
        strict=False,
    )
    sitting: Sitting = section("How one participant goes through the study.")
    display: Display = section("How large stimuli are, and on which grey.")
    screen: Screen = section("What is asked of the participant's screen.")
    entry: Entry = section("How people come to the study.")
    completion: Completion = section("What whoever has finished is given.")

    @property
    def labels(self) -> tuple[str, ...]:
        """The labels of all stimuli, in the order of the file."""
        return tuple(label for stimulus in self.stimuli for label in stimulus.labels)

    @property
    def asked(self) -> Asked[PairKeys]:
        """The study as its task sees it."""
        questions = tuple(question.id for question in self.questions)
        keys = PairKeys(self.pairs, self.catches, self.sitting.ties)
        return Asked(self.seed, self.labels, questions, keys)

    @model_validator(mode="before")
    @classmethod
    def _words_of_a_demo(cls, values: Any) -> Any:
        """A demonstration has words of its own where the file gives none."""
        if isinstance(values, dict) and values.get("purpose") == "demo":
            return {"consent": demo.CONSENT, "instructions": demo.INSTRUCTIONS, **values}
        return values

    def contradictions(self) -> Iterator[Contradiction]:
        """Names used twice or nowhere, words that are missing, and numbers that cannot be."""
        if len(set(self.languages)) < len(self.languages):
            yield Contradiction("languages", f"are {shown(self.languages)}; allowed: each once")
        yield from self._twice()
        yield from self._counts()
        yield from self._rings()
        ids = [question.id for question in self.questions]
        for place, catch in enumerate(self.catches):
            yield from catch.unknown(f"catches.{place}", list(self.labels), ids)
        yield from self.consent.missing("consent", self.languages)
        yield from self.instructions.missing("instructions", self.languages)
        for place, question in enumerate(self.questions):
            yield from question.text.missing(f"questions.{place}.text", self.languages)
        for place, group in enumerate(self.groups):
            yield from group.missing(f"groups.{place}", self.languages)
        yield from self.completion.unknown(self.entry.parameters)

    def _twice(self) -> Iterator[Contradiction]:
        named = {
            "stimuli.{}.label": [(i, x) for i, s in enumerate(self.stimuli) for x in s.labels],
            "questions.{}.id": list(enumerate(question.id for question in self.questions)),
            "groups.{}.name": list(enumerate(group.name for group in self.groups)),
        }
        for path, names in named.items():
            first: dict[str, int] = {}
            for place, name in names:
                shape = shape_of(name)
                if shape in first:
                    alike = "as" if (first[shape], name) in names else "which looks like"
                    verdict = f"is {shown(name)}, {alike} {{other}}; allowed: a name of its own"
                    yield Contradiction(path.format(place), verdict, path.format(first[shape]))
                first.setdefault(shape, place)

    def _rings(self) -> Iterator[Contradiction]:
        code = self.display.background_code
        if "contrast" in self.screen.vision and code < DARKEST_FOR_RINGS:
            verdict = (
                f"has contrast while {{other}} is {code}; allowed: from {DARKEST_FOR_RINGS} on, "
                "for on darker greys no code is faint enough"
            )
            yield Contradiction("screen.vision", verdict, "display.background_code")

    def _counts(self) -> Iterator[Contradiction]:
        count = len(self.labels)
        if not 2 <= count <= MOST_STIMULI:
            verdict = f"are {count} together; allowed: 2 to {MOST_STIMULI}"
            yield Contradiction("stimuli", verdict)
        yield from self.pairs.impossible(count)
        cells = prod(len(group.values) for group in self.groups if group.how == "randomised")
        if cells > MOST_CELLS:
            verdict = f"make {cells} combinations by lot; allowed: at most {MOST_CELLS}"
            yield Contradiction("groups", verdict)
