"""What a photograph's file says of its colours, honoured alike in PNG, JPEG and TIFF."""

from __future__ import annotations

import struct
import zlib
from pathlib import Path

import numpy as np
import pytest
import tifffile
from PIL import Image

from nacreous import _core
from nacreous.file import read_photograph
from nacreous.problem import InputError

P3_CODE = (200, 100, 50)


def chunk(name: bytes, data: bytes) -> bytes:
    return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))


def png(path: Path, codes: np.ndarray, *extra: bytes) -> Path:
    """A 16-bit RGB PNG of these values in 0..1 with further chunks."""
    rows = np.round(codes * 65_535).astype(">u2")
    header = struct.pack(">IIBBBBB", rows.shape[1], rows.shape[0], 16, 2, 0, 0, 0)
    pixels = zlib.compress(b"".join(b"\0" + row.tobytes() for row in rows))
    parts = [chunk(b"IHDR", header), *extra, chunk(b"IDAT", pixels), chunk(b"IEND", b"")]
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + b"".join(parts))
    return path


def profile(folder: Path, length: int) -> bytes:
    """Display P3, padded to a length."""
    _core.write_png(folder / "p3.png", np.zeros((1, 1, 3), np.uint8), "display-p3", [])
    with Image.open(folder / "p3.png") as picture:
        found = picture.info["icc_profile"]
    size = max(length, len(found))
    return struct.pack(">I", size) + found[4:] + bytes(size - len(found))


@pytest.mark.parametrize("length", [0, 3000, 700_000], ids=["small", "middling", "large"])
@pytest.mark.parametrize("side", [4, 64])
def test_a_profile_gives_the_same_light_in_every_format(
    tmp_path: Path, side: int, length: int
) -> None:
    icc = profile(tmp_path, length)
    codes = np.full((side, side, 3), P3_CODE, np.uint8)
    Image.fromarray(codes).save(tmp_path / "a.png", icc_profile=icc)
    expected = read_photograph(tmp_path / "a.png")
    assert abs(float(expected[0, 0, 0]) - 0.6788) < 1e-3  # littleCMS; 0.5776 without the profile
    Image.fromarray(codes).save(tmp_path / "a.jpg", icc_profile=icc, quality=100, subsampling=0)
    np.testing.assert_allclose(read_photograph(tmp_path / "a.jpg"), expected, atol=0.01)
    for order in "<>":
        for pixels in (codes, codes.astype(np.uint16) * 257):
            tifffile.imwrite(
                tmp_path / "a.tif", pixels, photometric="rgb", byteorder=order, iccprofile=icc
            )
            np.testing.assert_array_equal(read_photograph(tmp_path / "a.tif"), expected)


def test_a_tiff_whose_profile_cannot_be_read_is_refused(tmp_path: Path) -> None:
    codes = np.zeros((4, 4, 3), np.uint8)
    text = (34_675, "s", 0, "no profile", True)
    tifffile.imwrite(tmp_path / "a.tif", codes, photometric="rgb", extratags=[text])
    with pytest.raises(InputError, match=r"colour profile that cannot be used .its values are of"):
        read_photograph(tmp_path / "a.tif")


LIGHT = np.linspace(0.02, 0.98, 24).reshape(2, 4, 3)
GAMA = b"gAMA"
ADOBE = chunk(b"cHRM", struct.pack(">8I", 31270, 32900, 64000, 33000, 21000, 71000, 15000, 6000))


def srgb(light: np.ndarray) -> np.ndarray:
    return np.where(light <= 0.0031308, 12.92 * light, 1.055 * light ** (1 / 2.4) - 0.055)


@pytest.mark.parametrize(
    ("codes", "chunks"),
    [
        (LIGHT, [chunk(b"cICP", bytes([1, 8, 0, 1]))]),
        (LIGHT, [chunk(GAMA, struct.pack(">I", 100_000))]),
        (LIGHT ** (1 / 1.8), [chunk(GAMA, struct.pack(">I", 55_556))]),
        (LIGHT ** (1 / 2.2), [chunk(b"cICP", bytes([1, 4, 0, 1]))]),
        (srgb(LIGHT), [chunk(GAMA, struct.pack(">I", 45_455))]),
        (srgb(LIGHT), [chunk(b"sRGB", b"\0"), chunk(GAMA, struct.pack(">I", 100_000)), ADOBE]),
        (LIGHT, [chunk(b"cICP", bytes([1, 8, 0, 1])), chunk(b"sRGB", b"\0")]),
    ],
    ids=["cICP linear", "gAMA 1", "gAMA 1.8", "cICP 2.2", "gAMA for sRGB", "sRGB", "cICP first"],
)
def test_a_png_says_what_its_samples_stand_for(
    tmp_path: Path, codes: np.ndarray, chunks: list[bytes]
) -> None:
    found = read_photograph(png(tmp_path / "a.png", codes, *chunks))
    np.testing.assert_allclose(found, LIGHT, atol=1e-4)


