"""What is said of files that are cut short, changed on the way, or of a kind that is not read."""

from __future__ import annotations

import io
import re
from collections.abc import Callable
from pathlib import Path

import numpy as np
import OpenEXR
import pytest
import tifffile
from PIL import Image

from nacreous.file import read_panorama, read_photograph, read_png_text
from nacreous.problem import InputError

#: Words of programmers that no reader of ours may pass on.
FOREIGN = re.compile(r"buffer|crc|chunk type|0x|unexpected|unsupported|Invalid|error|not supported")
LIGHT = np.random.default_rng(1).uniform(0, 2, (16, 32, 3)).astype(np.float32)
CODES = (127 * LIGHT).astype(np.uint8)


def png(path: Path) -> None:
    Image.fromarray(CODES).save(path)


def tiff(path: Path) -> None:
    tifffile.imwrite(path, CODES, compression="zlib")


def jpeg(path: Path) -> None:
    Image.fromarray(CODES).save(path)


def exr(path: Path) -> None:
    header = {"compression": OpenEXR.ZIP_COMPRESSION, "type": OpenEXR.scanlineimage}
    OpenEXR.File(header, {"RGB": LIGHT}).write(str(path))


def refusal(read: Callable[[Path], object], path: Path) -> str:
    with pytest.raises(InputError) as caught:
        read(path)
    message = str(caught.value)
    assert "\n" not in message
    assert FOREIGN.search(message.removeprefix(str(path))) is None, message
    return message


@pytest.mark.parametrize(
    ("write", "read", "name"),
    [
        (png, read_photograph, "a.png"),
        (png, read_png_text, "a.png"),
        (tiff, read_photograph, "a.tif"),
        (jpeg, read_photograph, "a.jpg"),
        (exr, read_panorama, "a.exr"),
    ],
)
def test_files_cut_short_or_changed_are_refused_in_plain_words(
    tmp_path: Path,
    write: Callable[[Path], None],
    read: Callable[[Path], object],
    name: str,
) -> None:
    path = tmp_path / name
    write(path)
    whole = path.read_bytes()
    for share in (0.2, 0.5, 0.9):
        path.write_bytes(whole[: int(share * len(whole))])
        assert "is damaged or cut short (" in refusal(read, path)
    random = np.random.default_rng(7)
    for _ in range(20):
        changed = bytearray(whole)
        changed[int(random.integers(16, len(whole)))] ^= 0x55
        path.write_bytes(changed)
        try:
            read(path)
        except InputError:
            refusal(read, path)


def test_a_wrong_checksum_is_called_one(tmp_path: Path) -> None:
    path = tmp_path / "a.png"
    file = io.BytesIO()
    Image.fromarray(CODES).save(file, "PNG")
    changed = bytearray(file.getvalue())
    changed[29] ^= 1  # the header's checksum
    path.write_bytes(changed)
    assert "a checksum does not match" in refusal(read_photograph, path)


def test_a_deep_picture_is_refused_as_one(tmp_path: Path) -> None:
    path = tmp_path / "a.exr"
    depths = np.empty((4, 8), object)
    for place in np.ndindex(depths.shape):
        depths[place] = np.ones(2, np.float32)
    header = {"compression": OpenEXR.ZIPS_COMPRESSION, "type": OpenEXR.deepscanline}
    OpenEXR.File(header, dict.fromkeys("RGBZ", depths)).write(str(path))
    assert "deep data that is not read here" in refusal(read_panorama, path)
