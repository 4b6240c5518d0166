"""A section that is a whole file: it can be loaded, changed on the way in, and written out."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any, ClassVar, Self, TypeVar

from pydantic import BaseModel, ValidationError

from nacreous.missing import beside
from nacreous.problem import InputError
from nacreous.spec import document, override, preset
from nacreous.spec.complaint import complaints, nearest, shown
from nacreous.spec.key import FilePath, sections_in
from nacreous.spec.section import Section
from nacreous.spec.toml import to_toml
from nacreous.stream import STREAM

Checked = TypeVar("Checked", bound=Section)


class SpecFile(Section):
    """What a pearl file and a scene file have in common."""

    #: What there are presets of: "pearl", "scene" or "study".
    preset_kind: ClassVar[str]

    @classmethod
    def load(cls, path_or_preset: str | Path, overrides: override.Overrides = ()) -> Self:
        """Read a TOML file, or the preset of that name, with single keys overridden.

        `overrides` are pairs of a dotted key and its value or the TOML text of that, as in
        `[("nacre.seed", 9)]`, `{"nacre.seed": 9}` or `"nacre.seed=9"`. Paths in the file are
        relative to the file; paths in overrides are relative to where the program runs. An
        InputError has one line for each problem.
        """
        path, where = find(path_or_preset, (cls.preset_kind,))[1:]
        return cls.check(document.read(path), where, path.parent, overrides)

    @classmethod
    def from_toml(cls, text: str, where: str = "text") -> Self:
        """Read the text of a file, such as the one kept in a picture; `where` is for messages."""
        return cls.check(document.parse(text, where), where, Path())

    @classmethod
    def check(
        cls,
        values: dict[str, Any],
        where: str,
        folder: Path,
        overrides: override.Overrides = (),
    ) -> Self:
        """The model of a file's keys; `where` names the file and `folder` is where it lies."""
        for other in SpecFile.__subclasses__():
            if not cls.known_keys(values) and other.known_keys(values):
                raise InputError(
                    f"{where}: is a {other.preset_kind} file; wanted: a {cls.preset_kind} file"
                )
        return checked(cls, values, where, folder, overrides)

    @classmethod
    def known_keys(cls, values: dict[str, Any]) -> int:
        """How many of a file's outermost keys are this model's, the name that all have aside."""
        return sum(key in cls.model_fields and key != "name" for key in values)

    def to_toml(self) -> str:
        """The complete file, every default written out, so that it can be made again.

        >>> from nacreous.spec import Pearl
        >>> Pearl.from_toml(Pearl(depth=0.7).to_toml()) == Pearl(depth=0.7)
        True
        """
        return to_toml(self.model_dump(exclude_none=True))


def checked(
    model: type[Checked],
    values: dict[str, Any],
    where: str,
    folder: Path,
    overrides: override.Overrides = (),
) -> Checked:
    """Keys as a section, or an InputError with a line for each problem; `where` names the keys."""
    move_paths(model, values, lambda path: str(folder / path))
    overridden = override.apply(values, overrides)
    try:
        return model.model_validate(values)
    except ValidationError as error:
        lines = complaints(error, model, values, _placed(where, overridden))
        raise InputError("\n".join(lines)) from None


def find(path_or_preset: str | Path, kinds: tuple[str, ...]) -> tuple[str, Path, str]:
    """The preset's kind ("" for a file), the path to read, and its name for messages.

    A path wins when it ends in .toml, has a folder in front, or is a file; then come the presets
    of the kinds in order. So a *folder* called paper does not hide the preset paper.
    """
    path, name = Path(path_or_preset), str(path_or_preset)
    if name == STREAM or path.suffix.lower() == ".toml" or len(path.parts) != 1 or path.is_file():
        return "", path, document.label(path)
    for kind in kinds:
        if name in preset.names(kind):
            return kind, preset.path(kind, name), f"preset {name}"
    if path.exists():
        return "", path, document.label(path)
    for kind in preset.FOLDERS:
        if name in preset.names(kind):
            raise InputError(
                f"{shown(name)} is a {kind} preset; wanted: a {' or '.join(kinds)} file or preset"
            )
    choices = [choice for kind in kinds for choice in preset.names(kind)]
    found = beside(name)
    word = Path(name).name.lower()
    meant = found is not None and word in (Path(found).name.lower(), Path(found).stem.lower())
    near = found if meant else nearest(name, choices) or found
    hint = f"did you mean {near}?" if near else f"presets: {', '.join(dict.fromkeys(choices))}"
    raise InputError(f"{shown(name)} is neither a file nor a {' or '.join(kinds)} preset; {hint}")


def _placed(where: str, overridden: dict[str, str]) -> Callable[[str], str]:
    """Where a key's value came from: the file, or the option that set it."""

    def place(path: str) -> str:
        steps = f"{path}."
        outside = (
            by
            for key, by in overridden.items()
            if steps.startswith(f"{key}.") or key.startswith(steps)
        )
        return next(outside, where)

    return place


def move_paths(model: type[BaseModel], values: Any, move: Callable[[str], str]) -> None:
    """Change each path in a file's keys, in place.

    >>> from nacreous.spec import Scene
    >>> values = {"lamps": [{"spectrum": "lamp.csv"}, {"spectrum": "D65"}]}
    >>> move_paths(Scene, values, lambda path: f"lights/{path}")
    >>> [lamp["spectrum"] for lamp in values["lamps"]]
    ['lights/lamp.csv', 'D65']
    """
    if not isinstance(values, dict):
        return
    for name, field in model.model_fields.items():
        if name not in values:
            continue
        value = values[name]
        marks = [mark for mark in field.metadata if isinstance(mark, FilePath)]
        for mark in marks:
            if isinstance(value, list):
                values[name] = [_moved(entry, mark, move) for entry in value]
            else:
                values[name] = _moved(value, mark, move)
        for inner in sections_in(field.annotation):
            for entry in value if isinstance(value, list) else [value]:
                move_paths(inner, entry, move)


def _moved(value: Any, mark: FilePath, move: Callable[[str], str]) -> Any:
    return move(value) if isinstance(value, str) and mark.names_file(value) else value
