"""From the layers of a pearl to the way people judge its look.

>>> import nacreous as nc
>>> image = nc.render("paper", size=32, samples=4)
>>> image.linear.shape
(32, 32, 3)
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from nacreous import body, colour, file, iridescence, medium, nacre, optics, scaling, texture
    from nacreous.image import Image, render
    from nacreous.nacre import LayerStack, grow
    from nacreous.problem import InputError
    from nacreous.spec import Pearl, Scene, load

__version__ = "0.1.0"

__all__ = [
    "Image",
    "InputError",
    "LayerStack",
    "Pearl",
    "Scene",
    "body",
    "colour",
    "file",
    "grow",
    "iridescence",
    "load",
    "medium",
    "nacre",
    "optics",
    "render",
    "scaling",
    "texture",
]

#: Where each public name lives. Loaded when first asked for, so that a command that needs no
#: picture starts without the rooms that make one.
_HOME = {
    "Image": "image",
    "InputError": "problem",
    "LayerStack": "nacre",
    "Pearl": "spec",
    "Scene": "spec",
    "grow": "nacre",
    "load": "spec",
    "render": "image",
}


def __getattr__(name: str) -> Any:
    if name in _HOME:
        return getattr(import_module(f"nacreous.{_HOME[name]}"), name)
    if name in __all__:
        return import_module(f"nacreous.{name}")
    raise AttributeError(f"module 'nacreous' has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted({*__all__, *globals()})
