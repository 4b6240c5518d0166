"""Accounts and logins of experimenters, on SQLite and on PostgreSQL."""

import time
from collections.abc import Iterator
from datetime import UTC, datetime, timedelta
from pathlib import Path
from statistics import median

import pytest

from nacreous.problem import InputError
from nacreous.study.store import Store, UnknownToken, passwords

PASSWORD = "nacre, layer on layer"


class Clock:
    """A clock that a test sets."""

    def __init__(self) -> None:
        self.now = datetime(2026, 3, 1, tzinfo=UTC)

    def __call__(self) -> datetime:
        return self.now


@pytest.fixture
def clock() -> Clock:
    return Clock()


@pytest.fixture
def store(place: str, clock: Clock) -> Iterator[Store]:
    with Store.open(place, clock=clock) as made:
        made.set_password("lab", PASSWORD, "me")
        yield made


def test_a_login_is_its_accounts_until_it_logs_out(store: Store) -> None:
    store.set_password("m.mikimoto", PASSWORD + "2", "me")
    assert store.accounts() == ["lab", "m.mikimoto"]
    one, two = store.login("lab", PASSWORD), store.login("m.mikimoto", PASSWORD + "2")
    assert (store.login_of(one), store.login_of(two)) == ("lab", "m.mikimoto")
    store.logout(one)
    store.logout(one)
    with pytest.raises(UnknownToken, match="token is unknown"):
        store.login_of(one)
    assert store.login_of(two) == "m.mikimoto"
    assert [event.what for event in store.events()] == [
        "account made",
        "account made",
        "logged in",
        "logged in",
        "logged out",
    ]


@pytest.mark.parametrize(
    ("name", "password"),
    [
        ("lab", "nacre, layer on layers"),
        ("lab", ""),
        ("lab", PASSWORD + "x" * 100_000),
        ("lab", "\ud800" * 20),
        ("lab", None),
        ("nobody", PASSWORD),
        ("", PASSWORD),
        ("LAB", PASSWORD),
        ("l\0ab", PASSWORD),
        ("真珠", PASSWORD),
        ("' OR 1=1 --", PASSWORD),
        (None, None),
        (["lab"], PASSWORD),
    ],
)
def test_what_is_wrong_is_told_alike(store: Store, name: object, password: object) -> None:
    with pytest.raises(UnknownToken) as caught:
        store.login(name, password)
    assert str(caught.value) == "name or password is wrong; wanted: those of an account"


def test_an_unknown_name_takes_as_long_as_a_wrong_password(store: Store) -> None:
    def lasting(name: str) -> float:
        begin = time.perf_counter()
        with pytest.raises(UnknownToken):
            store.login(name, "not the password")
        return time.perf_counter() - begin

    lasted = [(lasting("lab"), lasting("nobody")) for _ in range(15)]
    known, unknown = (median(times) for times in zip(*lasted, strict=True))
    assert 0.5 < known / unknown < 2


def test_nobodys_hash_costs_what_others_cost() -> None:
    cost = passwords._NOBODY.rpartition("$")[0].rpartition("$")[0]
    assert passwords.hashed(PASSWORD).startswith(cost + "$")
    assert cost == "$argon2id$v=19$m=19456,t=2,p=1"


def test_the_same_password_however_the_keyboard_composed_it(store: Store) -> None:
    store.set_password("lab", "パール" + "é" * 12, "me")
    assert store.login_of(store.login("lab", "ハ\u309aール" + "e\u0301" * 12)) == "lab"


