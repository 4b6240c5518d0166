"""What layers are made of: refractive indices by direction and wavelength."""

from nacreous.medium.layer_medium import (
    NAMES,
    IndexTable,
    Medium,
    is_function,
    medium_of,
    sampled,
)
from nacreous.medium.published import PublishedIndex, read

__all__ = [
    "NAMES",
    "IndexTable",
    "Medium",
    "PublishedIndex",
    "is_function",
    "medium_of",
    "read",
    "sampled",
]


def __dir__() -> list[str]:
    """The public names, for completion."""
    return __all__
