"""The steps of the schema, one file each; Alembic finds them by their `revision`.

A step that has been released is never changed: a new one is added. After an edit of `schema.py`
`tests/study/test_migration.py` fails until a step does the same.
"""
