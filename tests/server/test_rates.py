"""How often somebody may: windows of time, and a memory that does not grow."""

from nacreous.server import rates
from nacreous.server.rates import LIMITS, Rates, address_of

LOGINS = "logins of an address"


def test_no_window_of_time_holds_more_than_is_allowed() -> None:
    now = [0.0]
    counted = Rates(clock=lambda: now[0])
    most, window_s = LIMITS[LOGINS]
    taken = []
    for step in range(2000):
        now[0] = step * 0.37
        if counted.takes(LOGINS, "a"):
            taken.append(now[0])
    assert len(taken) > 3 * most
    assert all(later - one >= window_s for one, later in zip(taken, taken[most:], strict=False))


def test_everyone_is_counted_alone_and_by_each_limit_alone() -> None:
    counted = Rates(clock=lambda: 0.0)
    assert [counted.takes(LOGINS, "a") for _ in range(6)] == [True] * 5 + [False]
    assert counted.takes(LOGINS, "b")
    assert counted.takes("refusals", "a")


def test_the_wait_that_is_told_is_long_enough_and_no_longer() -> None:
    now = [100.0]
    counted = Rates(clock=lambda: now[0])
    for _ in range(5):
        counted.takes(LOGINS, "a")
        now[0] += 7.3
    wait_s = int(counted.busy(LOGINS, "a").headers["Retry-After"])
    now[0] += wait_s - 1
    assert not counted.takes(LOGINS, "a")
    now[0] += 1
    assert counted.takes(LOGINS, "a")


def test_a_million_addresses_fill_no_memory(monkeypatch) -> None:
    monkeypatch.setattr(rates, "_MOST", 100)
    counted = Rates(clock=lambda: 0.0)
    for number in range(1000):
        counted.takes(LOGINS, str(number))
    assert len(counted._times[LOGINS]) == 100
    assert "999" in counted._times[LOGINS]


def test_an_address_is_of_one_connection() -> None:
    assert address_of("2001:db8::1") == address_of("2001:db8::ffff:1")
    assert address_of("2001:db8::1") != address_of("2001:db8:0:1::1")
    assert address_of("192.0.2.1") != address_of("192.0.2.2")
    assert address_of(None) == "unknown"
