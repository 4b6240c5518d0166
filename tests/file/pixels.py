"""Pixels to write, and as littleCMS shows them."""

import io
from pathlib import Path

import numpy as np
from PIL import Image, ImageCms

from nacreous import _core


def gradient(dtype: type, height: int = 37, width: int = 53) -> np.ndarray:
    row, column, channel = np.ogrid[:height, :width, :3]
    return ((row * 1009 + column * 461 + channel * 13007) % (np.iinfo(dtype).max + 1)).astype(dtype)


def converted(
    space: str,
    pixels: np.ndarray,
    folder: Path,
    intent: ImageCms.Intent = ImageCms.Intent.PERCEPTUAL,
) -> np.ndarray:
    """Pixels as littleCMS shows them on an sRGB display, by the profile that we embed."""
    _core.write_png(folder / "a.png", pixels, space, [])
    with Image.open(folder / "a.png") as picture:
        own = ImageCms.ImageCmsProfile(io.BytesIO(picture.info["icc_profile"]))
        srgb = ImageCms.createProfile("sRGB")
        shown = ImageCms.profileToProfile(picture, own, srgb, renderingIntent=intent)
        assert shown is not None
        return np.asarray(shown).astype(int)
