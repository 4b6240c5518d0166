"""The tasks that there are."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Annotated, Any, TypeAlias

from pydantic import GetCoreSchemaHandler
from pydantic_core import CoreSchema, core_schema

from nacreous.study.task.column import Column
from nacreous.study.task.pair.pair import PAIR
from nacreous.study.task.response import Given
from nacreous.study.task.task import Task

__all__ = ["TASKS", "Answerable", "columns_of_tasks", "task_of"]

#: Every task by its name. A new one is a folder beside pair/ and its name in this line.
TASKS: Mapping[str, Task[Any]] = {task.name: task for task in (PAIR,)}


def task_of(row: Mapping[str, Any]) -> Task[Any]:
    """The task of a row of the store; one that names none is a pair, as all were at first."""
    return TASKS[row.get("task", PAIR.name)]


def columns_of_tasks() -> list[Column]:
    """The columns of an export that hold what was shown and answered, each once."""
    every = (column for task in TASKS.values() for column in task.columns)
    return list({column.name: column for column in every}.values())


class _AnyTask:
    """What any of the tasks lets people answer, for a model of pydantic."""

    @classmethod
    def __get_pydantic_core_schema__(cls, _: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        return core_schema.union_schema(
            [handler.generate_schema(task.given) for task in TASKS.values()]
        )


#: What may be answered to a trial, whichever task it is of.
Answerable: TypeAlias = Annotated[Given, _AnyTask]
