"""Photographs and panoramas of independent peers, read; and what is no picture."""

import io
import os
import resource
import struct
import subprocess
import sys
import zlib
from pathlib import Path

import numpy as np
import OpenEXR
import pytest
import tifffile
from PIL import Image, ImageOps, PngImagePlugin

from nacreous import _core
from nacreous.file import read_panorama, read_photograph, read_png_text
from nacreous.problem import InputError
from tests.file.pixels import converted, gradient

LIMITS = "allowed: 1 to 16384 a side and at most 67108864 pixels in all"


def light(encoded: np.ndarray) -> np.ndarray:
    """IEC 61966-2-1, written down a second time."""
    code = encoded / np.iinfo(encoded.dtype).max
    return np.where(code <= 0.04045, code / 12.92, ((code + 0.055) / 1.055) ** 2.4)


def chunk(name: bytes, data: bytes) -> bytes:
    return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))


def bomb(side: int) -> bytes:
    """A whole 1-bit grey PNG of `side` black pixels squared: 50 kB for 20000."""
    pixels = zlib.compress(bytes(side * (1 + (side + 7) // 8)), 9)
    header = struct.pack(">IIBBBBB", side, side, 1, 0, 0, 0, 0)
    parts = chunk(b"IHDR", header) + chunk(b"IDAT", pixels) + chunk(b"IEND", b"")
    return b"\x89PNG\r\n\x1a\n" + parts


@pytest.mark.parametrize("mode", ["L", "RGB", "RGBA", "P", "1"])
def test_an_8_bit_png_is_decoded_as_srgb(tmp_path: Path, mode: str) -> None:
    picture = Image.fromarray(gradient(np.uint8)).convert(mode)
    picture.save(tmp_path / "a.png")
    found = read_photograph(tmp_path / "a.png")
    assert found.dtype == np.float32
    np.testing.assert_allclose(found, light(np.asarray(picture.convert("RGB"))), atol=1e-7)


@pytest.mark.parametrize("dtype", [np.uint8, np.uint16])
@pytest.mark.parametrize("compression", [None, "zlib"])
def test_tiff_of_tifffile_is_decoded_as_srgb(
    tmp_path: Path, dtype: type, compression: str | None
) -> None:
    pixels = gradient(dtype)
    tifffile.imwrite(tmp_path / "a.tif", pixels, photometric="rgb", compression=compression)
    np.testing.assert_allclose(read_photograph(tmp_path / "a.tif"), light(pixels), atol=1e-7)
    tifffile.imwrite(tmp_path / "grey.tif", pixels[..., 0], photometric="minisblack")
    grey = np.repeat(pixels[..., :1], 3, axis=2)
    np.testing.assert_allclose(read_photograph(tmp_path / "grey.tif"), light(grey), atol=1e-7)


def test_a_jpeg_agrees_with_pillow(tmp_path: Path) -> None:
    row, column = np.mgrid[:64, :80]
    pixels = np.stack([row * 3, column * 3, row + column], axis=2).astype(np.uint8)
    Image.fromarray(pixels).save(tmp_path / "a.jpg", quality=95)
    with Image.open(tmp_path / "a.jpg") as picture:
        peer = light(np.asarray(picture.convert("RGB")))
    # Decoders may round the cosine transform differently by a code or two.
    np.testing.assert_allclose(read_photograph(tmp_path / "a.jpg"), peer, atol=0.02)


def test_the_orientation_of_the_camera_is_applied(tmp_path: Path) -> None:
    pixels = np.zeros((16, 32, 3), np.uint8)
    pixels[:8, :8] = 255
    picture = Image.fromarray(pixels)
    exif = picture.getexif()
    exif[0x0112] = 6  # to be turned right
    picture.save(tmp_path / "a.jpg", exif=exif, quality=100)
    with Image.open(tmp_path / "a.jpg") as saved:
        upright = light(np.asarray(ImageOps.exif_transpose(saved)))
    found = read_photograph(tmp_path / "a.jpg")
    assert found.shape == (32, 16, 3)
    np.testing.assert_allclose(found, upright, atol=0.02)


def test_an_embedded_profile_is_honoured_as_littlecms_does(tmp_path: Path) -> None:
    pixels = gradient(np.uint8)
    _core.write_png(tmp_path / "p3.png", pixels, "display-p3", [])
    shown = light(converted("display-p3", pixels, tmp_path).astype(np.uint8))
    # An 8-bit code of the peer is up to 0.009 of light, where light is brightest.
    np.testing.assert_allclose(read_photograph(tmp_path / "p3.png"), shown, atol=0.012)


def test_an_exr_of_openexr_is_read_bit_by_bit(tmp_path: Path) -> None:
    rgb = np.exp(np.random.default_rng(3).normal(0, 3, (16, 32, 3))).astype(np.float32)
    for kind in (OpenEXR.PIZ_COMPRESSION, OpenEXR.ZIPS_COMPRESSION, OpenEXR.RLE_COMPRESSION):
        header = {"compression": kind, "type": OpenEXR.scanlineimage}
        OpenEXR.File(header, {"RGB": rgb}).write(str(tmp_path / "sky.exr"))
        np.testing.assert_array_equal(read_panorama(tmp_path / "sky.exr"), rgb)


def test_our_own_exr_is_a_panorama(tmp_path: Path) -> None:
    rgb = np.random.default_rng(3).random((8, 16, 3)).astype(np.float32) * 100
    _core.write_exr(tmp_path / "sky.exr", [("", rgb), ("a", rgb[..., :1].copy())], [])
    np.testing.assert_array_equal(read_panorama(tmp_path / "sky.exr"), rgb)


def test_a_cropped_or_colourless_exr_is_refused(tmp_path: Path) -> None:
    header = {"compression": OpenEXR.ZIP_COMPRESSION, "type": OpenEXR.scanlineimage}
    OpenEXR.File(header, {"Z": np.ones((4, 8), np.float32)}).write(str(tmp_path / "z.exr"))
    with pytest.raises(InputError, match=r"z.exr: has no channels R, G and B"):
        read_panorama(tmp_path / "z.exr")
    header["displayWindow"] = (np.array([0, 0], np.int32), np.array([31, 31], np.int32))
    OpenEXR.File(header, {"RGB": np.ones((4, 8, 3), np.float32)}).write(str(tmp_path / "c.exr"))
    with pytest.raises(InputError, match=r"c.exr: is cropped"):
        read_panorama(tmp_path / "c.exr")


def test_infinite_light_is_refused(tmp_path: Path) -> None:
    rgb = np.ones((4, 8, 3), np.float32)
    rgb[2, 5, 1] = np.inf
    header = {"compression": OpenEXR.ZIP_COMPRESSION, "type": OpenEXR.scanlineimage}
    OpenEXR.File(header, {"RGB": rgb}).write(str(tmp_path / "sun.exr"))
    message = r"1 values that are not finite, the first at row 2, column 5, channel 1"
    with pytest.raises(InputError, match=message):
        read_panorama(tmp_path / "sun.exr")


def jpeg() -> bytes:
    file = io.BytesIO()
    Image.fromarray(gradient(np.uint8, 200, 200)).save(file, "JPEG")
    return file.getvalue()


@pytest.mark.parametrize("read", [read_photograph, read_panorama, read_png_text])
def test_every_reader_names_file_and_problem(tmp_path: Path, read: object) -> None:
    allowed = {
        "read_photograph": "PNG, JPEG, TIFF",
        "read_panorama": r"Radiance \(.hdr\), OpenEXR \(.exr\)",
        "read_png_text": "PNG",
    }[read.__name__]  # type: ignore[attr-defined]
    (tmp_path / "notes.png").write_text("Once upon a time there was a pearl.\n" * 9)
    (tmp_path / "empty.png").touch()
    os.mkfifo(tmp_path / "pipe.png")
    for name, message in [
        ("notes.png", rf"notes.png: is not a picture that can be read here; allowed: {allowed}$"),
        ("empty.png", r"empty.png: is empty \(0 bytes\)$"),
        (".", r": is a directory; a picture file is needed$"),
        ("missing.png", r"missing.png: does not exist$"),
        ("pipe.png", r"pipe.png: is not an ordinary file$"),
    ]:
        with pytest.raises(InputError, match=message):
            read(tmp_path / name)  # type: ignore[operator]


def test_a_truncated_picture_is_refused(tmp_path: Path) -> None:
    whole = jpeg()
    for length in (len(whole) - 2, len(whole) // 2, 100, 3):
        (tmp_path / "a.jpg").write_bytes(whole[:length])
        with pytest.raises(InputError, match=r"a.jpg: is damaged or cut short \(.+\)$"):
            read_photograph(tmp_path / "a.jpg")


def test_a_cmyk_jpeg_is_refused(tmp_path: Path) -> None:
    Image.fromarray(gradient(np.uint8)).convert("CMYK").save(tmp_path / "a.jpg")
    with pytest.raises(InputError, match=r"has CMYK pixels.*; save it as RGB$"):
        read_photograph(tmp_path / "a.jpg")


def huge_radiance() -> bytes:
    return b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 12220 +X 16384\n" + bytes(999)


def huge_exr(path: Path) -> bytes:
    """A small file whose header says 16384 x 12220."""
    header = {"compression": OpenEXR.ZIP_COMPRESSION, "type": OpenEXR.scanlineimage}
    OpenEXR.File(header, {"RGB": np.zeros((4, 8, 3), np.float32)}).write(str(path))
    small, huge = (struct.pack("<4i", 0, 0, x, y) for x, y in ((7, 3), (16383, 12219)))
    return path.read_bytes().replace(small, huge)


@pytest.mark.parametrize("ending", [".hdr", ".exr"])
def test_a_panorama_of_200_megapixels_is_refused_by_its_header(tmp_path: Path, ending: str) -> None:
    path = tmp_path / f"sky{ending}"
    path.write_bytes(huge_radiance() if ending == ".hdr" else huge_exr(path))
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    with pytest.raises(InputError, match=rf"sky{ending}: is 16384 x 12220 pixels; {LIMITS}"):
        read_panorama(path)
    assert resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before < 50_000


def test_a_huge_png_is_refused_fast_and_in_little_memory(tmp_path: Path) -> None:
    (tmp_path / "bomb.png").write_bytes(bomb(20_000))
    program = (
        "import resource, sys, time; from nacreous.file import read_photograph;"
        "from nacreous.problem import InputError;"
        "before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss; start = time.perf_counter()\n"
        "try: read_photograph(sys.argv[1])\n"
        "except InputError as problem: print(problem)\n"
        "grown = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before\n"
        "assert time.perf_counter() - start < 0.5 and grown < 4096, grown"
    )
    command = [sys.executable, "-c", program, str(tmp_path / "bomb.png")]
    told = subprocess.run(command, check=True, capture_output=True, text=True).stdout.strip()
    assert told == f"{tmp_path}/bomb.png: is 20000 x 20000 pixels; {LIMITS}"


def test_a_huge_file_is_refused_unread(tmp_path: Path) -> None:
    with (tmp_path / "long.tif").open("wb") as stream:
        stream.truncate(2**29 + 1)
    message = r"is 536870913 bytes long; allowed: at most 536870912$"
    with pytest.raises(InputError, match=message):
        read_photograph(tmp_path / "long.tif")


def test_texts_of_pillow_are_read_wherever_they_stand(tmp_path: Path) -> None:
    info = PngImagePlugin.PngInfo()
    info.add_text("plain", "größe")
    info.add_text("packed", "lustre " * 500, zip=True)
    info.add_itxt("wide", "真珠", zip=True)
    Image.new("RGB", (4, 4)).save(tmp_path / "a.png", pnginfo=info)
    data = (tmp_path / "a.png").read_bytes()
    late = data[:-12] + chunk(b"tEXt", b"late\0behind the pixels") + data[-12:]
    (tmp_path / "a.png").write_bytes(late)
    assert read_png_text(tmp_path / "a.png") == {
        "plain": "größe",
        "late": "behind the pixels",
        "packed": "lustre " * 500,
        "wide": "真珠",
    }
