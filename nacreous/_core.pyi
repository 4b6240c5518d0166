"""The compiled rooms, as mypy sees them; `just check` compares this file with the built module."""
