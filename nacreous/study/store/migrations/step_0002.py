"""What a server needs: who may enter, plans, invitations, accounts and logins."""

import sqlalchemy as sa
from alembic import op

revision = "0002"
down_revision = "0001"

_SERIAL = sa.BigInteger().with_variant(sa.Integer(), "sqlite")
_TIME = sa.String(27)


def upgrade() -> None:
    """Add them; a study that was there before takes invited people only."""
    op.add_column(
        "studies",
        sa.Column("registration", sa.String(8), nullable=False, server_default="invited"),
    )
    op.add_column("sessions", sa.Column("plan", sa.Text))
    _invitations()
    _accounts()


def _invitations() -> None:
    op.create_table(
        "invitations",
        sa.Column("seq", _SERIAL, autoincrement=True, nullable=False),
        sa.Column("study", sa.String(64), nullable=False),
        sa.Column("label", sa.Text, nullable=False),
        sa.Column("token_hash", sa.String(64)),
        sa.Column("made_at", _TIME, nullable=False),
        sa.Column("made_by", sa.Text, nullable=False),
        sa.Column("session", sa.String(36)),
        sa.Column("revoked_at", _TIME),
        sa.PrimaryKeyConstraint("seq", name="pk_invitations"),
        sa.ForeignKeyConstraint(["study"], ["studies.hash"], name="fk_invitations_study"),
        sa.ForeignKeyConstraint(["session"], ["sessions.id"], name="fk_invitations_session"),
        sa.UniqueConstraint("token_hash", name="uq_invitations_token_hash"),
        sqlite_autoincrement=True,
    )
    op.create_index("ix_invitations_study", "invitations", ["study"])
    op.create_index("ix_invitations_session", "invitations", ["session"])


def _accounts() -> None:
    op.create_table(
        "accounts",
        sa.Column("name", sa.String(40), nullable=False),
        sa.Column("password", sa.Text, nullable=False),
        sa.Column("made_at", _TIME, nullable=False),
        sa.PrimaryKeyConstraint("name", name="pk_accounts"),
    )
    op.create_table(
        "logins",
        sa.Column("token_hash", sa.String(64), nullable=False),
        sa.Column("account", sa.String(40), nullable=False),
        sa.Column("made_at", _TIME, nullable=False),
        sa.Column("used_at", _TIME, nullable=False),
        sa.PrimaryKeyConstraint("token_hash", name="pk_logins"),
        sa.ForeignKeyConstraint(["account"], ["accounts.name"], name="fk_logins_account"),
    )
    op.create_index("ix_logins_account", "logins", ["account"])
