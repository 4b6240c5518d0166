"""The public names of the room: all there, and none hidden by a module (more: tests/house/)."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

import nacreous as nc
from nacreous import scaling

FOLDER = Path(scaling.__file__).parent
MODULES = {path.stem for path in FOLDER.iterdir() if path.suffix == ".py" or path.is_dir()}


def test_no_module_hides_a_public_name():
    """Once a module is imported, the package has it as an attribute of its name."""
    assert set(scaling.__all__) & MODULES == set()


@pytest.mark.parametrize("name", scaling.__all__)
def test_every_public_name_is_there_and_says_what_it_is(name):
    public = getattr(nc.scaling, name)
    assert public.__name__ == name
    assert public.__doc__


def test_importing_the_room_loads_nothing_heavy():
    heavy = {"scipy", "pyarrow", "pandas", "matplotlib", "pydantic"}
    code = f"import sys, nacreous.scaling; print({heavy} & set(sys.modules))"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "set()"


def test_a_former_name_warns_once_however_it_is_imported():
    code = "from nacreous.scaling import study; import nacreous as nc; nc.scaling.study"
    command = [sys.executable, "-W", "always", "-c", code]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    assert done.stderr.count("nacreous.scaling.study is now nacreous.scaling.analyse") == 1
    assert done.stderr.startswith("<string>:1:")
