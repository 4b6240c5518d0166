"""From the layers of a pearl to the way people judge its look.

>>> import nacreous as nc
>>> image = nc.render("paper", size=32, samples=4)
>>> image.linear.shape
(32, 32, 3)
"""

import lazy_loader

__version__ = "0.1.0"

# Each public name stands in __init__.pyi and nowhere else. It is loaded when first asked for, so
# that a command that needs no picture starts without the rooms that make one.
__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
