"""The viewer's reading, checking and writing of specs, in TypeScript, against Python's."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

STUDIO = Path(__file__).parent.parent.parent / "studio"


def test_the_page_makes_of_every_file_what_python_makes_of_it(tmp_path: Path) -> None:
    if shutil.which("node") is None or not (STUDIO / "node_modules").is_dir():
        pytest.skip("no packages of the pages here:   ./just pages   (needs Node.js and npm)")
    corpus = tmp_path / "corpus.json"
    with corpus.open("w", encoding="utf-8") as file:
        script = [sys.executable, "-m", "tests.viewer.corpus"]
        subprocess.run(script, stdout=file, check=True, cwd=STUDIO.parent)
    done = subprocess.run(
        ["npx", "--no-install", "vitest", "run", "tests/viewer/corpus.test.ts"],
        env={**os.environ, "NACREOUS_CORPUS": str(corpus), "NO_COLOR": "1"},
        cwd=STUDIO,
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    assert "skipped" not in done.stdout
