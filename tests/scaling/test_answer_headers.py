"""Lines of names as programs of experiments and surveys write them, and what stands above and below."""

import re

import pytest

import nacreous as nc
from tests.scaling.test_answer_files import read, said


@pytest.mark.parametrize("encoding", ["utf-8", "utf-16"])
@pytest.mark.parametrize(
    ("mark", "titles"),
    [
        (",", "My study\n"),
        (";", "My study\nOf pearls, in 2024\n"),
        ("\t", "C:\\Data\\Pearls-1.edat3\n\n"),
        ("\t", "Pearls, spring 2024\n"),
        ("|", "A; B\n\nC, D\n"),
    ],
)
def test_titles_above_names_of_other_programs_are_left_out(tmp_path, mark, titles, encoding):
    names = mark.join(["Subject", "LeftStim", "RightStim", "Choice.RESP"])
    rows = "".join(mark.join(row) + "\n" for row in (("1", "A", "B", "A"), ("2", "B", "C", "C")))
    text = f"{titles}{names}\n{rows}".encode(encoding)
    options = {"left": "LeftStim", "right": "RightStim", "chosen": "Choice.RESP"}
    told = ", ".join(f"{role}={name!r}" for role, name in options.items())
    with pytest.raises(nc.InputError, match=f"name them by {re.escape(told)}"):
        read(tmp_path, text)
    assert said(read(tmp_path, text, **options)) == ["1:A>B", "2:C>B"]
