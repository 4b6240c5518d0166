"""The first tables: studies, sessions, screens, answers, audit."""

import sqlalchemy as sa
from alembic import op

revision = "0001"
down_revision = None

_SERIAL = sa.BigInteger().with_variant(sa.Integer(), "sqlite")
_TIME = sa.String(27)


def _serial(table: str) -> tuple[sa.Column[int], sa.PrimaryKeyConstraint]:
    return (
        sa.Column("seq", _SERIAL, autoincrement=True, nullable=False),
        sa.PrimaryKeyConstraint("seq", name=f"pk_{table}"),
    )


def upgrade() -> None:
    """Make them."""
    _studies_and_sessions()
    _screens_and_audit()
    _answers()


def _studies_and_sessions() -> None:
    op.create_table(
        "studies",
        sa.Column("hash", sa.String(64), nullable=False),
        sa.Column("manifest", sa.Text, nullable=False),
        sa.Column("state", sa.String(8), nullable=False),
        sa.Column("next_number", sa.Integer, nullable=False),
        sa.Column("added_at", _TIME, nullable=False),
        sa.PrimaryKeyConstraint("hash", name="pk_studies"),
    )
    op.create_table(
        "sessions",
        sa.Column("id", sa.String(36), nullable=False),
        sa.Column("study", sa.String(64), nullable=False),
        sa.Column("number", sa.Integer, nullable=False),
        sa.Column("token_hash", sa.String(64)),
        sa.Column("language", sa.String(35)),
        sa.Column("groups", sa.Text),
        sa.Column("consented_at", _TIME),
        sa.Column("started_at", _TIME, nullable=False),
        sa.Column("finished_at", _TIME),
        sa.Column("excluded_reason", sa.Text),
        sa.Column("erased_at", _TIME),
        sa.PrimaryKeyConstraint("id", name="pk_sessions"),
        sa.ForeignKeyConstraint(["study"], ["studies.hash"], name="fk_sessions_study"),
        sa.UniqueConstraint("token_hash", name="uq_sessions_token_hash"),
        sa.UniqueConstraint("study", "number", name="uq_sessions_study_number"),
    )


def _screens_and_audit() -> None:
    op.create_table(
        "screens",
        *_serial("screens"),
        sa.Column("session", sa.String(36), nullable=False),
        sa.Column("at", _TIME, nullable=False),
        sa.Column("content", sa.Text, nullable=False),
        sa.ForeignKeyConstraint(["session"], ["sessions.id"], name="fk_screens_session"),
        sqlite_autoincrement=True,
    )
    op.create_index("ix_screens_session", "screens", ["session"])
    op.create_table(
        "audit",
        *_serial("audit"),
        sa.Column("at", _TIME, nullable=False),
        sa.Column("who", sa.Text, nullable=False),
        sa.Column("what", sa.Text, nullable=False),
        sa.Column("study", sa.String(64)),
        sa.Column("session", sa.String(36)),
        sa.Column("detail", sa.Text, nullable=False),
        sqlite_autoincrement=True,
    )
    op.create_index("ix_audit_study", "audit", ["study"])
    op.create_index("ix_audit_session", "audit", ["session"])


def _answers() -> None:
    op.create_table(
        "answers",
        *_serial("answers"),
        sa.Column("study", sa.String(64), nullable=False),
        sa.Column("session", sa.String(36)),
        sa.Column("trial", sa.Integer),
        sa.Column("kind", sa.String(8), nullable=False),
        sa.Column("question", sa.Text, nullable=False),
        sa.Column("left", sa.Text, nullable=False),
        sa.Column("right", sa.Text, nullable=False),
        sa.Column("chosen", sa.String(5), nullable=False),
        sa.Column("response_ms", sa.Double),
        sa.Column("shown_at", _TIME),
        sa.Column("answered_at", _TIME),
        sa.Column("received_at", _TIME, nullable=False),
        sa.Column("flags", sa.Text, nullable=False),
        sa.Column("simulated", sa.Boolean, nullable=False),
        sa.Column("digest", sa.String(64)),
        sa.Column("erased_as", sa.String(24)),
        sa.Column("excluded_reason", sa.Text),
        sa.ForeignKeyConstraint(["study"], ["studies.hash"], name="fk_answers_study"),
        sa.ForeignKeyConstraint(["session"], ["sessions.id"], name="fk_answers_session"),
        sa.UniqueConstraint("session", "trial", name="uq_answers_session_trial"),
        sqlite_autoincrement=True,
    )
    op.create_index("ix_answers_study", "answers", ["study"])
