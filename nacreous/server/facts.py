"""A frozen study as participants are told of it."""

from __future__ import annotations

from typing import Any

from nacreous.server.responses import (
    ChoiceTold,
    GroupTold,
    QuestionTold,
    StudyTold,
    Words,
)
from nacreous.study.design import Design


class Facts:
    """All that is told and never changes, worked out once."""

    def __init__(self, design: Design) -> None:
        self._kept: dict[str, Any] = {
            "name": design.name,
            "purpose": design.purpose,
            "languages": list(design.languages),
            "consent": words(design.consent),
            "instructions": words(design.instructions),
            "questions": [
                QuestionTold(id=question.id, text=words(question.text))
                for question in design.questions
            ],
            "groups": _groups(design),
            "parameters": list(design.entry.parameters),
            "sitting": design.sitting,
            "background_code": design.display.background_code,
            "screen": design.screen,
        }

    def told(self, state: str, registration: str, token: str) -> StudyTold:
        """The study now, with a token for whoever asks."""
        return StudyTold.model_validate(
            {**self._kept, "state": state, "registration": registration, "token": token}
        )


def words(section: Any) -> Words:
    """A table of words, in those languages in which there are some."""
    told: Words = section.model_dump(exclude_none=True)
    return told


def _groups(design: Design) -> list[GroupTold]:
    """Those groups whose value is asked of the participant."""
    asked = []
    for group in design.groups:
        if group.how != "recorded" or group.question is None:
            continue
        plain = [dict.fromkeys(design.languages, value) for value in group.values]
        texts = plain if group.choices is None else [words(choice) for choice in group.choices]
        choices = [
            ChoiceTold(value=value, text=text)
            for value, text in zip(group.values, texts, strict=True)
        ]
        asked.append(GroupTold(name=group.name, question=words(group.question), choices=choices))
    return asked
