"""Files on the viewer: dropped, opened, saved, and damaged ones."""

from __future__ import annotations

import gzip
import json
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import OpenEXR
import pytest
from playwright.sync_api import Browser, Page, expect

import nacreous as nc
from nacreous import _core
from nacreous.embedded import read_embedded
from nacreous.file import read_panorama
from nacreous.viewer import FOLDER
from tests.pages.browser import Guarded, guarded, violations
from tests.pages.viewer_files import (
    SPECTRUM,
    Dropped,
    drop,
    link,
    panorama,
    photograph,
    rendered,
    survives,
)

SIDE_PX = 256
DONE = f".pearl[data-stage=refined][width='{SIDE_PX}']"
SAMPLE = 40
#: What a page may weigh before anything is asked of it, by gzip.
MOST_BYTES = 1_500_000
expect.set_options(timeout=60_000)  # machines that test are busy

#: The codes on a canvas, as numbers.
CODES = """canvas => Array.from(
    canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data)"""


@pytest.fixture(scope="module")
def visitor(browser: Browser, host: str) -> Iterator[Guarded]:
    # Chromium would have canvases whose codes a test reads say so beforehand.
    said = "willReadFrequently"
    with guarded(browser, host, said, viewport={"width": 1440, "height": 900}) as guard:
        yield guard


@pytest.fixture
def page(visitor: Guarded) -> Iterator[Page]:
    """The page with its first pearl, in the smallest size."""
    opened = visitor.open("/?lang=en").page
    opened.locator(".facts select").select_option(str(SIDE_PX))
    opened.locator(DONE).wait_for()
    yield opened
    opened.close()


def picture(page: Page) -> np.ndarray:
    """The codes of the finished picture."""
    page.locator(DONE).wait_for()
    return np.array(page.eval_on_selector(".pearl", CODES)).reshape(SIDE_PX, SIDE_PX, 4)[:, :, :3]


def wrong(page: Page) -> str:
    """What was told of a file, and away with it."""
    line = page.locator(".message.wrong li").inner_text()
    page.click(".message.wrong button")
    return line


def test_dropped_files_make_the_picture_that_the_command_line_makes_of_them(
    page: Page, tmp_path: Path
) -> None:
    files = [("sky.hdr", panorama()), ("wool.png", photograph()), ("lamp.csv", SPECTRUM.encode())]
    for name, content in files:
        (tmp_path / name).write_bytes(content)
    drop(page, *(Dropped(*one) for one in files))
    page.locator(".pearl:not([data-stage=refined])").wait_for()
    shown = picture(page)
    pearl = nc.Pearl.load("akoya-rg", ["texture.source=" + json.dumps(str(tmp_path / "wool.png"))])
    scene = nc.Scene.load(
        "north-window-black",
        [
            'sky.kind="panorama"',
            "sky.path=" + json.dumps(str(tmp_path / "sky.hdr")),
            "windows.0.spectrum=" + json.dumps(str(tmp_path / "lamp.csv")),
        ],
    )
    made = nc.render(pearl, scene, size=SIDE_PX, samples=16).develop()[0]
    apart = np.abs(shown.astype(int) - made)
    assert apart.max() <= 1, (apart.max(), (apart > 1).sum())
    page.locator(".message").get_by_role("button", name="Undo").wait_for()
    page.get_by_role("button", name="Copy link").click()
    expect(page.locator(".message [role=status]")).to_contain_text(
        "without sky.hdr, wool.png, lamp"
    )


def test_files_that_no_key_can_use_are_told_as_by_the_command_line(
    page: Page, tmp_path: Path
) -> None:
    before = picture(page)
    bad = [("a.csv", b"nm,power\n380,1\n"), ("a.hdr", panorama()[:60]), ("a.jpg", b"GIF89a" * 9)]
    readers = [nc.colour.spectrum_from_csv, read_panorama, nc.file.read_photograph]
    for (name, content), reads in zip(bad, readers, strict=True):
        (tmp_path / name).write_bytes(content)
        with pytest.raises(nc.InputError) as said:
            reads(tmp_path / name)
        drop(page, Dropped(name, content))
        assert wrong(page) == str(said.value).replace(str(tmp_path / name), name)
    small = ("small.png", photograph(32))
    drop(page, Dropped(*small))
    assert wrong(page) == (
        "small.png: the photograph has 32 x 32 pixels; allowed: at least side_px = 64 each way"
    )
    np.testing.assert_array_equal(picture(page), before)


def test_spectral_pictures_are_refused_by_name(page: Page, tmp_path: Path) -> None:
    bands = {f"S0.{nm},0nm": np.ones((4, 8), np.float32) for nm in (400, 500)}
    header = {"compression": OpenEXR.ZIP_COMPRESSION, "type": OpenEXR.scanlineimage}
    with OpenEXR.File(header, bands) as file:
        file.write(str(tmp_path / "s.exr"))
    drop(page, Dropped("s.exr", (tmp_path / "s.exr").read_bytes()))
    assert wrong(page).startswith("s.exr: holds spectra (channel S0.400,0nm), which are not read")


