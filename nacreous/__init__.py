"""From the layers of a pearl to the way people judge its look.

>>> import nacreous as nc
>>> image = nc.render("paper", size=32, samples=4)
>>> image.linear.shape
(32, 32, 3)
"""

import sys

try:
    import lazy_loader

    # Each public name stands in __init__.pyi and nowhere else. It is loaded when first asked for,
    # so that a command that needs no picture starts without the rooms that make one.
    __getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
except KeyboardInterrupt:
    # The program is interrupted before any line of its own that could say so.
    if sys.argv[0] != "-m" and not sys.argv[0].endswith("nacreous"):
        raise
    print("nacreous: interrupted; nothing was written", file=sys.stderr)
    raise SystemExit(130) from None

__version__ = "0.1.0"
