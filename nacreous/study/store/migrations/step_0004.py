"""An index by which a person's answers are counted without looking at them."""

from alembic import op

revision = "0004"
down_revision = "0003"


def upgrade() -> None:
    """Add it."""
    columns = ["session", "simulated", "seq"]
    op.create_index("ix_answers_session_simulated_seq", "answers", columns)
