"""The tables of a store, as the newest migration leaves them.

Times are text, UTC, ISO 8601 to the microsecond: equal on both databases, exact, and in order when
sorted as text. JSON is text too, in the canonical form of `check.canonical`.
"""

from __future__ import annotations

import sqlalchemy as sa

metadata = sa.MetaData(
    naming_convention={
        "pk": "pk_%(table_name)s",
        "fk": "fk_%(table_name)s_%(column_0_name)s",
        "uq": "uq_%(table_name)s_%(column_0_N_name)s",
        "ix": "ix_%(table_name)s_%(column_0_N_name)s",
    }
)

#: The longest text that is kept of what was answered, in characters.
LONGEST_GIVEN = 5
#: The longest completion code of a person's own, in characters.
LONGEST_CODE = 20
#: Counts up and never gives a number twice, on SQLite too (`sqlite_autoincrement`).
_SERIAL = sa.BigInteger().with_variant(sa.Integer(), "sqlite")


def _serial() -> sa.Column[int]:
    return sa.Column("seq", _SERIAL, primary_key=True, autoincrement=True)


studies = sa.Table(
    "studies",
    metadata,
    sa.Column("hash", sa.String(64), primary_key=True),
    sa.Column("manifest", sa.Text, nullable=False),
    sa.Column("state", sa.String(8), nullable=False),
    sa.Column("next_number", sa.Integer, nullable=False),
    sa.Column("added_at", sa.String(27), nullable=False),
    sa.Column("registration", sa.String(8), nullable=False, server_default="invited"),
)

sessions = sa.Table(
    "sessions",
    metadata,
    sa.Column("id", sa.String(36), primary_key=True),
    sa.Column("study", sa.String(64), sa.ForeignKey("studies.hash"), nullable=False),
    sa.Column("number", sa.Integer, nullable=False),
    sa.Column("token_hash", sa.String(64), unique=True),
    sa.Column("language", sa.String(35)),
    sa.Column("groups", sa.Text),
    sa.Column("consented_at", sa.String(27)),
    sa.Column("started_at", sa.String(27), nullable=False),
    sa.Column("finished_at", sa.String(27)),
    sa.Column("excluded_reason", sa.Text),
    sa.Column("erased_at", sa.String(27)),
    sa.Column("plan", sa.Text),
    sa.Column("slot", sa.Integer),
    sa.Column("parameters", sa.Text),
    sa.Column("completion_code", sa.String(LONGEST_CODE)),
    sa.UniqueConstraint("study", "number"),
)

screens = sa.Table(
    "screens",
    metadata,
    _serial(),
    sa.Column("session", sa.String(36), sa.ForeignKey("sessions.id"), nullable=False, index=True),
    sa.Column("at", sa.String(27), nullable=False),
    sa.Column("content", sa.Text, nullable=False),
    sqlite_autoincrement=True,
)

# An erased person's answers have no session and no trial, but one random name in common, for they
# are still answers of one person; `excluded_reason` is then kept here.
answers = sa.Table(
    "answers",
    metadata,
    _serial(),
    sa.Column("study", sa.String(64), sa.ForeignKey("studies.hash"), nullable=False, index=True),
    sa.Column("session", sa.String(36), sa.ForeignKey("sessions.id")),
    sa.Column("trial", sa.Integer),
    sa.Column("kind", sa.String(8), nullable=False),
    sa.Column("question", sa.Text, nullable=False),
    sa.Column("left", sa.Text, nullable=False),
    sa.Column("right", sa.Text, nullable=False),
    sa.Column("chosen", sa.String(LONGEST_GIVEN), nullable=False),
    sa.Column("response_ms", sa.Double),
    sa.Column("shown_at", sa.String(27)),
    sa.Column("answered_at", sa.String(27)),
    sa.Column("received_at", sa.String(27), nullable=False),
    sa.Column("flags", sa.Text, nullable=False),
    sa.Column("simulated", sa.Boolean, nullable=False),
    sa.Column("digest", sa.String(64)),
    sa.Column("erased_as", sa.String(24)),
    sa.Column("excluded_reason", sa.Text),
    sa.UniqueConstraint("session", "trial"),
    # What progress counts is all in here, so that no answer itself is looked at.
    sa.Index("ix_answers_session_simulated_seq", "session", "simulated", "seq"),
    sqlite_autoincrement=True,
)

audit = sa.Table(
    "audit",
    metadata,
    _serial(),
    sa.Column("at", sa.String(27), nullable=False),
    sa.Column("who", sa.Text, nullable=False),
    sa.Column("what", sa.Text, nullable=False),
    sa.Column("study", sa.String(64), index=True),
    sa.Column("session", sa.String(36), index=True),
    sa.Column("detail", sa.Text, nullable=False),
    sqlite_autoincrement=True,
)

# `session`: who used it. The token is then that person's.
invitations = sa.Table(
    "invitations",
    metadata,
    _serial(),
    sa.Column("study", sa.String(64), sa.ForeignKey("studies.hash"), nullable=False, index=True),
    sa.Column("label", sa.Text, nullable=False),
    sa.Column("token_hash", sa.String(64), unique=True),
    sa.Column("made_at", sa.String(27), nullable=False),
    sa.Column("made_by", sa.Text, nullable=False),
    sa.Column("session", sa.String(36), sa.ForeignKey("sessions.id"), index=True),
    sa.Column("revoked_at", sa.String(27)),
    sqlite_autoincrement=True,
)

accounts = sa.Table(
    "accounts",
    metadata,
    sa.Column("name", sa.String(40), primary_key=True),
    sa.Column("password", sa.Text, nullable=False),
    sa.Column("made_at", sa.String(27), nullable=False),
)

logins = sa.Table(
    "logins",
    metadata,
    sa.Column("token_hash", sa.String(64), primary_key=True),
    sa.Column("account", sa.String(40), sa.ForeignKey("accounts.name"), nullable=False, index=True),
    sa.Column("made_at", sa.String(27), nullable=False),
    sa.Column("used_at", sa.String(27), nullable=False),
)
