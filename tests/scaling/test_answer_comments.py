"""Lines of comments above a table, and the list of columns that PCIbex writes there."""

import re

import numpy as np
import pytest

import nacreous as nc
from nacreous.scaling import Comparisons
from tests.scaling.answer_texts import read, said

PCIBEX = """# Results on Monday, March 02 2026 10:03:43 UTC.
# USER AGENT: Mozilla/5.0 (X11; Linux), Gecko
# Design number was non-random = 1
#\x20
# Columns below this comment are as follows:
# 1. Results reception time.
# 2. MD5 hash of participant's IP address.
# 3. Left.
# 4. Right
# 5. Picked, at last.
"""


@pytest.mark.parametrize("ends", ["\n", "\r\n", "\r"])
@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16"])
def test_comments_above_names_are_left_out_and_count_as_rows(tmp_path, ends, encoding):
    text = '# Pearls, of "spring"\n"# by me, and you",,,\n\n#\nperson,left,right,chosen\np,A,B,A\n'
    text = text.replace("\n", ends)
    assert said(read(tmp_path, text.encode(encoding))) == ["p:A>B"]
    with pytest.raises(nc.InputError, match=r"row 7: chosen is \"X\""):
        read(tmp_path, f"{text}q,A,B,X{ends}".encode(encoding))


def test_many_comments_and_many_skipped_rows_are_as_good_as_few(tmp_path):
    table = "person,left,right,chosen\np,A,B,A\n"
    assert said(read(tmp_path, "# note, more\n" * 60 + table)) == ["p:A>B"]
    assert said(read(tmp_path, "a,b\n" * 60 + table, skip_rows=60)) == ["p:A>B"]


def test_pcibex_names_its_columns_in_comments(tmp_path):
    rows = "1581,aa,A,B,A\n1582,ab,C,B,B\n"
    options = {"chosen": "Picked, at last", "person": "Results reception time"}
    assert said(read(tmp_path, f"{PCIBEX}{rows}", **options)) == ["1581:A>B", "1582:B>C"]
    with pytest.raises(nc.InputError, match="did you mean Picked, at last"):
        read(tmp_path, f"{PCIBEX}{rows}")
    with pytest.raises(nc.InputError, match=r'row 13: .* is "X"'):
        read(tmp_path, f"{PCIBEX}{rows}1583,ac,A,B,X\n", **options)
    excel = "".join(
        f"{line},,,,\n" if "," not in line else f'"{line}"\n' for line in PCIBEX.split("\n")[:-1]
    )
    assert said(read(tmp_path, f"{excel}{rows}", **options)) == ["1581:A>B", "1582:B>C"]


@pytest.mark.parametrize(
    ("text", "told"),
    [
        (
            f"{PCIBEX}1581,aa,A,B,A\n# Columns below this comment are as follows:\n# 1. Left.\nA\n",
            "row 12 is a comment below answers, where PCIbex's other columns begin; allowed: one l",
        ),
        (f"{PCIBEX}1,2,A,B\n", "comments name 5 columns, and row 11 has 4 cells; allowed: a line"),
        (
            "# a note\nA,B,A\nB,A,A\nA,C,C\nB,C,B\n",
            "row 2 seems to be an answer, for ",
        ),
    ],
)
def test_comments_that_name_no_columns_are_told_in_one_line(tmp_path, text, told):
    with pytest.raises(nc.InputError, match=re.escape(told)) as refusal:
        read(tmp_path, text)
    assert "\n" not in str(refusal.value)


@pytest.mark.parametrize(
    ("text", "options"),
    [
        ("# left,right,chosen\nA,B,A\n", {}),
        ("# of 2026\n#left;right;chosen\nA;B;A\n", {}),
        (
            "# subj,stimL,stimR,resp\n1,A,B,A\n",
            {"left": "stimL", "right": "stimR", "chosen": "resp"},
        ),
        ("#,left,right,chosen\n1,A,B,A\n", {}),
        ('"#","left","right","chosen"\n1,A,B,A\n', {}),
        ("# a, b, c\nleft,right,chosen\nA,B,A\n", {}),
        ("left,right,chosen\nA,B,A\n#1,A,#1\n", {}),
    ],
)
def test_a_number_sign_before_names_and_in_labels_is_no_comment(tmp_path, text, options):
    assert said(read(tmp_path, text, **options))[0].endswith("A>B")


def test_comments_above_a_square_of_counts_are_left_out(tmp_path):
    path = tmp_path / "c.csv"
    path.write_text("# counts, of spring\n# more\n,A,B\nA,,3\nB,1,\n")
    np.testing.assert_array_equal(Comparisons.read_counts(path).matrix, [[0, 3], [1, 0]])