def test_saved_layers_are_the_command_lines_and_open_again(page: Page, tmp_path: Path) -> None:
    page.locator(".menu .tool").click()
    with page.expect_download() as offered:
        page.get_by_text("Picture with layers").click()
    offered.value.save_as(tmp_path / "page.exr")
    made = nc.render("akoya-rg", "north-window-black", size=SIDE_PX, samples=16)
    made.save(tmp_path / "own.exr")
    own, ours = (dict(_core.read_exr_text(tmp_path / f"{name}.exr")) for name in ("own", "page"))
    assert json.loads(ours.pop("nacreous:versions")).items() <= (
        json.loads(own.pop("nacreous:versions")).items()
    )
    assert ours == own
    with OpenEXR.File(str(tmp_path / "page.exr"), separate_channels=True) as file:
        channels = {name: one.pixels for name, one in file.channels().items()}
    with OpenEXR.File(str(tmp_path / "own.exr"), separate_channels=True) as file:
        for name, one in file.channels().items():
            np.testing.assert_allclose(channels.pop(name), one.pixels, atol=2e-6)
    assert channels == {}
    drop(page, Dropped("page.exr", (tmp_path / "page.exr").read_bytes()))
    page.select_option("dialog select", "mirror")
    page.focus("dialog canvas")
    page.keyboard.press("Shift+ArrowUp")
    row, column = SIDE_PX // 2 - 10, SIDE_PX // 2
    light = made.layers["mirror"][row, column]
    values = page.locator(".probe-values").inner_text()
    assert " ".join(f"{value:.3g}"[:4] for value in light[:1]) in values
    assert str(row) in values
    assert str(column) in values


def test_a_picture_of_ours_gives_back_its_pearl_and_scene(page: Page) -> None:
    drop(page, Dropped("shell.png", rendered(".png")))
    expect(page.locator("dialog")).to_contain_text("akoya-g, in booth")
    page.get_by_role("button", name="Take its pearl and scene").click()
    expect(page.locator("dialog")).to_have_count(0)
    page.locator(DONE).wait_for()
    made = nc.render("akoya-g", "booth", size=SIDE_PX, samples=16).develop()[0]
    assert np.abs(picture(page).astype(int) - made).max() <= 1


def test_a_saved_png_keeps_its_recipe(page: Page, tmp_path: Path) -> None:
    page.get_by_role("button", name="Save", exact=True).click()
    with page.expect_download() as saving:
        page.get_by_text("Picture (PNG)").click()
    saving.value.save_as(tmp_path / "saved.png")
    kept = read_embedded(tmp_path / "saved.png")
    assert (kept.pearls[0].name, kept.size, kept.samples) == ("akoya-rg", SIDE_PX, 16)
    drop(page, Dropped("saved.png", (tmp_path / "saved.png").read_bytes()))
    expect(page.locator("dialog")).to_contain_text("akoya-rg, in north-window-black")


def test_how_far_apart_two_pearls_look_is_ciede2000_over_their_pixels(page: Page) -> None:
    page.click(".beside")
    page.fill("[data-key='depth'] .typed input", "0.9")
    page.click("#tab-compare")
    expect(page.locator("[data-measure='mean']")).to_be_visible()
    shown = [page.locator(f"[data-measure='{word}']").inner_text() for word in MEASURES]
    first, second = (
        nc.render(nc.Pearl.load("akoya-rg", [f"depth={depth}"]), SCENE, size=SIDE_PX, samples=16)
        for depth in (0.45, 0.9)
    )
    lab = [
        _core.lab_from_xyz(
            _core.xyz_from_rgb(_core.decode_rgb(one.develop()[0] / 255.0), "srgb"), WHITE
        )
        for one in (first, second)
    ]
    apart = np.asarray(_core.delta_e_2000(*lab))
    of_pearl = apart[(first.layers["coverage"] >= 0.5)[..., 0]]
    found = [of_pearl.mean(), np.percentile(of_pearl, 95), of_pearl.max()]
    np.testing.assert_allclose([float(one) for one in shown], found, atol=0.02)


MEASURES = ("mean", "percentile", "largest")
SCENE = "north-window-black"
WHITE = np.asarray(_core.xyz_from_rgb(np.ones(3), "srgb"))


def test_damaged_files_and_links_are_told_once_and_the_picture_stays(page: Page) -> None:
    told = [survives(page, seed, link()) for seed in range(SAMPLE)]
    assert sum(map(bool, told)) > SAMPLE / 2
    page.locator(DONE).wait_for()


# The page itself is looked at in all four ways; windows of pictures need each of them once.
@pytest.mark.parametrize(("language", "width"), [("en", 390), ("ja", 1440)])
def test_opened_pictures_are_in_nobodys_way(
    browser: Browser, host: str, width: int, language: str
) -> None:
    size = {"width": width, "height": 844}
    with guarded(browser, host, viewport=size, bypass_csp=True) as guard:
        page = guard.open(f"/?lang={language}").page
        page.locator(".pearl[data-stage=refined]").wait_for()
        drop(page, Dropped("shell.exr", rendered(".exr", 64)))
        page.focus("dialog canvas")
        page.keyboard.press("ArrowDown")
        assert violations(page) == []
        page.keyboard.press("Escape")
        page.click(".beside")
        page.click("#tab-compare")
        page.locator("[data-measure='mean']").wait_for()
        assert violations(page) == []
        assert page.evaluate("document.documentElement.scrollWidth") <= width


def test_the_page_is_light_and_its_codecs_wait_until_they_are_asked_for(visitor: Guarded) -> None:
    packed = {
        path.name: len(gzip.compress(path.read_bytes(), 9))
        for path in FOLDER.rglob("*")
        if path.is_file()
    }
    codecs = {name for name in packed if name.startswith("nacreous_files")}
    assert sum(size for name, size in packed.items() if name not in codecs) < MOST_BYTES
    assert sum(packed[name] for name in codecs) < MOST_BYTES
    asked: list[str] = []
    visitor.context.on("request", lambda request: asked.append(request.url))
    page = visitor.open("/").page
    page.locator(".pearl[data-stage=refined]").wait_for()
    page.close()
    assert not [url for url in asked if "nacreous_files" in url]
