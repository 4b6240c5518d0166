"""Seeing a scale: points on a line, intervals, matrices; as SVG, PDF or PNG.

Sizes are points (1/72 inch). Labels never overlap: where they would, they move aside, then stand
upright, and where even that is not enough, some points keep none, and the drawing says how many.
"""

from nacreous.scaling.figure.interval import interval_plot
from nacreous.scaling.figure.line import scale_plot
from nacreous.scaling.figure.matrix import matrix_plot

__all__ = ["interval_plot", "matrix_plot", "scale_plot"]
