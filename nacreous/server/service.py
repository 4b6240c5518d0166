"""What all routes of one server share."""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Collection
from typing import Any, Concatenate, ParamSpec, TypeVar, cast
from urllib.parse import urlsplit

from starlette.concurrency import run_in_threadpool
from starlette.requests import Request
from starlette.responses import JSONResponse
from starlette.types import Scope

from nacreous.printable import printable
from nacreous.server.facts import Facts
from nacreous.server.hosts import Hosts
from nacreous.server.origin import origin_of
from nacreous.server.person import People
from nacreous.server.pictures import Pictures
from nacreous.server.rates import Rates, address_of
from nacreous.server.refusal import Refusal
from nacreous.server.responses import StudyTold
from nacreous.server.result_cache import ResultCache
from nacreous.server.sessions import Sessions
from nacreous.server.worker import Worker
from nacreous.study.running import Running
from nacreous.study.store import Store, StoreError, tokens

T = TypeVar("T")
P = ParamSpec("P")


class Service:
    """A study that runs, and what the server remembers beside it.

    url: where people reach the server, if it is not where it listens, as behind a proxy. hosts:
    names that are the server's too (`nacreous.server.hosts`). worker: what works out in a process
    of its own what takes seconds.
    """

    def __init__(
        self,
        running: Running,
        url: str | None = None,
        worker: Worker | None = None,
        hosts: Collection[str] = (),
    ) -> None:
        self.running = running
        self.rates = Rates()
        self.sessions = Sessions(running)
        self.results = ResultCache()
        self._worker = worker
        self.people = People(running)
        self.pictures = Pictures(running.frozen)
        self._facts = Facts(running.frozen.design)
        self.url = url.rstrip("/") if url else None
        self.origin = origin_of(url) if url else None
        self.hosts = Hosts([*hosts, *([urlsplit(url).netloc] if url else [])])

    @property
    def store(self) -> Store:
        """The study's store."""
        return self.running.store

    def told(self) -> StudyTold:
        """The study to somebody who has not entered, with a token of their own."""
        study = self.running.study
        state = self.store.studies()[study]
        return self._facts.told(state, self.store.registration(study), tokens.draw())

    async def works_out(
        self, work: Callable[Concatenate[Running, P], T], *args: P.args, **kwargs: P.kwargs
    ) -> T:
        """What takes seconds, `work(running, ...)`: in the worker, or on a thread without one."""
        if self._worker is not None:
            return await self._worker(work, *args, **kwargs)
        return await run_in_threadpool(work, self.running, *args, **kwargs)

    def is_https(self, scope: Scope) -> bool:
        """Whether people's browsers speak HTTPS, with us or with the proxy before us."""
        return (self.origin or f"{scope['scheme']}:").startswith("https:")

    async def refuse(self, scope: Scope, refusal: Refusal) -> JSONResponse:
        """Tell a refusal, and note it in the audit log; too many are neither told nor noted.

        Nothing is noted of where a request came from, for that would lead to a participant.
        """
        state = scope["state"]
        if 400 <= refusal.status < 500 and refusal.kind != "missing":
            who = state.get("session") or state.get("name") or address(scope)
            if not self.rates.takes("refusals", who):
                refusal = self.rates.busy("refusals", who)
            elif not refusal.logged:
                await run_in_threadpool(self._note, scope, refusal)
        content = {"problem": refusal.problem, "kind": refusal.kind}
        return JSONResponse(content, refusal.status, dict(refusal.headers))

    def _note(self, scope: Scope, refusal: Refusal) -> None:
        state = scope["state"]
        session = state.get("session")
        who = state.get("name") or ("participant" if session else "somebody")
        detail: dict[str, Any] = {"status": refusal.status, "problem": refusal.problem}
        detail["asked"] = printable(f"{scope['method'][:20]} {scope['path'][:200]}")
        # Whom the store refuses hears why, even if nothing more can be written.
        with contextlib.suppress(StoreError):
            self.store.audit(who, "refused", self.running.study, session, **detail)


def address(scope: Scope) -> str:
    """The address that a request came from."""
    client = scope.get("client")
    return address_of(client[0] if client else None)


def service_of(request: Request) -> Service:
    """The service behind a request."""
    return cast(Service, request.app.state.service)
