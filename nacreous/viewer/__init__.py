"""The viewer: the page on which a pearl is turned, served from this computer to its own browser."""

from nacreous.viewer.link import fragment
from nacreous.viewer.page import FOLDER, Page

__all__ = ["FOLDER", "Page", "fragment"]


def __dir__() -> list[str]:
    """The public names, for completion."""
    return __all__
