"""/openapi.json against what the server does: made-up requests, answered as described.

With a valid token or login and without, good requests and bad: no fault, and no status,
header or body that is not described.
"""

from collections.abc import Callable, Iterator
from contextlib import ExitStack
from pathlib import Path

import httpx
import pytest
import schemathesis
from hypothesis import HealthCheck, Phase, given, settings
from schemathesis import Case, GenerationMode
from schemathesis.schemas import APIOperation as Operation
from schemathesis.specs.openapi.checks import negative_data_rejection, positive_data_acceptance

from nacreous.server.app import create_app
from nacreous.server.login import COOKIE
from nacreous.server.rates import LIMITS
from nacreous.study.design import open_frozen
from nacreous.study.running import Running
from nacreous.study.store import Store
from tests.server.people import Experimenter, Person
from tests.support.server_process import in_thread, prepare, small_study, some_pages

#: The study decides more than the description can say: languages, questions, numbers, turns.
KNOWS_MORE = [positive_data_acceptance]

FEW = settings(
    max_examples=4,
    derandomize=True,
    database=None,
    deadline=None,
    phases=[Phase.explicit, Phase.generate],
    suppress_health_check=list(HealthCheck),
)


@pytest.fixture(scope="module")
def served(tmp_path_factory: pytest.TempPathFactory) -> Iterator[httpx.Client]:
    """A server without limits on how often."""
    folder = small_study(tmp_path_factory.mktemp("schema") / "study")
    prepare(folder)
    with ExitStack() as stack:
        patch = stack.enter_context(pytest.MonkeyPatch.context())
        for limit in LIMITS:
            patch.setitem(LIMITS, limit, (1_000_000, 60.0))
        store = stack.enter_context(Store.open(folder))
        pages = some_pages(Path(folder).parent / "pages")
        app = create_app(Running(store, open_frozen(folder)), built=pages)
        url = stack.enter_context(in_thread(app))
        yield stack.enter_context(httpx.Client(base_url=url, timeout=60))


@pytest.fixture(scope="module")
def operations(served: httpx.Client) -> list[Operation]:
    """Every operation that is described."""
    schema = schemathesis.openapi.from_url(f"{served.base_url}/openapi.json")
    found = [operation.ok() for operation in schema.get_all_operations()]
    assert len(found) == 27
    return found


def ask(operations: list[Operation], ask_one: Callable[[Case], object]) -> None:
    """Good and bad requests of each operation."""
    for operation in operations:
        for mode in GenerationMode:
            if mode == GenerationMode.NEGATIVE and not takes_something(operation):
                continue

            @FEW
            @given(operation.as_strategy(generation_mode=mode))
            def run(case: Case) -> None:
                ask_one(case)

            run()


def takes_something(operation: Operation) -> bool:
    """Whether anything can be wrong with a request, beside who asks."""
    return bool(operation.body or operation.path_parameters or operation.query)


def test_whoever_has_no_token(operations: list[Operation]) -> None:
    ask(operations, lambda case: case.call_and_validate(excluded_checks=KNOWS_MORE))


def test_a_participant(operations: list[Operation], served: httpx.Client) -> None:
    def ask_one(case: Case) -> None:
        headers = Person.consented(served).headers
        case.call_and_validate(headers=headers, excluded_checks=KNOWS_MORE)

    ask([one for one in operations if one.path.startswith("/api/")], ask_one)


def test_an_experimenter(operations: list[Operation], served: httpx.Client) -> None:
    def ask_one(case: Case) -> None:
        lab = Experimenter.login(served)
        cookies = {COOKIE: served.cookies[COOKIE]}
        word = {"X-CSRF-Token": lab.csrf}
        # A case that lacks cookie or word is good once they are given.
        excluded = [*KNOWS_MORE, negative_data_rejection]
        case.call_and_validate(headers=word, cookies=cookies, excluded_checks=excluded)

    ask([one for one in operations if one.path.startswith("/lab/")], ask_one)