def test_adobes_primaries_are_converted(tmp_path: Path) -> None:
    """By the published matrices; a grey is a grey in both."""
    light = np.array([[[0.3, 0.3, 0.3], [0.6, 0.5, 0.4]]])
    gama = chunk(GAMA, struct.pack(">I", 45_455))
    found = read_photograph(png(tmp_path / "a.png", light**0.45455, gama, ADOBE))
    # Adobe RGB (1998) Color Image Encoding, 4.3.5.3; from XYZ to sRGB by IEC 61966-2-1.
    adobe = [[0.57667, 0.18556, 0.18823], [0.29734, 0.62736, 0.07529], [0.02703, 0.07069, 0.99134]]
    to_srgb = [[3.2406, -1.5372, -0.4986], [-0.9689, 1.8758, 0.0415], [0.0557, -0.2040, 1.0570]]
    expected = light @ np.transpose(adobe) @ np.transpose(to_srgb)
    np.testing.assert_allclose(found, expected, atol=1e-3)


@pytest.mark.parametrize(
    ("numbers", "message"),
    [
        ([9, 16, 0, 1], r"cICP of 9, 16, 0, 1, with transfer function 16 \(PQ\); allowed: 1, 6"),
        ([9, 18, 0, 1], r"transfer function 18 \(HLG\)"),
        ([2, 13, 0, 1], r"primaries 2; allowed: 1 \(BT.709, sRGB\), 9"),
        ([1, 13, 0, 0], r"range 0; allowed: 1, the full range; save it as sRGB"),
        ([1, 13, 1, 1], r"matrix 1; allowed: 0, RGB"),
    ],
)
def test_a_cicp_that_is_not_read_is_refused_by_its_numbers(
    tmp_path: Path, numbers: list[int], message: str
) -> None:
    with pytest.raises(InputError, match=message):
        read_photograph(png(tmp_path / "a.png", LIGHT, chunk(b"cICP", bytes(numbers))))


def test_colours_that_alpha_was_multiplied_into_are_divided_by_it(tmp_path: Path) -> None:
    rgb = np.full((3, 4, 3), [40_000, 20_000, 10_000], np.uint16)
    alpha = np.full((3, 4, 1), 65_535, np.uint16)
    for kind, pixels in (("unassalpha", [rgb, alpha // 2]), ("assocalpha", [rgb // 2, alpha // 2])):
        tifffile.imwrite(
            tmp_path / f"{kind}.tif",
            np.concatenate(pixels, axis=2),
            photometric="rgb",
            extrasamples=[kind],
        )
    plain, divided = (
        read_photograph(tmp_path / f"{kind}.tif") for kind in ("unassalpha", "assocalpha")
    )
    np.testing.assert_allclose(divided, plain, atol=1e-4)


@pytest.mark.parametrize(
    ("pixels", "options", "message"),
    [
        (np.zeros((4, 4, 2), np.uint8), {"extrasamples": ["unassalpha"]}, "grey and alpha"),
        (np.zeros((3, 4, 4), np.uint8), {"planarconfig": "separate"}, "a plane for each channel"),
    ],
)
def test_a_tiff_of_another_kind_is_refused_by_what_it_has(
    tmp_path: Path, pixels: np.ndarray, options: dict[str, object], message: str
) -> None:
    kind = "minisblack" if pixels.shape[-1] == 2 else "rgb"
    tifffile.imwrite(tmp_path / "a.tif", pixels, photometric=kind, **options)  # type: ignore[arg-type]
    with pytest.raises(InputError, match=f"is a TIFF with {message}; save it"):
        read_photograph(tmp_path / "a.tif")


@pytest.mark.parametrize(
    ("number", "name"), [(7, "JPEG"), (50_000, "Zstandard"), (50_001, "WebP"), (34_925, "LZMA")]
)
def test_a_compression_that_is_not_read_is_named(tmp_path: Path, number: int, name: str) -> None:
    tifffile.imwrite(tmp_path / "a.tif", np.zeros((4, 4, 3), np.uint8), photometric="rgb")
    whole = (tmp_path / "a.tif").read_bytes()
    entry = struct.pack("<HHIHH", 259, 3, 1, 1, 0)
    assert whole.count(entry) == 1
    changed = whole.replace(entry, struct.pack("<HHIHH", 259, 3, 1, number, 0))
    (tmp_path / "a.tif").write_bytes(changed)
    with pytest.raises(InputError, match=rf"compression {number} \({name}\); save it uncompressed"):
        read_photograph(tmp_path / "a.tif")
