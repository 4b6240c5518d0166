"""The paper again: its figures made anew, each beside the sentence that it must satisfy.

`nacreous.paper.make.make` makes them all; `nacreous.paper.cutting` cuts the seven crops of figure 2
from any picture of a pearl.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
