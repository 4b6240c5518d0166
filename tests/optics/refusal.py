"""What exact optics refuses, in one line."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import nacreous as nc

NM = np.arange(380.0, 781.0)


def refusal(act: Any) -> str:
    with pytest.raises(nc.InputError) as caught:
        act()
    message = str(caught.value)
    assert "\n" not in message
    assert len(message) < 200
    return message
