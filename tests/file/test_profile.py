"""The ICC profile in a PNG, as strict readers take it: libpng's rules, littleCMS, ICC.1:2022."""

from __future__ import annotations

import io
import itertools
import shutil
import struct
import subprocess
import zlib
from pathlib import Path

import numpy as np
import pytest
from PIL import Image, ImageCms

from nacreous import _core

NAMES = {"srgb": "sRGB IEC61966-2.1", "display-p3": "Display P3"}
PRIMARIES = {
    "srgb": ((0.64, 0.33), (0.30, 0.60)),
    "display-p3": ((0.68, 0.32), (0.265, 0.69)),
}
D50 = bytes.fromhex("0000f6d6000100000000d32d")
REQUIRED = {"desc", "cprt", "wtpt", "chad"} | {
    f"{c}{kind}" for c in "rgb" for kind in ("XYZ", "TRC")
}

pytestmark = pytest.mark.parametrize("space", list(NAMES))


def written(folder: Path, space: str) -> Path:
    codes = np.arange(16 * 16 * 3, dtype=np.uint8).reshape(16, 16, 3)
    _core.write_png(folder / "a.png", codes, space, [])
    return folder / "a.png"


def chunk(path: Path) -> tuple[str, bytes]:
    """The name of the profile in iCCP, and its bytes."""
    data = path.read_bytes()
    start = data.index(b"iCCP") + 4
    length = struct.unpack(">I", data[start - 8 : start - 4])[0]
    name, _, rest = data[start : start + length].partition(b"\0")
    assert rest[0] == 0  # deflate
    return name.decode("latin-1"), zlib.decompress(rest[1:])


def tags(profile: bytes) -> dict[str, bytes]:
    """Each tag's bytes, after the rules that libpng and ICC.1:2022, 7.3, hold its place to."""
    (count,) = struct.unpack(">I", profile[128:132])
    found, places = {}, set()
    for number in range(count):
        name, start, length = struct.unpack(">4sII", profile[132 + 12 * number :][:12])
        assert start % 4 == 0
        assert 132 + 12 * count <= start <= len(profile) - length
        found[name.decode()] = profile[start : start + length]
        places.add((start, length))
    for (start, length), (after, _) in itertools.pairwise(sorted(places)):
        assert after == -(-(start + length) // 4) * 4  # padded, with nothing between
        assert not any(profile[start + length : after])
    return found


def test_header_and_tags_keep_the_rules_of_strict_readers(tmp_path: Path, space: str) -> None:
    name, profile = chunk(written(tmp_path, space))
    assert name == NAMES[space]
    assert struct.unpack(">I", profile[:4]) == (len(profile),)
    assert len(profile) % 4 == 0
    assert profile[8] == 4
    assert profile[12:24] == b"mntrRGB XYZ "
    assert profile[36:40] == b"acsp"
    assert profile[64:68] == bytes(4)  # perceptual
    assert profile[68:80] == D50
    assert not any(profile[100:128])
    found = tags(profile)
    assert set(found) == REQUIRED
    assert all(tag[4:8] == bytes(4) for tag in found.values())
    for text in ("desc", "cprt"):
        records, size, language, length, start = struct.unpack(">II4sII", found[text][8:28])
        assert (records, size, language, start + length) == (1, 12, b"enUS", len(found[text]))
    assert found["desc"][28:].decode("utf-16-be") == NAMES[space]
    assert found["rTRC"] == found["gTRC"] == found["bTRC"]


def test_littlecms_reads_primaries_white_and_name(tmp_path: Path, space: str) -> None:
    _, data = chunk(written(tmp_path, space))
    profile = ImageCms.ImageCmsProfile(io.BytesIO(data)).profile
    assert profile.profile_description == NAMES[space]
    # IEC 61966-2-1 and SMPTE EG 432-1, once the adaptation from D65 to D50 is undone.
    red, green = PRIMARIES[space]
    d65_from_d50 = np.linalg.inv(profile.chromatic_adaptation[0])
    for (xyz, _), expected in (
        (profile.red_colorant, red),
        (profile.green_colorant, green),
        (profile.blue_colorant, (0.15, 0.06)),
    ):
        found = d65_from_d50 @ xyz
        np.testing.assert_allclose(found[:2] / found.sum(), expected, atol=3e-4)
    np.testing.assert_allclose(profile.media_white_point[0], (0.9642, 1.0, 0.8249), atol=2e-5)


def test_other_programs_read_the_profile_without_a_word(tmp_path: Path, space: str) -> None:
    path = written(tmp_path, space)
    with Image.open(path) as picture:
        picture.load()
        assert picture.info["icc_profile"] == chunk(path)[1]
    for command in (["identify", "-verbose"], ["pngfix"], ["pngcheck", "-v"]):
        if shutil.which(command[0]):
            done = subprocess.run([*command, path], check=True, capture_output=True, text=True)
            assert not done.stderr, command
            assert "iCCP" not in done.stdout or "warning" not in done.stdout.lower()
