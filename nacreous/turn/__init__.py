"""A pearl on a turntable, or lamps or the camera that go round it: frames, series, films.

>>> shown = list(frames("akoya-rg", "booth", count=3, size=8, samples=1))
>>> [image.linear.shape for image in shown]
[(8, 8, 3), (8, 8, 3), (8, 8, 3)]
"""

from nacreous.turn.motion import WHATS, alike
from nacreous.turn.moving import ENDINGS
from nacreous.turn.turn import frames, save

__all__ = ["ENDINGS", "WHATS", "alike", "frames", "save"]


def __dir__() -> list[str]:
    """The public names, for completion."""
    return __all__
