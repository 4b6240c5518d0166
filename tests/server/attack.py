"""That an attack changes nothing, and is told and logged."""

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import httpx

from nacreous.server.service import Service


def state(service: Service) -> tuple[Any, ...]:
    """All that an attack could change."""
    store, study = service.store, service.running.study
    return (
        store.progress(study),
        store.answers(study),
        store.registration(study),
        store.invitations(study),
        store.accounts(),
        [event for event in store.events() if event.what not in ("refused", "answer refused")],
    )


def refusals(service: Service) -> int:
    return sum(event.what in ("refused", "answer refused") for event in service.store.events())


@contextmanager
def unchanged(service: Service, logged: int) -> Iterator[None]:
    """Nothing changes, and so many refusals are in the audit log."""
    before, lines = state(service), refusals(service)
    yield
    assert state(service) == before
    assert refusals(service) - lines == logged


def told(response: httpx.Response) -> tuple[int, str]:
    problem = response.json()
    assert set(problem) == {"problem", "kind"}
    assert "\n" not in problem["problem"]
    return response.status_code, problem["kind"]
