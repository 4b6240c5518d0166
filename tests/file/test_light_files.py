"""Panoramas and photographs as other programs write them: read, or refused by what they have."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import OpenEXR
import pytest
import tifffile

from nacreous.file import read_panorama, read_photograph
from nacreous.problem import InputError

RNG = np.random.default_rng(5)
LIGHT = RNG.random((4, 8, 3)).astype(np.float32)
OTHER = RNG.random((4, 8, 3)).astype(np.float32)


def exr(path: Path, layers: dict[str, np.ndarray]) -> Path:
    header = {"compression": OpenEXR.ZIP_COMPRESSION, "type": OpenEXR.scanlineimage}
    channels = {
        f"{layer}{letter}": np.ascontiguousarray(pixels[..., i])
        for layer, pixels in layers.items()
        for i, letter in enumerate("RGBA"[: pixels.shape[-1]])
    }
    OpenEXR.File(header, channels).write(str(path))
    return path


@pytest.mark.parametrize(
    "layers",
    [
        {"ViewLayer.Combined.": LIGHT},
        {"ViewLayer.Combined.": LIGHT, "ViewLayer.DiffCol.": OTHER, "ViewLayer.Env.": OTHER},
        {"beauty.": LIGHT},
        {"": LIGHT, "ViewLayer.Combined.": OTHER},
        {"A.": OTHER[..., :2], "sky.": LIGHT},
    ],
    ids=lambda layers: "+".join(layers),
)
def test_the_colours_of_a_layered_exr_are_found(
    tmp_path: Path, layers: dict[str, np.ndarray]
) -> None:
    np.testing.assert_array_equal(read_panorama(exr(tmp_path / "a.exr", layers)), LIGHT)


def test_an_exr_of_several_layers_is_refused_by_their_names(tmp_path: Path) -> None:
    both = exr(tmp_path / "both.exr", {"left.": LIGHT, "right.": OTHER})
    with pytest.raises(
        InputError, match=r'colours in several layers \("left", "right"\); save one'
    ):
        read_panorama(both)
    views = {"A.Combined.": LIGHT, "B.Combined.": OTHER}
    with pytest.raises(InputError, match=r'"A.Combined", "B.Combined"'):
        read_panorama(exr(tmp_path / "views.exr", views))
    with pytest.raises(InputError, match=r'no channels R, G and B, .* but "x.G", "x.R"'):
        read_panorama(exr(tmp_path / "two.exr", {"x.": LIGHT[..., :2]}))


def parts(path: Path, **lights: np.ndarray) -> Path:
    """An OpenEXR file of a part for each light."""
    header = {"compression": OpenEXR.ZIP_COMPRESSION, "type": OpenEXR.scanlineimage}
    made = [
        OpenEXR.Part(
            {**header, "name": name},
            {x: np.ascontiguousarray(light[..., i]) for i, x in enumerate("RGB")},
        )
        for name, light in lights.items()
    ]
    OpenEXR.File(made).write(str(path))
    return path


def test_of_several_parts_the_combined_one_is_taken_or_all_are_refused_by_name(
    tmp_path: Path,
) -> None:
    combined = {"AO": OTHER, "Combined": LIGHT}
    for order in (combined, dict(reversed(combined.items())), {"sky": LIGHT}):
        np.testing.assert_array_equal(read_panorama(parts(tmp_path / "a.exr", **order)), LIGHT)
    with pytest.raises(InputError, match=r'colours in several parts \("one", "two"\); save one'):
        read_panorama(parts(tmp_path / "b.exr", one=LIGHT, two=OTHER))


def test_a_radiance_file_says_what_its_pixels_mean(tmp_path: Path) -> None:
    """Lines end CR LF, the exposure is divided out, rows stand from the lowest up."""
    head = b"#?RGBE\r\nEXPOSURE=4\r\nFORMAT=32-bit_rle_rgbe\r\n\r\n+Y 2 +X 1\r\n"
    (tmp_path / "sky.hdr").write_bytes(head + bytes([128, 64, 32, 129, 128, 128, 128, 131]))
    found = read_panorama(tmp_path / "sky.hdr")
    np.testing.assert_array_equal(found, [[[1.0, 1.0, 1.0]], [[0.25, 0.125, 0.0625]]])


@pytest.mark.parametrize("order", ["<", ">"])
@pytest.mark.parametrize("dtype", [np.uint8, np.uint16])
def test_a_big_tiff_is_a_tiff(tmp_path: Path, dtype: type, order: str) -> None:
    pixels = (LIGHT * np.iinfo(dtype).max).astype(dtype)
    for name, big in (("big.tif", True), ("small.tif", False)):
        tifffile.imwrite(tmp_path / name, pixels, photometric="rgb", bigtiff=big, byteorder=order)
    found = read_photograph(tmp_path / "big.tif")
    np.testing.assert_array_equal(found, read_photograph(tmp_path / "small.tif"))


@pytest.mark.parametrize(
    ("pixels", "message"),
    [
        (LIGHT, "floating-point numbers of 32 bits; save it with 8 or 16"),
        (LIGHT.astype(np.float16), "floating-point numbers of 16 bits"),
        (LIGHT.astype(np.float64), "floating-point numbers of 64 bits"),
        (LIGHT[..., 0].copy(), "floating-point numbers of 32 bits"),
        ((LIGHT * 9e8).astype(np.uint32), "a TIFF with 32 bits a channel"),
        ((LIGHT * 900).astype(np.int16), "signed whole numbers of 16 bits"),
    ],
    ids=["float", "half", "double", "grey", "uint32", "int16"],
)
@pytest.mark.parametrize("big", [False, True], ids=["tiff", "bigtiff"])
def test_a_tiff_of_other_numbers_is_refused_by_them(
    tmp_path: Path, pixels: np.ndarray, message: str, big: bool
) -> None:
    kind = "rgb" if pixels.ndim == 3 else "minisblack"
    tifffile.imwrite(tmp_path / "a.tif", pixels, photometric=kind, bigtiff=big)
    with pytest.raises(InputError, match=rf"a.tif: .*{message}"):
        read_photograph(tmp_path / "a.tif")
