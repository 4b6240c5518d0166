"""Pictures that are written, read by independent peers: Pillow and littleCMS, OpenEXR."""

import io
import struct
import subprocess
import sys
import time
import zlib
from pathlib import Path

import numpy as np
import OpenEXR
import pytest
from PIL import Image, ImageCms

from nacreous import _core
from nacreous.file import read_png_text
from nacreous.problem import InputError
from tests.file.pixels import converted, gradient


@pytest.mark.parametrize("space", ["srgb", "display-p3"])
def test_pillow_reads_every_pixel_profile_and_text(tmp_path: Path, space: str) -> None:
    pixels = gradient(np.uint8)
    text = [("Software", "nacreous 0.1"), ("nacreous:spec", "seed = 7 # 真珠\n" * 50)]
    _core.write_png(tmp_path / "a.png", pixels, space, text)
    with Image.open(tmp_path / "a.png") as picture:
        picture.load()
        np.testing.assert_array_equal(np.asarray(picture), pixels)
        assert picture.mode == "RGB"
        assert dict(picture.text) == dict(text)
        profile = ImageCms.ImageCmsProfile(io.BytesIO(picture.info["icc_profile"]))
    assert (
        ImageCms.getProfileDescription(profile).strip()
        == {
            "srgb": "sRGB IEC61966-2.1",
            "display-p3": "Display P3",
        }[space]
    )
    assert read_png_text(tmp_path / "a.png") == dict(text)


@pytest.mark.parametrize("intent", list(ImageCms.Intent))
def test_our_srgb_profile_is_the_identity_for_littlecms(
    tmp_path: Path, intent: ImageCms.Intent
) -> None:
    pixels = gradient(np.uint8, 120, 120)
    assert np.abs(converted("srgb", pixels, tmp_path, intent) - pixels).max() <= 1


def test_our_display_p3_profile_says_p3_to_littlecms(tmp_path: Path) -> None:
    # CSS Color Module Level 4: sRGB red is color(display-p3 0.91749 0.20029 0.13856).
    pixels = np.array([[[234, 51, 35], [128, 128, 128], [255, 255, 255]]], np.uint8)
    shown = converted("display-p3", pixels, tmp_path)[0]
    np.testing.assert_allclose(shown, [[255, 0, 0], [128] * 3, [255] * 3], atol=3)


def test_sixteen_bits_stand_in_the_file(tmp_path: Path) -> None:
    # Pillow cannot read 16-bit RGB; the chunks are taken apart by hand. (The Rust tests compare
    # all samples through another reader.)
    pixels = np.full((1, 2, 3), 0x1234, np.uint16)
    _core.write_png(tmp_path / "a.png", pixels, "srgb", [])
    data = (tmp_path / "a.png").read_bytes()
    assert struct.unpack(">IIBB", data[16:26]) == (2, 1, 16, 2)
    start = data.index(b"IDAT") + 4
    rows = zlib.decompress(
        data[start : start + struct.unpack(">I", data[start - 8 : start - 4])[0]]
    )
    # The row as it stands (filter 0) or its differences from the left (1: Sub, 4: Paeth).
    differences = b"\x12\x34" * 3 + bytes(6)
    assert rows in {b"\0" + b"\x12\x34" * 6, b"\1" + differences, b"\4" + differences}


def test_a_view_with_strides_is_written_as_seen(tmp_path: Path) -> None:
    pixels = gradient(np.uint8)[::-1, ::2]
    _core.write_png(tmp_path / "a.png", pixels, "srgb", [])
    with Image.open(tmp_path / "a.png") as picture:
        np.testing.assert_array_equal(np.asarray(picture), pixels)


