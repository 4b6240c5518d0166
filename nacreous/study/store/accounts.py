"""Accounts of experimenters, and their logins."""

from __future__ import annotations

import re
from datetime import datetime, timedelta

import sqlalchemy as sa

from nacreous.problem import InputError
from nacreous.study.store import check, journal, tokens
from nacreous.study.store.refusal import UnknownToken
from nacreous.study.store.schema import accounts, logins

#: A login ends after this long, and this long after it was last used.
LONGEST = timedelta(hours=12)
LONGEST_UNUSED = timedelta(hours=2)
#: A use is written down only this long after the last one, for most requests change nothing else.
_TOUCH = timedelta(minutes=1)


def name_of(name: object) -> str:
    """The name of an account, checked.

    >>> name_of("m.mikimoto")
    'm.mikimoto'
    """
    if not isinstance(name, str) or not re.fullmatch("[a-z0-9_.-]{1,40}", name):
        raise InputError(f"name is {ascii(name)[:60]}; allowed: 1 to 40 of a to z, 0 to 9, - _ .")
    return name


def set_password(connection: sa.Connection, at: str, name: str, password: str, who: str) -> None:
    """Make an account, or give it another password, which ends its logins; `password`: its hash."""
    connection.execute(sa.delete(logins).where(logins.c.account == name))
    changed = connection.execute(
        sa.update(accounts)
        .where(accounts.c.name == name)
        .values(password=password)
        .returning(accounts.c.name)
    ).scalar_one_or_none()
    if changed is None:
        connection.execute(sa.insert(accounts).values(name=name, password=password, made_at=at))
    what = "account made" if changed is None else "password changed"
    journal.note(connection, at, who, what, None, None, name=name)


def remove(connection: sa.Connection, at: str, name: str, who: str) -> None:
    """Remove an account and end its logins."""
    connection.execute(sa.delete(logins).where(logins.c.account == name))
    gone = connection.execute(
        sa.delete(accounts).where(accounts.c.name == name).returning(accounts.c.name)
    ).scalar_one_or_none()
    if gone is None:
        raise InputError(f"there is no account {ascii(name)[:60]}; wanted: one that there is")
    journal.note(connection, at, who, "account removed", None, None, name=name)


def names(connection: sa.Connection) -> list[str]:
    """All accounts, sorted."""
    return list(connection.scalars(sa.select(accounts.c.name).order_by(accounts.c.name)))


def kept_password(connection: sa.Connection, name: object) -> str | None:
    """The hash of an account's password; None where there is no such account."""
    if not isinstance(name, str) or "\0" in name or not name.isascii():
        return None
    query = sa.select(accounts.c.password).where(accounts.c.name == name)
    return connection.execute(query).scalar_one_or_none()


def log_in(connection: sa.Connection, now: datetime, name: str, kept: str, token: str) -> None:
    """Keep a login whose password was compared with `kept`; those that are over are removed."""
    if kept_password(connection, name) != kept:
        raise wrong()  # it was changed, or the account removed, in the meantime
    at = check.written("clock", now)
    over = logins.c.made_at < check.written("clock", now - LONGEST)
    unused = logins.c.used_at < check.written("clock", now - LONGEST_UNUSED)
    connection.execute(sa.delete(logins).where(over | unused))
    connection.execute(
        sa.insert(logins).values(
            token_hash=tokens.hash_of(token), account=name, made_at=at, used_at=at
        )
    )
    journal.note(connection, at, name, "logged in", None, None)


def login(connection: sa.Connection, now: datetime, hashed: str) -> tuple[str, bool]:
    """Whose login this is, and whether it is time to write down that it is in use.

    A clock that was set far back ends a login as one set forward does; or it might last for years.
    """
    row = connection.execute(sa.select(logins).where(logins.c.token_hash == hashed)).one_or_none()
    if row is None:
        raise tokens.unknown()
    made, used = (abs(now - datetime.fromisoformat(at)) for at in (row.made_at, row.used_at))
    if made > LONGEST or used > LONGEST_UNUSED:
        raise UnknownToken("the login is over; wanted: a new one")
    return row.account, used > _TOUCH


def touch(connection: sa.Connection, at: str, hashed: str) -> None:
    """Write down that a login is in use."""
    connection.execute(sa.update(logins).where(logins.c.token_hash == hashed).values(used_at=at))


def log_out(connection: sa.Connection, at: str, hashed: str) -> None:
    """End a login; nothing happens where it is over already."""
    name = connection.execute(
        sa.delete(logins).where(logins.c.token_hash == hashed).returning(logins.c.account)
    ).scalar_one_or_none()
    if name is not None:
        journal.note(connection, at, name, "logged out", None, None)


def wrong() -> UnknownToken:
    """For a login that fails, whichever of the two it was."""
    return UnknownToken("name or password is wrong; wanted: those of an account")
