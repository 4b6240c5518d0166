"""Listening: a socket first, so that who is told the address can come at once; then uvicorn."""

from __future__ import annotations

import errno
import signal
import socket
import sys
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from typing import TYPE_CHECKING, Any
from urllib.parse import urlsplit

import uvicorn

from nacreous.problem import InputError

if TYPE_CHECKING:
    from fastapi import FastAPI
    from starlette.types import ASGIApp

_BACKLOG = 2048
#: Signals that end a server in the ordinary way.
_STOPPING = (signal.SIGINT, signal.SIGTERM)
#: Where a proxy may be that is believed: at "localhost", by either protocol.
_THIS_MACHINE = "127.0.0.1,::1"
#: Every address of this machine.
_ALL = ("0.0.0.0", "::")  # noqa: S104 (what is asked for, not what we listen at)
#: Open connections at once, where the system lets a process have so many.
_MOST_OPEN = 16_384


def check_url(url: str) -> str:
    """The address at which people reach the server, checked: a scheme and a host, no path.

    >>> check_url("https://pearls.example/")
    'https://pearls.example'
    """
    from nacreous.server.hosts import host_of  # with the store, which the viewer does without

    try:
        parts = urlsplit(url)
        good = parts.scheme in ("http", "https") and bool(parts.hostname)
        good = (
            good
            and parts.port != 0
            and "@" not in parts.netloc
            and parts.geturl() == f"{parts.scheme}{url[len(parts.scheme) :]}"
        )
        host_of(parts.netloc)
    except (InputError, ValueError):
        good = False
    if not good or parts.path not in ("", "/") or parts.query or parts.fragment:
        raise InputError(f"url is {ascii(url)[:80]}; allowed: http://HOST or https://HOST")
    return f"{parts.scheme}://{parts.netloc}".lower()


def listen(host: str, port: int) -> socket.socket:
    """A socket that listens; port 0 takes any that is free.

    Raises `InputError` for a host that is not this machine's and a port that is in use, `OSError`
    where the system refuses.
    """
    if not 0 <= port <= 65_535:
        raise InputError(f"port is {port}; allowed: 0 to 65535")
    try:
        family, kind, protocol, _, place = socket.getaddrinfo(
            host, port, type=socket.SOCK_STREAM, flags=socket.AI_PASSIVE
        )[0]
    except (socket.gaierror, UnicodeError):
        raise InputError(f"host is {ascii(host)[:80]}; wanted: one of this machine's") from None
    made = socket.socket(family, kind, protocol)
    try:
        if sys.platform != "win32":
            made.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        made.bind(place)
        made.listen(_BACKLOG)
    except OSError as problem:
        made.close()
        if problem.errno == errno.EADDRINUSE:
            raise InputError(f"port is {port}, which is in use; wanted: another one") from None
        if problem.errno == errno.EADDRNOTAVAIL:
            raise InputError(f"host is {host}; wanted: one of this machine's") from None
        raise
    return made


def named(host: str) -> list[str]:
    """What the place where we listen is called in `address_of`; "" stands for all addresses.

    >>> named("lab-pc.local"), named("")
    (['lab-pc.local'], ['0.0.0.0', '::'])
    """
    return [host] if host else list(_ALL)


def address_of(listening: socket.socket) -> str:
    """Where it listens, as a URL.

    >>> with listen("127.0.0.1", 0) as listening:
    ...     address_of(listening).rpartition(":")[0]
    'http://127.0.0.1'
    """
    host, port = listening.getsockname()[:2]
    return f"http://[{host}]:{port}" if ":" in host else f"http://{host}:{port}"


def server_of(app: ASGIApp) -> uvicorn.Server:
    """uvicorn, as a study and the viewer need it; `run(sockets=[...])` serves."""
    config = uvicorn.Config(
        app,
        ws="none",
        lifespan="off",
        log_level="warning",
        access_log=False,
        server_header=False,
        proxy_headers=True,
        forwarded_allow_ips=_THIS_MACHINE,
        timeout_keep_alive=60,
        timeout_graceful_shutdown=10,
        **_fast(),
    )
    return uvicorn.Server(config)


@contextmanager
def until_stopped() -> Iterator[None]:
    """SIGINT and SIGTERM are the ordinary ends of what goes on in here."""
    before = signal.signal(signal.SIGTERM, signal.default_int_handler)
    # uvicorn, which waits for both too, gives a signal on when all requests are answered.
    with suppress(KeyboardInterrupt):
        yield
    signal.signal(signal.SIGTERM, before)


def serve(app: FastAPI, listening: socket.socket) -> None:
    """Serve until stopped; requests that came before are answered."""
    server = server_of(app)
    with ended_by_signals(server):
        _open_many()
        app.openapi()  # made now, for it takes a tenth of a second
        server.run(sockets=[listening])


@contextmanager
def ended_by_signals(server: uvicorn.Server) -> Iterator[None]:
    """SIGINT and SIGTERM end the server, from before it runs.

    As exceptions, which they are till then, they could meet code that swallows them while the
    server is set up; nobody would hear of them again.
    """
    before = {one: signal.signal(one, server.handle_exit) for one in _STOPPING}
    try:
        yield
    finally:
        for one, handler in before.items():
            signal.signal(one, handler)


def _fast() -> dict[str, Any]:
    """The fast loop and the parser, which there are not for Windows."""
    if sys.platform == "win32":
        return {}
    from nacreous.server.connection import Connection

    return {"loop": "uvloop", "http": Connection}


def _open_many() -> None:
    """Let as many people be connected as the system allows; some allow 256 unless asked."""
    if sys.platform == "win32":
        return
    import resource

    soft, hard = resource.getrlimit(resource.RLIMIT_NOFILE)
    wanted = _MOST_OPEN if hard == resource.RLIM_INFINITY else min(_MOST_OPEN, hard)
    if soft != resource.RLIM_INFINITY and soft < wanted:
        resource.setrlimit(resource.RLIMIT_NOFILE, (wanted, hard))
