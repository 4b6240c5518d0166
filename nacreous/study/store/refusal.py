"""Why a store refuses, where it matters to whoever asked: each kind is a class of its own."""

from __future__ import annotations

from nacreous.problem import InputError


class UnknownToken(InputError):
    """A token, or a name with its password, that nobody holds.

    >>> raise UnknownToken("token is unknown; wanted: one that was given out and not revoked")
    Traceback (most recent call last):
    nacreous.study.store.refusal.UnknownToken: token is unknown; wanted: one that was given out ...
    """


class Conflict(InputError):
    """Another answer is stored under the same key. What was refused is in the audit log.

    >>> issubclass(Conflict, InputError)
    True
    """


class OutOfTurn(InputError):
    """An answer to a trial whose turn has not come yet, or an end before the last answer.

    >>> issubclass(OutOfTurn, InputError)
    True
    """


class NotAllowed(InputError):
    """Something that this person may not do, at least now.

    The study is paused, closed or for invited people only; consent is missing or was withdrawn; the
    screen was refused; the person was erased.

    >>> issubclass(NotAllowed, InputError)
    True
    """
