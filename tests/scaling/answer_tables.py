"""Answers as tables, and what is refused of them."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

import nacreous as nc

TABLE: dict[str, list[Any]] = {
    "person": ["mika", "mika", "ren", "ren"],
    "left": ["2", "10", "2", "9"],
    "right": ["10", "9", "10", "2"],
    "chosen": ["2", "right", "tie", "left"],
    "trial": [1, 2, 1, 2],
    "response_s": [0.5, 1.25, None, 2.0],
    "sex": ["f", "f", "m", None],
}
CSV = """\
person,left,right,chosen,trial,response_s,sex
mika,2,10,2,1,0.5,f
mika,10,9,right,2,1.25,f
ren,2,10,tie,1,,m
ren,9,2,left,2,2.0,
"""


def refusal(act: Any) -> list[str]:
    with pytest.raises(nc.InputError) as caught:
        act()
    lines = str(caught.value).splitlines()
    assert all(0 < len(line) < 400 for line in lines)
    return lines


def written(folder: Path, content: str | bytes, name: str = "answers.csv") -> Path:
    path = folder / name
    path.write_bytes(content.encode() if isinstance(content, str) else content)
    return path
