"""How often somebody may: counted in memory, in a window of time, for as long as it runs."""

from __future__ import annotations

import time
from collections import OrderedDict, deque
from collections.abc import Callable
from ipaddress import IPv6Address, ip_address
from math import ceil
from threading import Lock

from nacreous.server.refusal import Refusal

#: How often, in how many seconds.
LIMITS = {
    "logins of an address": (5, 60.0),
    "logins of a name": (10, 900.0),
    "entries of an address": (300, 60.0),  # a lecture hall behind one address
    "refusals": (60, 60.0),
}

#: How many are remembered at most, for each limit; the longest silent are forgotten first.
_MOST = 20_000


class Rates:
    """The times at which each of many last did something.

    >>> rates = Rates(clock=lambda: 0.0)
    >>> all(rates.takes("logins of an address", "192.0.2.1") for _ in range(5))
    True
    >>> rates.takes("logins of an address", "192.0.2.1")
    False
    """

    def __init__(self, clock: Callable[[], float] = time.monotonic) -> None:
        self._clock = clock
        self._lock = Lock()
        self._times: dict[str, OrderedDict[str, deque[float]]] = {
            limit: OrderedDict() for limit in LIMITS
        }

    def takes(self, limit: str, who: str) -> bool:
        """Whether it is allowed once more; then it is counted."""
        most, window_s = LIMITS[limit]
        with self._lock:
            now = self._clock()
            times = self._of(limit, who)
            while times and times[0] <= now - window_s:
                times.popleft()
            if len(times) >= most:
                return False
            times.append(now)
            return True

    def take(self, limit: str, who: str) -> None:
        """The same, refused with 429 where it is too often."""
        if not self.takes(limit, who):
            raise self.busy(limit, who)

    def give_back(self, limit: str, who: str) -> None:
        """Count one time less, for what turned out well."""
        with self._lock:
            times = self._of(limit, who)
            if times:
                times.pop()

    def busy(self, limit: str, who: str) -> Refusal:
        """The refusal that says when to come again."""
        most, window_s = LIMITS[limit]
        with self._lock:
            times = self._of(limit, who)
            wait_s = max(1, ceil(times[0] + window_s - self._clock())) if times else 1
        line = f"too often; allowed: {most} in {window_s:.0f} s, again in {wait_s} s"
        return Refusal(429, "busy", line, {"Retry-After": str(wait_s)})

    def _of(self, limit: str, who: str) -> deque[float]:
        everyone = self._times[limit]
        times = everyone.setdefault(who, deque())
        everyone.move_to_end(who)
        if len(everyone) > _MOST:
            everyone.popitem(last=False)
        return times


def address_of(host: str | None) -> str:
    """Whose address it is: of IPv6 the network of one connection, in which anyone has many.

    >>> address_of("2001:db8:1:2:3::4"), address_of("192.0.2.7")
    ('2001:db8:1:2::', '192.0.2.7')
    """
    try:
        address = ip_address(host or "")
    except ValueError:
        return host or "unknown"
    if isinstance(address, IPv6Address) and address.ipv4_mapped is None:
        return str(IPv6Address(int(address) >> 64 << 64))
    return str(address)
