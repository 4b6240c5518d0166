"""What somebody says who enters, checked against the study."""

from __future__ import annotations

from collections.abc import Mapping

from nacreous.problem import InputError
from nacreous.study.design import Design

__all__ = ["check_groups", "check_language", "check_parameters"]


def check_language(design: Design, language: object) -> None:
    """One of the study's."""
    known = design.languages
    if language not in known:
        raise InputError(f"language is {ascii(language)[:40]}; allowed: {', '.join(known)}")


def check_groups(design: Design, recorded: Mapping[str, str]) -> None:
    """A value of every group that is asked for, and of no other."""
    asked = {group.name: group.values for group in design.groups if group.how == "recorded"}
    for name in recorded:
        if name not in asked:
            named = ", ".join(asked) or "none"
            raise InputError(f"group {ascii(name)[:60]} is not asked for; allowed: {named}")
    for name, values in asked.items():
        if recorded.get(name) not in values:
            said = ascii(recorded[name])[:60] if name in recorded else "missing"
            raise InputError(f"group {name} is {said}; allowed: {', '.join(values)}")


def check_parameters(design: Design, given: Mapping[str, str]) -> None:
    """Such as the study keeps; their values are the store's to check."""
    for name in given:
        if name not in design.entry.parameters:
            named = ", ".join(design.entry.parameters) or "none"
            raise InputError(f"parameter {ascii(name)[:60]} is not kept; allowed: {named}")
