"""Which names a server answers to: another site's name that leads here is none of them.

Otherwise a page elsewhere, whose name is made to lead to this machine, would count as our own; and
links would begin with whatever a request calls us.
"""

from __future__ import annotations

import ipaddress
import re
from collections.abc import Iterable
from typing import Any
from urllib.parse import urlsplit

from starlette.datastructures import Headers

from nacreous.problem import InputError
from nacreous.server.origin import origin_of
from nacreous.server.refusal import Refusal

#: This machine, as its own browsers call it.
_THIS_MACHINE = frozenset(("localhost", "127.0.0.1", "::1"))
_LABEL = r"[a-z0-9_](?:[a-z0-9_-]{0,61}[a-z0-9_])?"
#: The last label is no number, or browsers take the name for an address of the fourth version.
_NAME = re.compile(rf"(?:{_LABEL}\.)*(?![0-9]+\.?$){_LABEL}\.?")
_HOST = re.compile(r"(?:\[(?P<address>[0-9a-fA-F:.]+)\]|(?P<name>[^\s:/?#@\[\]\\]+))(?::\d{0,5})?")


def host_of(given: str) -> str:
    """A host's one form: no port, no brackets, small letters, ASCII, no dot at its end.

    Raises `InputError` for what is no host.

    >>> host_of("Pearls.Example.:8000"), host_of("[::1]:8000"), host_of("真珠.example")
    ('pearls.example', '::1', 'xn--5dy32e.example')
    """
    found = _HOST.fullmatch(given)
    # An address of the sixth version stands without brackets where no port can follow.
    name = (found["address"] or found["name"]) if found else given
    try:
        return _plain(name)
    except ValueError:
        name = "" if found is None else name
        name = urlsplit(origin_of(f"http://{name}")).hostname or ""
    if (found and found["address"]) or not _NAME.fullmatch(name):
        raise InputError(
            f"host is {ascii(given)[:80]}; allowed: a name or an address, such as lab-pc.example"
        )
    return name.removesuffix(".")


def _plain(address: str) -> str:
    """An address in its one form; one of the fourth version in the sixth is itself."""
    made = ipaddress.ip_address(address)
    mapped = made.ipv4_mapped if isinstance(made, ipaddress.IPv6Address) else None
    return str(mapped or made)


class Hosts:
    """The names that a server answers to, beside the address that a request came in at.

    named: hosts that are ours too, such as that of the address that people type.
    """

    def __init__(self, named: Iterable[str] = ()) -> None:
        self._named = _THIS_MACHINE | {host_of(name) for name in named}

    def check(self, headers: Headers, server: Any) -> None:
        """Refuse a request that calls us by a name that is not ours.

        server: of the ASGI scope, where the connection came in. A request without a name is one of
        a program that is no browser; its links begin with where it came in.
        """
        given = headers.getlist("host")
        if not given:
            return
        try:
            called = {host_of(name) for name in given}
        except InputError:
            called = set()
        if len(given) == 1 and called and called <= self._named | _where(server):
            return
        raise Refusal(
            400,
            "input",
            f"Host is {ascii(', '.join(given))[:80]}, which is not this server's; wanted: the "
            "address it listens on, that of --url, or one of --allow-host",
        )


def _where(server: Any) -> set[str]:
    """The address at which a connection came in; none by a Unix socket."""
    try:
        return {_plain(str(server[0]).partition("%")[0])}
    except (TypeError, ValueError, IndexError):
        return set()
