"""Pictures of the paper, made once for all tests."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from nacreous.paper import make, pictures
from nacreous.paper.pictures import Pictures
from tests.paper.tampering import SIZE_PX


@pytest.fixture(scope="session")
def taken() -> Pictures:
    return pictures.take(SIZE_PX, lambda _: None)


@pytest.fixture(scope="session")
def out(taken: Pictures, tmp_path_factory: Any) -> Path:
    path = tmp_path_factory.mktemp("paper") / "out"
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(pictures, "take", lambda *_: taken)
        make.make(path, SIZE_PX)
    return path
