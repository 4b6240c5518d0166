"""Public names are written once, in a stub, for people, type checkers and Python alike."""

from __future__ import annotations

import ast
import rlcompleter
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

import nacreous
from nacreous import scaling

PACKAGES = [nacreous, scaling]


def aliases(package: ModuleType) -> list[ast.alias]:
    """The imports of the package's stub."""
    stub = ast.parse(Path(str(package.__file__)).with_suffix(".pyi").read_text())
    return [name for line in stub.body if isinstance(line, ast.ImportFrom) for name in line.names]


@pytest.mark.parametrize("package", PACKAGES)
def test_the_names_of_the_stub_are_those_of_the_package(package: ModuleType) -> None:
    names = [alias.name for alias in aliases(package)]
    assert sorted(names) == package.__all__
    assert len(set(names)) == len(names)


@pytest.mark.parametrize("package", PACKAGES)
def test_a_type_checker_takes_every_name_of_the_stub_for_public(package: ModuleType) -> None:
    """Only `import X as X` makes a name of a stub public (PEP 484)."""
    assert [alias.name for alias in aliases(package) if alias.asname != alias.name] == []


@pytest.mark.parametrize("package", PACKAGES)
def test_a_star_brings_every_name(package: ModuleType) -> None:
    names: dict[str, Any] = {}
    exec(f"from {package.__name__} import *", names)
    assert {name: names[name] for name in package.__all__} == {
        name: getattr(package, name) for name in package.__all__
    }


@pytest.mark.parametrize("package", PACKAGES)
def test_every_name_is_completed(package: ModuleType) -> None:
    offered = rlcompleter.Completer({"nc": package}).attr_matches("nc.")
    assert {f"nc.{name}" for name in package.__all__} <= {word.rstrip("()") for word in offered}


@pytest.mark.parametrize("package", PACKAGES)
def test_a_mistyped_name_is_an_attribute_error(package: ModuleType) -> None:
    with pytest.raises(AttributeError, match=f"{package.__name__} attribute lustre"):
        _ = package.lustre
