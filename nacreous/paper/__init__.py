"""The paper again: its figures made anew, each beside the sentence that it must satisfy.

`nacreous.paper.make.make` makes them all; `crop` and `circle` cut the seven crops of figure 2 from any
picture of a pearl.
"""