@pytest.mark.parametrize(
    ("name", "password", "told"),
    [
        ("lab", "x" * 11, "password is 11 characters long; allowed: 12 to 200"),
        ("lab", "x" * 201, "password is 201 characters long; allowed: 12 to 200"),
        ("lab", 12, "password is no text; allowed: text"),
        ("lab", "\ud800" * 12, "password holds half a letter; allowed: whole ones"),
        ("", PASSWORD, "name is ''; allowed: 1 to 40 of a to z, 0 to 9, - _ ."),
        ("x" * 41, PASSWORD, "allowed: 1 to 40"),
        ("Lab", PASSWORD, "name is 'Lab'; allowed: 1 to 40 of a to z"),
        ("lab\n", PASSWORD, "name is 'lab\\\\n'"),
    ],
)
def test_a_bad_name_or_password_is_one_line(
    store: Store, name: str, password: str, told: str
) -> None:
    with pytest.raises(InputError) as caught:
        store.set_password(name, password, "me")
    assert told.replace("\\\\", "\\") in str(caught.value)
    assert "\n" not in str(caught.value)
    assert "xxxxxxxxxxx;" not in str(caught.value)


def test_another_password_ends_all_logins_of_the_account(store: Store) -> None:
    token = store.login("lab", PASSWORD)
    store.set_password("lab", "another layer of nacre", "me")
    for attempt in (lambda: store.login_of(token), lambda: store.login("lab", PASSWORD)):
        with pytest.raises(UnknownToken):
            attempt()
    store.login("lab", "another layer of nacre")
    assert store.events()[-2].what == "password changed"


def test_an_account_that_is_removed_is_gone_with_its_logins(store: Store) -> None:
    token = store.login("lab", PASSWORD)
    store.remove_account("lab", "me")
    for attempt in (lambda: store.login_of(token), lambda: store.login("lab", PASSWORD)):
        with pytest.raises(UnknownToken):
            attempt()
    assert store.accounts() == []
    with pytest.raises(InputError, match="there is no account 'lab'"):
        store.remove_account("lab", "me")


def test_a_login_lasts_twelve_hours_in_use_and_two_unused(store: Store, clock: Clock) -> None:
    used, unused = store.login("lab", PASSWORD), store.login("lab", PASSWORD)
    for _ in range(12):
        clock.now += timedelta(minutes=59, seconds=59)
        store.login_of(used)
    with pytest.raises(UnknownToken, match="the login is over; wanted: a new one"):
        store.login_of(unused)
    clock.now += timedelta(seconds=13)
    with pytest.raises(UnknownToken, match="the login is over"):
        store.login_of(used)


def test_a_clock_set_far_back_ends_a_login_and_a_little_back_does_not(
    store: Store, clock: Clock
) -> None:
    token = store.login("lab", PASSWORD)
    clock.now -= timedelta(minutes=10)
    assert store.login_of(token) == "lab"
    clock.now -= timedelta(days=400)
    with pytest.raises(UnknownToken, match="the login is over"):
        store.login_of(token)


def test_logins_that_are_over_do_not_gather(store: Store, clock: Clock) -> None:
    for _ in range(3):
        store.login("lab", PASSWORD)
        clock.now += timedelta(hours=3)
    store.login("lab", PASSWORD)
    with store.reading() as connection:
        assert connection.exec_driver_sql("SELECT count(*) FROM logins").scalar_one() == 1


def test_a_login_survives_a_restart(place: str) -> None:
    with Store.open(place) as store:
        store.set_password("lab", PASSWORD, "me")
        token = store.login("lab", PASSWORD)
    with Store.open(place) as store:
        assert store.login_of(token) == "lab"


def test_neither_password_nor_token_is_in_the_file(tmp_path: Path) -> None:
    with Store.open(tmp_path) as store:
        store.set_password("lab", PASSWORD, "me")
        token = store.login("lab", PASSWORD)
        kept = b"".join(path.read_bytes() for path in tmp_path.iterdir())
    assert PASSWORD.encode() not in kept
    assert token.encode() not in kept
    assert b"$argon2id$v=19$m=19456,t=2,p=1$" in kept


def test_answers_do_not_wait_for_a_login(store: Store, monkeypatch: pytest.MonkeyPatch) -> None:
    real = passwords.matches

    def while_verifying(kept: str | None, password: object) -> bool:
        store.audit("somebody", "written meanwhile")  # would wait for ever inside the writer
        return real(kept, password)

    monkeypatch.setattr(passwords, "matches", while_verifying)
    store.login("lab", PASSWORD)
    assert [event.what for event in store.events()][-2:] == ["written meanwhile", "logged in"]
