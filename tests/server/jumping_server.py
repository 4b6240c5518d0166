"""`nacreous` with a clock that jumps by hours or years whenever it is looked at."""

import sys
from datetime import UTC, datetime, timedelta
from itertools import accumulate, cycle
from typing import Any

from nacreous.study.store import Store
from tests.support import server_process

JUMPS = (timedelta(hours=-3), timedelta(days=4000), timedelta(days=-8000), timedelta(days=4001))
_TIMES = accumulate(cycle(JUMPS), initial=datetime(2026, 3, 1, tzinfo=UTC))
_OPEN = Store.open


def main() -> int:
    def jumping(place: Any = None, **options: Any) -> Store:
        return _OPEN(place, clock=lambda: next(_TIMES), **options)

    Store.open = jumping  # type: ignore[method-assign,assignment]
    return server_process.main()


if __name__ == "__main__":
    sys.exit(main())
