"""What a command loads: no more than it needs."""

from __future__ import annotations

import shutil
import subprocess
import sys
from pathlib import Path

from nacreous import cli


def loaded_after(code: str, folder: Path) -> set[str]:
    program = f"import sys\n{code}\nprint(*sys.modules)"
    done = subprocess.run(
        [sys.executable, "-c", program], check=True, capture_output=True, text=True, cwd=folder
    )
    return set(done.stdout.split())


def test_importing_the_package_loads_no_room(tmp_path: Path) -> None:
    loaded = loaded_after("import nacreous", tmp_path)
    assert not loaded & {"numpy", "pydantic", "matplotlib", "scipy", "nacreous._core"}


def test_a_command_loads_no_other(tmp_path: Path) -> None:
    loaded = loaded_after("from nacreous.cli import main; main(['render', '-h'])", tmp_path)
    commands = {f"nacreous.commands.{name}" for name in cli.COMMANDS}
    assert loaded & commands == {"nacreous.commands.render"}


def test_files_and_messages_load_no_numpy(tmp_path: Path) -> None:
    loaded = loaded_after("import nacreous.file, nacreous.number, nacreous.spec", tmp_path)
    assert "nacreous._core" in loaded
    assert "numpy" not in loaded


def test_reading_files_checks_no_table_by_itself(tmp_path: Path) -> None:
    """Each class of table has a check of its own, which pydantic builds when it is first used."""
    code = """
from nacreous.spec import Pearl, Scene
from nacreous.spec.section import Section
Pearl.load("paper"), Scene.load("paper")
def below(model): return [model, *(low for sub in model.__subclasses__() for low in below(sub))]
print(*(model.__name__ for model in below(Section) if model.__pydantic_complete__), end=" ")"""
    loaded = loaded_after(code, tmp_path)
    assert loaded & {"Pearl", "Scene", "Growth", "Film", "Camera", "Table"} == {"Pearl", "Scene"}


def test_rendering_loads_no_drawing_and_no_science_library(tmp_path: Path) -> None:
    render = "from nacreous.cli import main; main(['render', 'paper', '--size=8', '--samples=1'{}])"
    loaded = loaded_after(render.format(", '--set', 'depth=0.5'"), tmp_path)
    assert "pydantic" in loaded
    assert not loaded & {"numpy", "matplotlib", "scipy", "colour", "PIL", "OpenEXR"}
    assert "pydantic" not in loaded_after(render.format(""), tmp_path), "for a preset as it is"


def test_the_installed_command_runs(tmp_path: Path) -> None:
    command = shutil.which("nacreous", path=str(Path(sys.executable).parent))
    assert command is not None
    done = subprocess.run(
        [command, "render", "paper", "--size", "8", "--samples", "10"],
        cwd=tmp_path,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 2
    assert done.stderr == (
        "nacreous: samples is 10; allowed: a square number from 1 to 1024, such as 16\n"
    )
    assert not list(tmp_path.iterdir())
