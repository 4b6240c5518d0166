"""Pages that are built from studio/, and what brings them where they are missing."""

from __future__ import annotations

from pathlib import Path

#: Where the program lies, if it was not installed.
CLONE = Path(__file__).parents[2]


def cure(task: str) -> str:
    """What brings them: an installed program has no clone to build them in.

    task: of the justfile, in a clone.
    """
    if (CLONE / "just").is_file() and (CLONE / "studio").is_dir():
        return f"build them by   ./just {task}"
    return "this nacreous was installed without them; install a wheel that has them"