@pytest.mark.parametrize(
    ("pixels", "space", "text", "message"),
    [
        (
            np.zeros((2, 2, 3), np.float32),
            "srgb",
            [],
            r"float32 of shape \[2, 2, 3\]; allowed: uint8",
        ),
        (np.zeros((2, 2), np.uint8), "srgb", [], r"uint8 of shape \[2, 2\]; allowed: uint8"),
        (
            np.zeros((2, 2, 5), np.uint8),
            "srgb",
            [],
            r"shape \[2, 2, 5\]; allowed: \[row, column, 3 or 4",
        ),
        (np.zeros((0, 2, 3), np.uint8), "srgb", [], r"shape \[0, 2, 3\]"),
        ([[1]], "srgb", [], r"no array but <class 'list'>"),
        (np.zeros((2, 2, 3), np.uint8), "aces", [], r'"aces"; allowed: srgb, display-p3'),
        (np.zeros((2, 2, 3), np.uint8), "srgb", [("é", "")], "printable ASCII"),
    ],
)
def test_pixels_that_no_png_holds(
    tmp_path: Path, pixels: object, space: str, text: list[tuple[str, str]], message: str
) -> None:
    with pytest.raises(InputError, match=message):
        _core.write_png(tmp_path / "a.png", pixels, space, text)  # type: ignore[arg-type]


def test_openexr_reads_every_bit_name_and_attribute(tmp_path: Path) -> None:
    rng = np.random.default_rng(7)
    planes = [
        ("", rng.normal(size=(21, 33, 4)).astype(np.float32)),
        ("interference", np.exp(rng.normal(0, 20, (21, 33, 3))).astype(np.float32)),
        ("texture", np.full((21, 33, 1), -0.0, np.float32)),
    ]
    text = [("Software", "nacreous"), ("nacreous:seed", "7"), ("nacreous:spec", "名 = 'pearl'")]
    _core.write_exr(tmp_path / "a.exr", planes, text)
    own = {("", 4): "RGBA", ("interference", 3): "RGB", ("texture", 1): "Y"}
    written = {
        f"{name}.{letter}".lstrip("."): plane[..., index]
        for name, plane in planes
        for index, letter in enumerate(own[name, plane.shape[2]])
    }
    with OpenEXR.File(str(tmp_path / "a.exr"), separate_channels=True) as file:
        assert len(file.parts) == 1
        header, channels = file.header(), file.channels()
        assert set(channels) == set(written)
        for name, expected in written.items():
            found = channels[name].pixels
            assert found.dtype == np.float32
            np.testing.assert_array_equal(found.view(np.uint32), expected.copy().view(np.uint32))
        assert header["compression"] == OpenEXR.ZIP_COMPRESSION
        rec709 = (0.64, 0.33, 0.30, 0.60, 0.15, 0.06, 0.3127, 0.3290)
        np.testing.assert_allclose(header["chromaticities"], rec709, rtol=1e-6)
        assert {key: header[key] for key, _ in text} == dict(text)


def test_equal_pictures_have_equal_bytes_in_every_process(tmp_path: Path) -> None:
    program = (
        "import sys, numpy as np; from nacreous import _core;"
        "text = [(f'k{n}', 'v') for n in range(9)];"
        "_core.write_png(sys.argv[1] + '.png', np.zeros((9, 9, 3), np.uint16), 'srgb', text);"
        "_core.write_exr(sys.argv[1] + '.exr', [('', np.zeros((99, 9, 3), np.float32))], text)"
    )
    for run in ("first", "second"):
        subprocess.run([sys.executable, "-c", program, str(tmp_path / run)], check=True)
        time.sleep(1.1)  # past the next second, which a timestamp would show
    for ending in (".png", ".exr"):
        first, second = (tmp_path / f"{run}{ending}" for run in ("first", "second"))
        assert first.read_bytes() == second.read_bytes()


def test_planes_that_no_exr_holds(tmp_path: Path) -> None:
    main = ("", np.zeros((2, 3, 3), np.float32))
    wrong = [
        ([], "is missing"),
        (
            [main, ("a", np.zeros((3, 2, 3), np.float32))],
            "3 rows of 2 pixels; allowed: 2 rows of 3",
        ),
        ([main, ("a", np.zeros((2, 3, 3)))], r"float64 of shape \[2, 3, 3\]; allowed: float32"),
        ([main, ("a", np.zeros((2, 3, 2), np.float32))], "1, 3 or 4 channels"),
        (
            [main, ("a", np.full((2, 3, 1), np.nan, np.float32))],
            "holds 6 values that are not finite",
        ),
    ]
    for planes, message in wrong:
        with pytest.raises(InputError, match=message):
            _core.write_exr(tmp_path / "a.exr", planes, [])
