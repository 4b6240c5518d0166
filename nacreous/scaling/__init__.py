"""From choices to a scale, with honest doubt: paired comparisons of anything.

>>> import nacreous as nc
>>> nc.scaling.paper()
Comparisons(2184 answers, 7 stimuli, 21 pairs)
"""

import lazy_loader

# Each public name stands in __init__.pyi and nowhere else; it is loaded when first asked for.
__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
