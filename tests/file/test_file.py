"""Picture files against independent peers: Pillow and littleCMS, tifffile, OpenEXR."""

import io
import os
import resource
import signal
import stat
import struct
import subprocess
import sys
import time
import zlib
from pathlib import Path

import numpy as np
import OpenEXR
import pytest
import tifffile
from PIL import Image, ImageCms, ImageOps, PngImagePlugin

from nacreous import _core
from nacreous.file import atomic, check_output, read_panorama, read_photograph, read_png_text
from nacreous.problem import InputError

LIMITS = "allowed: 1 to 16384 a side and at most 67108864 pixels in all"


def gradient(dtype: type, height: int = 37, width: int = 53) -> np.ndarray:
    row, column, channel = np.ogrid[:height, :width, :3]
    return ((row * 1009 + column * 461 + channel * 13007) % (np.iinfo(dtype).max + 1)).astype(dtype)


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


def names(folder: Path) -> list[str]:
    return sorted(entry.name for entry in folder.iterdir())


# --- PNG out


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


# --- EXR out


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


# --- photographs in


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


# --- panoramas in


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


# --- what is no picture


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


# --- whole or absent


def test_the_new_file_replaces_the_old_and_nothing_else_stays(tmp_path: Path) -> None:
    target = tmp_path / "pearl.png"
    target.write_text("old")
    target.chmod(0o640)
    with atomic(target) as temporary:
        assert temporary.parent == tmp_path
        assert temporary.suffix == ".png"
        temporary.write_text("new")
        assert target.read_text() == "old"
    assert target.read_text() == "new"
    assert stat.S_IMODE(target.stat().st_mode) == 0o640
    assert names(tmp_path) == ["pearl.png"]


def test_a_new_file_has_the_permissions_of_the_umask(tmp_path: Path) -> None:
    before = os.umask(0o027)
    try:
        with atomic(tmp_path / "a.txt") as temporary:
            temporary.write_text("new")
    finally:
        os.umask(before)
    assert stat.S_IMODE((tmp_path / "a.txt").stat().st_mode) == 0o640


@pytest.mark.parametrize("kind", [RuntimeError, KeyboardInterrupt, SystemExit])
def test_an_exception_leaves_the_old_file(tmp_path: Path, kind: type[BaseException]) -> None:
    target = tmp_path / "pearl.png"
    target.write_text("old")
    with pytest.raises(kind), atomic(target) as temporary:  # noqa: PT012
        temporary.write_text("half")
        raise kind
    assert target.read_text() == "old"
    assert names(tmp_path) == ["pearl.png"]


def test_kill_9_leaves_the_old_file(tmp_path: Path) -> None:
    target = tmp_path / "pearl.png"
    target.write_text("old")
    program = (
        "import sys, time; from nacreous.file import atomic\n"
        "with atomic(sys.argv[1]) as temporary:\n"
        "    temporary.write_text('half'); print('written', flush=True); time.sleep(60)"
    )
    command = [sys.executable, "-c", program, str(target)]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        assert process.stdout.readline() == "written\n"
        process.send_signal(signal.SIGKILL)
    assert target.read_text() == "old"


def test_a_full_disk_is_one_message_and_leaves_the_old_file(tmp_path: Path) -> None:
    target = tmp_path / "pearl.exr"
    target.write_text("old")
    program = (
        "import resource, sys, numpy as np; from nacreous import _core\n"
        "from nacreous.file import atomic; from nacreous.problem import InputError\n"
        "plane = np.random.default_rng(1).random((64, 64, 3)).astype(np.float32)\n"
        "resource.setrlimit(resource.RLIMIT_FSIZE, (4096, 4096))\n"
        "try:\n"
        "    with atomic(sys.argv[1]) as temporary: _core.write_exr(temporary, [('', plane)], [])\n"
        "except InputError as problem: print(problem)"
    )
    command = [sys.executable, "-c", program, str(target)]
    told = subprocess.run(command, check=True, capture_output=True, text=True).stdout.strip()
    assert told == f"{target}: cannot be written (File too large)"
    assert target.read_text() == "old"
    assert names(tmp_path) == ["pearl.exr"]


def test_an_error_about_another_file_stays_what_it_is(tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError), atomic(tmp_path / "a.txt"):
        (tmp_path / "missing").read_text()
    assert names(tmp_path) == []


def test_a_link_keeps_pointing_and_its_file_is_replaced(tmp_path: Path) -> None:
    (tmp_path / "real.txt").write_text("old")
    (tmp_path / "link.txt").symlink_to("real.txt")
    with atomic(tmp_path / "link.txt") as temporary:
        temporary.write_text("new")
    assert (tmp_path / "link.txt").is_symlink()
    assert (tmp_path / "real.txt").read_text() == "new"


def test_outputs_that_cannot_be_are_refused_before_and_during(tmp_path: Path) -> None:
    (tmp_path / "folder.png").mkdir()
    (tmp_path / "note").touch()
    for path, message in [
        (tmp_path / "folder.png", r"folder.png: is a folder; allowed: a file in it, by its name$"),
        (tmp_path / "missing" / "a.png", r"a.png: the folder .*missing does not exist$"),
        (tmp_path / "note" / "a.png", r"a.png: the folder .*note does not exist$"),
        (Path("/proc/a.png"), r"^/proc/a.png: cannot be written \(.+\)$"),
        (tmp_path / ("n" * 300 + ".png"), r"cannot be written \(File name too long\)$"),
    ]:
        with pytest.raises(InputError, match=message):
            check_output(path, [".png"])
        with pytest.raises(InputError, match=message), atomic(path):
            pytest.fail("the body must not run")
    with (
        pytest.raises(InputError, match=r"^/dev/null: is not an ordinary file"),
        atomic("/dev/null"),
    ):
        pytest.fail("the body must not run")


def test_an_unknown_ending_is_refused_with_the_allowed_ones(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"a.tiff: the ending is .tiff; allowed: .png, .exr$"):
        check_output(tmp_path / "a.tiff", [".png", ".exr"])
    with pytest.raises(InputError, match=r"/a: the ending is missing; allowed: .png$"):
        check_output(tmp_path / "a", [".png"])
    assert check_output(tmp_path / "A.PNG", [".png"]) == tmp_path / "A.PNG"
    assert names(tmp_path) == []
