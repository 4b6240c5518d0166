"""The file that was probably meant in place of one that is not there."""

from pathlib import Path

import pytest

from nacreous.missing import beside
from nacreous.problem import InputError
from nacreous.spec import Pearl


@pytest.mark.parametrize(
    ("name", "names", "meant"),
    [
        ("Mine.toml", ["mine.toml", "mine.toml.txt"], "mine.toml"),
        ("Mine.toml", ["MINE.TOML.bak", "mine.toml", "mine.toml.txt"], "mine.toml"),
        ("Mine", ["mine", "mine.toml"], "mine"),
        ("Mine", ["mine.toml", "mines"], "mine.toml"),
        ("mine.toml", ["mine.toml.txt", "mien.toml"], "mine.toml.txt"),
    ],
)
def test_a_name_that_differs_in_case_alone_is_meant_before_one_with_another_ending(
    name: str, names: list[str], meant: str, tmp_path: Path
) -> None:
    for other in names:
        (tmp_path / other).touch()
    assert beside(tmp_path / name) == str(tmp_path / meant)
    if not (tmp_path / name).exists():  # some file systems take both names for one
        with pytest.raises(InputError, match=rf"did you mean \S*{meant}\?"):
            Pearl.load(str(tmp_path / name))


def test_a_preset_is_not_meant_where_a_file_differs_in_case_alone(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "akoya-x").touch()
    monkeypatch.chdir(tmp_path)
    with pytest.raises(InputError, match=r"did you mean akoya-x\?"):
        Pearl.load("Akoya-X")
