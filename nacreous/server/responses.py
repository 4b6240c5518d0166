"""The bodies of responses."""

from __future__ import annotations

from datetime import datetime
from typing import Literal

from pydantic import BaseModel, JsonValue
from typing_extensions import TypedDict  # pydantic reads typing's own from Python 3.12 on

from nacreous.scaling.fit.unit import Unit
from nacreous.study.design.multilingual import Language
from nacreous.study.design.screen import Screen
from nacreous.study.design.sitting import Sitting
from nacreous.study.running.screening import ScreenFlag


class Words(TypedDict, total=False):
    """Words in those languages of the study in which there are some."""

    en: str
    ja: str


class QuestionTold(BaseModel):
    """A question as people read it."""

    id: str
    text: Words


class ChoiceTold(BaseModel):
    """A value of a group as people read it."""

    value: str
    text: Words


class GroupTold(BaseModel):
    """A factor that is asked of the participant."""

    name: str
    question: Words
    choices: list[ChoiceTold]


class StudyTold(BaseModel):
    """A study to somebody who has not entered. `token` is fresh: it becomes theirs by entering.

    parameters: of the page's address, which are kept with whoever comes by it.
    """

    name: str
    purpose: Literal["study", "demo"]
    state: Literal["open", "paused", "closed"]
    registration: Literal["open", "invited"]
    languages: list[Language]
    consent: Words
    instructions: Words
    questions: list[QuestionTold]
    groups: list[GroupTold]
    parameters: list[str]
    sitting: Sitting
    background_code: int
    screen: Screen
    token: str


class TrialTold(BaseModel):
    """A question about two pictures; never what is on them or why they are shown."""

    trial: int
    question: str
    left: str
    right: str
    training: bool
    break_before: bool


class PictureTold(BaseModel):
    """How large a picture is, in its own pixels and on the screen."""

    width_px: int
    height_px: int
    width_mm: float


class EndingTold(BaseModel):
    """What somebody is given who has finished: a completion code, and where to go back to."""

    code: str | None
    return_url: str | None


class SittingTold(BaseModel):
    """Where one participant is. Trials and pictures are there once they have consented.

    sitting: its name, which no other sitting gets, whatever becomes of token or number.
    """

    sitting: str
    number: int
    language: Language
    consented: bool
    screened: bool
    screen_flags: list[str]
    refused: bool
    finished: bool
    ending: EndingTold | None
    answered: int
    groups_notes: list[Words]
    trials: list[TrialTold]
    pictures: dict[str, PictureTold]


class ScreenTold(BaseModel):
    """What a screen check was found to be."""

    flags: list[ScreenFlag]
    refused: bool


class ReceiptTold(BaseModel):
    """That an answer is on the disk; `again`: it was already."""

    trial: int
    received_at: datetime
    again: bool


class WhoTold(BaseModel):
    """Who is logged in, and what each change must carry in X-CSRF-Token."""

    name: str
    csrf: str


class FlagTold(BaseModel):
    """Something about a person's answers that an experimenter should know."""

    kind: str
    detail: str


class PersonTold(BaseModel):
    """How far one participant is, practice aside. Of an erased one `trials` is 0."""

    number: int
    language: Language | None
    groups: dict[str, str]
    answers: int
    trials: int
    started_at: datetime
    last_at: datetime | None
    finished: bool
    seconds: float | None
    excluded: str | None
    erased: bool
    simulated: bool
    screen_flags: list[str]
    flags: list[FlagTold]


class ProgressTold(BaseModel):
    """How far the study is. `trials` is what a full sitting has.

    flags_known: whether anybody's flags are worked out; before, nobody has any. They may be of a
    moment ago.
    """

    name: str
    study: str
    purpose: Literal["study", "demo"]
    state: Literal["open", "paused", "closed"]
    registration: Literal["open", "invited"]
    entered: int
    consented: int
    finished: int
    excluded: int
    erased: int
    answers: int
    simulated: int
    median_s: float | None
    trials: int
    flags_known: bool
    people: list[PersonTold]


class StimulusTold(BaseModel):
    """A stimulus on the scale, with its interval; null: an end that the answers do not set."""

    label: str
    picture: str
    value: float
    low: float | None
    high: float | None


class ScaleTold(BaseModel):
    """The scale so far."""

    question: str
    text: Words
    simulated: bool
    stimuli: list[StimulusTold]
    answers: int
    people: int
    unit: Unit
    level: float
    verdict: Literal["describes", "misfits", "untested"]
    misfit: tuple[str, str] | None
    people_differ: bool
    people_told: bool


class TooFew(BaseModel):
    """Why there is no scale yet."""

    problem: str


class InvitationTold(BaseModel):
    """An invitation; `number` is of the participant who used it."""

    id: int
    label: str
    made_at: datetime
    made_by: str
    number: int | None
    revoked_at: datetime | None


class LinksTold(BaseModel):
    """New invitations, each a link that is told only once."""

    links: list[str]


class EventTold(BaseModel):
    """A line of the audit log; `number` is of the participant whom it is about."""

    at: datetime
    who: str
    what: str
    number: int | None
    detail: dict[str, JsonValue]
