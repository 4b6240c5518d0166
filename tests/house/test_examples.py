"""Every program in examples/ runs, and warns of nothing."""

import subprocess
import sys
from pathlib import Path

import pytest

EXAMPLES = sorted((Path(__file__).parent.parent.parent / "examples").glob("*.py"))
#: Whether an example runs does not hang on how finely it does.
OPTIONS = {"families.py": (".", "roughly"), "shapes.py": ("shapes.png", "48")}


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda path: path.name)
def test_examples_run(example, tmp_path):
    done = subprocess.run(
        [sys.executable, "-W", "error", example, *OPTIONS.get(example.name, ())],
        cwd=tmp_path,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
    )
    assert done.returncode == 0, f"{example} ended with code {done.returncode}:\n{done.stdout}"
