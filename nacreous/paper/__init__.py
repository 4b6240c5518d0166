"""The paper again: its figures made anew, each beside the sentence that it must satisfy.

`nacreous.paper.make.make` makes them all; `nacreous.paper.cutting` cuts the seven crops of figure 2
from any picture of a pearl.
"""
