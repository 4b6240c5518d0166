"""From choices to a scale, with honest doubt: paired comparisons of anything.

>>> import nacreous as nc
>>> nc.scaling.paper()
Comparisons(2184 answers, 7 stimuli, 21 pairs)
"""

from importlib import import_module
from typing import Any

import lazy_loader

# Each public name stands in __init__.pyi and nowhere else; it is loaded when first asked for.
_public, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)

#: Where the former names of this version are found, with a warning.
_FORMER = {
    "Design": "planning.design",
    "Group": "data.column",
    "Study": "report.analysis",
    "study": "report.analysis",
}


def __getattr__(name: str) -> Any:
    if name in _FORMER:
        found = getattr(import_module(f"nacreous.scaling.{_FORMER[name]}"), name)
        # `from nacreous.scaling import study` asks twice, and one warning is enough.
        globals()[name] = found
        return found
    return _public(name)
