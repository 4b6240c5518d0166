"""Programs of experiments and surveys: by which columns their files are known, and what each is."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from unicodedata import normalize


@dataclass(frozen=True)
class Program:
    """A program: by which columns its files are known, and which of them have a role."""

    name: str
    marks: frozenset[str]
    columns: Mapping[str, str]


JSPSYCH = Program(
    "jsPsych",
    frozenset({"trial_type", "trial_index", "time_elapsed"}),
    {"chosen": "response", "response_ms": "rt", "trial": "trial_index"},
)
#: Before version 6.3 buttons and keys had columns of their own.
JSPSYCH_BUTTONS, JSPSYCH_KEYS = (
    Program(JSPSYCH.name, JSPSYCH.marks | {own}, {**JSPSYCH.columns, "chosen": own})
    for own in ("button_pressed", "key_press")
)
LABJS = Program(
    "lab.js",
    frozenset({"sender", "sender_type", "sender_id"}),
    {"chosen": "response", "response_ms": "duration"},
)
GORILLA = Program(
    "Gorilla",
    frozenset({"Event Index", "Participant Private ID"}),
    {
        "person": "Participant Private ID",  # one a session; the public one may be any word
        "chosen": "Response",
        "response_ms": "Reaction Time",
        "trial": "Event Index",
    },
)
SOSCI = Program("SoSci Survey", frozenset({"CASE", "QUESTNNR"}), {"person": "CASE"})
LIMESURVEY = Program("LimeSurvey", frozenset({"id", "submitdate", "lastpage"}), {"person": "id"})
#: A row an event of a person's, or an instance of what is asked again.
REDCAP, REDCAP_REPEATED = (
    Program("REDCap", frozenset({"record_id", own}), {"person": "record_id"})
    for own in ("redcap_event_name", "redcap_repeat_instance")
)
PROGRAMS = (
    JSPSYCH_BUTTONS,
    JSPSYCH_KEYS,
    JSPSYCH,
    LABJS,
    GORILLA,
    SOSCI,
    LIMESURVEY,
    REDCAP,
    REDCAP_REPEATED,
)

#: Words for somebody who answers, each also with id, number and the like behind it.
_SOMEBODY = (
    *("participant", "participants", "subject", "subj", "observer", "person", "respondent"),
    *("judge", "rater", "assessor", "panelist", "panellist", "user", "worker", "prolific", "ppt"),
    *("proband", "probandin", "versuchsperson", "vpn", "teilnehmer", "teilnehmerin"),
    *("sujet", "sujeto", "参加者", "実験参加者", "被験者", "回答者", "観察者", "評価者"),
)
_BEHIND = ("", "id", "ids", "nr", "no", "num", "number", "code", "番号")
_PEOPLE = frozenset(
    {f"{word}{behind}" for word in _SOMEBODY for behind in _BEHIND}
    | {"responseid", "prolificpid", "runid", "participantprivateid", "participantpublicid"}
    | {"expsubjectid"}
)
#: What may say who answered, or something else: only a person can tell.
_PERHAPS = frozenset({"id", "name", "email", "code", "case", "session", "sessionid", "sub", "名前"})

#: What only one person has, wherever it stands.
_ADDRESSES = frozenset(
    {"email", "emailaddress", "mail", "mailaddress", "username", "recordid", "studentid"}
    | {"name", "names", "yourname", "fullname", "id", "お名前", "名前", "氏名", "ニックネーム"}
    | {"courriel", "adressemail", "メールアドレス", "ユーザー名", "学籍番号"}
)

#: Words for how long an answer took, in an unknown unit.
_TIMES = frozenset({"rt", "responsetime", "reactiontime", "duration", "latency"})


def program_of(columns: Iterable[str]) -> Program | None:
    """The program whose columns these are."""
    names = set(columns)
    return next((each for each in PROGRAMS if each.marks <= names), None)


def names_people(column: str) -> bool:
    """Whether a column of that name says who answered, in the words of other programs.

    >>> [names_people(name) for name in ("Participant ID", "subject_nr", "Vpn", "id")]
    [True, True, True, False]
    """
    return _bare(column) in _PEOPLE


def may_name_people(column: str) -> bool:
    """Whether a column of that name may say who answered; one has to ask.

    >>> may_name_people("ID")
    True
    """
    return _bare(column) in _PERHAPS


def names_one_each(column: str) -> bool:
    """Whether a column of that name has a value of its own for each person, as an address is.

    >>> names_one_each("Email Address"), names_one_each("session")
    (True, False)
    """
    return _bare(column) in _ADDRESSES


def may_be_response_time(column: str) -> bool:
    """Whether a column of that name may say how long answers took; its unit one has to ask.

    >>> may_be_response_time("Reaction Time"), may_be_response_time("key_resp.rt")
    (True, True)
    """
    return bool(_TIMES & {_bare(column), _bare(column.rsplit(".", 1)[-1])})


def is_response_id(column: str) -> bool:
    """Whether this is Qualtrics's own number of a response."""
    return _bare(column) == "responseid"


def _bare(column: str) -> str:
    """A name without what parts its words, in small letters of one width."""
    return re.sub(r"[\s_.\-]+", "", normalize("NFKC", column)).casefold()
