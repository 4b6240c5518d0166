"""Files that are not what they should be."""

from __future__ import annotations

from pathlib import Path

import pytest

from nacreous.spec import (
    Pearl,
    Scene,
    load,
)
from tests.spec.keys import (
    problems,
)


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (b"", "empty"),
        (b"# only a comment\n", "empty"),
        (b"name = \n", "line 1, column 8: not TOML"),
        (b"[nacre]\nseed = 1\nseed = 2\n", "line 3"),
        (b"name = 'never closed", "line 1, column 21"),
        (b"\x89PNG\r\n\x1a\n\0\0", "binary"),
        (b"name = 'a'\n# \xff\n", "line 2: is not UTF-8"),
        (b"a = " + b"[" * 5000, "line 1, column 37: nested too deeply"),
        (b"[nacre]\nseed = " + b"9" * 5000, "too long"),
        (b"# " + b"a" * 1_000_000, "1000000 bytes"),
        (b"nam = 'a'\n", "nam is not a key here; did you mean name?"),
    ],
)
def test_a_bad_file_is_refused_in_one_line(tmp_path: Path, content: bytes, words: str) -> None:
    path = tmp_path / "bad.toml"
    path.write_bytes(content)
    (line,) = problems(lambda: Pearl.load(path))
    assert line.startswith(f"{path}: ")
    assert words in line


def test_a_folder_a_missing_file_and_a_device_are_refused(tmp_path: Path) -> None:
    folder = tmp_path / "folder.toml"
    folder.mkdir()
    assert problems(lambda: Pearl.load(folder)) == [f"{folder}: is a folder; wanted: a TOML file"]
    missing = tmp_path / "none.toml"
    said = f"{missing}: does not exist; wanted: a TOML file; did you mean {folder}?"
    assert problems(lambda: Pearl.load(missing)) == [said]
    assert "not a regular file" in problems(lambda: Pearl.load("/dev/zero"))[0]
    assert problems(lambda: Pearl.load("a\0b.toml"))


def test_a_windows_file_with_a_byte_order_mark_is_read(tmp_path: Path) -> None:
    path = tmp_path / "windows.toml"
    path.write_bytes(b'\xef\xbb\xbfname = "w"\r\ndepth = 1\r\n')
    assert Pearl.load(path).depth == 1.0


def test_a_scene_given_as_a_pearl_is_called_a_scene(tmp_path: Path) -> None:
    path = tmp_path / "s.toml"
    path.write_text('name = "s"\n[camera]\nexposure = 2.0\n')
    assert problems(lambda: Pearl.load(path)) == [f"{path}: is a scene file; wanted: a pearl file"]
    assert "is a scene preset" in problems(lambda: Pearl.load("booth"))[0]
    assert isinstance(load(path), Scene)
    path.write_text('name = "s"\n')
    assert "neither a pearl nor a scene" in problems(lambda: load(path))[0]
