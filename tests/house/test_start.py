"""The first start, ./just: what a machine lacks is said before anything is installed."""

import json
import re
import shutil
import subprocess
import tomllib
from pathlib import Path

import pytest

ROOT = Path(__file__).parent.parent.parent
SHELL = ["sh", "dirname", "mktemp", "rm", "sed"]


@pytest.fixture
def machine(tmp_path):
    """A bare machine with a clone: `add` installs a command on it, `start` calls ./just."""
    clone = tmp_path / "a clone"
    commands = tmp_path / "bin"
    clone.mkdir()
    commands.mkdir()
    shutil.copy(ROOT / "just", clone)
    shutil.copy(ROOT / "Cargo.toml", clone)

    class Machine:
        installed = clone / ".tools"

        def add(self, name: str, script: str, folder: Path = commands) -> None:
            folder.mkdir(parents=True, exist_ok=True)
            (folder / name).write_text(f"#!/bin/sh\n{script}\n")
            (folder / name).chmod(0o755)

        def add_to_rustup(self, name: str, script: str) -> None:
            self.add(name, script, tmp_path / ".cargo/bin")

        def start(self) -> subprocess.CompletedProcess[str]:
            return subprocess.run(
                [clone / "just", "pearl"],
                env={"PATH": str(commands), "HOME": str(tmp_path)},
                capture_output=True,
                text=True,
            )

    for name in SHELL:
        (commands / name).symlink_to(shutil.which(name))
    return Machine()


def test_everything_missing_is_named_with_its_install_line(machine):
    start = machine.start()
    assert start.returncode == 1
    for needed in ("Python 3.11", "apt install python3 ", "cargo", "sh.rustup.rs", "libc6-dev"):
        assert needed in start.stderr
    assert not machine.installed.exists()


def test_an_old_cargo_and_a_python_without_venv_are_named(machine):
    machine.add("cargo", "echo 'cargo 1.63.0 (fd9c4297c 2022-07-01)'")
    machine.add("cc", "exit 0")
    machine.add("python3", 'case "$2" in *ensurepip*) exit 1;; *print*) echo 3.12;; esac')
    start = machine.start()
    assert start.returncode == 1
    assert re.search(r"cargo 1\.\d+ or newer \(here: cargo 1\.63\.0", start.stderr)
    assert "sudo apt install python3.12-venv" in start.stderr
    assert "linker" not in start.stderr
    assert not machine.installed.exists()


def test_the_newest_cargo_found_is_used_wherever_it_is(machine):
    machine.add("cargo", "echo 'cargo 1.63.0 (of the distribution)'")
    machine.add("cc", "exit 0")
    machine.add("python3", 'case "$1" in -m) cargo --version; exit 7;; esac')
    machine.add_to_rustup("cargo", "echo 'cargo 1.999.0 (of rustup)'")
    start = machine.start()
    assert (start.returncode, start.stdout) == (7, "cargo 1.999.0 (of rustup)\n")
    machine.add_to_rustup("cargo", "exit 1")  # rustup without a toolchain
    assert "(here: cargo 1.63.0 (of the distribution)" in machine.start().stderr


def test_the_readme_names_the_cargo_that_is_asked_for():
    asked = tomllib.loads((ROOT / "Cargo.toml").read_text())["workspace"]["package"]["rust-version"]
    for page in ("README.md", "CONTRIBUTING.md"):
        assert f"cargo {asked} or newer" in (ROOT / page).read_text(encoding="utf-8")


def test_node_is_named_but_not_needed(machine):
    machine.add("cargo", "echo 'cargo 1.999.0'")
    machine.add("cc", "exit 0")
    machine.add("python3", 'case "$1" in -m) echo installing; exit 7;; esac')
    start = machine.start()
    assert "sudo apt install nodejs npm" in start.stderr
    assert (start.returncode, start.stdout) == (7, "installing\n")


def test_the_python_asked_for_is_that_of_the_package():
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    asked = re.search(r'oldest_python="(\d+), (\d+)"', (ROOT / "just").read_text())
    assert project["requires-python"] == f">={asked[1]}.{asked[2]}"


def test_the_pearl_installs_no_tool_of_the_tests():
    groups = tomllib.loads((ROOT / "pyproject.toml").read_text())["dependency-groups"]
    assert [re.match(r"[\w-]+", one)[0] for one in groups["build"]] == ["maturin"]
    assert "dev" not in groups  # which maturin installs with every build
    recipes = (ROOT / "justfile").read_text()
    installed = re.search(r"\n_program: .*?\n\n", recipes, re.DOTALL)[0]
    assert "\npearl: _program\n" in recipes
    assert (
        "--constraints requirements.lock --requirements pyproject.toml --group build" in installed
    )


def test_whatever_the_program_needs_is_locked_by_its_hash():
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    locked = re.findall(
        r"^([\w.-]+)==.*?\\\n +--hash=", (ROOT / "requirements.lock").read_text(), re.MULTILINE
    )
    asked = [re.match(r"[\w.-]+", one)[0] for one in project["dependencies"]]
    assert {name.replace("_", "-") for name in asked} <= set(locked)


def test_the_rust_asked_for_suffices_for_every_dependency():
    host = re.search(r"host: (\S+)", run("rustc", "-vV"))[1]
    packages = json.loads(
        run("cargo", "metadata", "--locked", "--format-version=1", "--filter-platform", host)
    )["packages"]
    asked = tomllib.loads((ROOT / "Cargo.toml").read_text())["workspace"]["package"]["rust-version"]
    newer = {
        package["name"]: package["rust_version"]
        for package in packages
        if version(package["rust_version"] or "0") > version(asked)
    }
    assert newer == {}


def run(*words: str) -> str:
    return subprocess.run(words, cwd=ROOT, check=True, capture_output=True, text=True).stdout


def version(text: str) -> list[int]:
    return [int(number) for number in f"{text}.0".split(".")[:2]]
