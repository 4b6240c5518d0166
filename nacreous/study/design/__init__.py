"""What a study shows and asks: its file, and the folder into which it is frozen.

Each key is declared once, in the file of its section, as those of pearls and scenes are.
"""

from nacreous.study.design.design import Design
from nacreous.study.design.freezing import freeze
from nacreous.study.design.manifest import Frozen, FrozenStimulus, open_frozen

__all__ = ["Design", "Frozen", "FrozenStimulus", "freeze", "open_frozen"]


def __dir__() -> list[str]:
    """The public names, for completion."""
    return __all__
