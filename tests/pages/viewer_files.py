"""Files as people drop them onto the viewer, whole ones and, by a seed, damaged ones.

`python -m tests.pages.viewer_files 500` drops so many damaged files and links onto the page.
"""

from __future__ import annotations

import random
import struct
import sys
import zlib
from collections.abc import Callable
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import NamedTuple

import numpy as np
from playwright.sync_api import Page

import nacreous as nc
from nacreous import _core
from nacreous.viewer import fragment


class Dropped(NamedTuple):
    """A file's name and bytes."""

    name: str
    content: bytes


SPECTRUM = "nm,power\n" + "".join(f"{nm},{1 + (nm - 380) / 100}\n" for nm in range(380, 781, 5))
PEARL = '[nacre]\npreset = "akoya"\nharvest = "12-15"\n'


def panorama(width: int = 16, height: int = 8) -> bytes:
    """A Radiance file: bright above, dim and reddish below."""
    pixels = b"".join(
        bytes([200 - 20 * row, 180 - 20 * row, 160 - 20 * row, 129])
        for row in range(height)
        for _ in range(width)
    )
    return b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n" + b"-Y %d +X %d\n" % (height, width) + pixels


def photograph(side_px: int = 240) -> bytes:
    """A photograph of grain: a pearl with waves of some frequencies, on black."""
    step = np.arange(side_px)
    waves = 0.03 * np.sin(step[None] * 0.9) + 0.02 * np.cos(step[:, None] * 0.7 + step[None] * 0.3)
    light = (0.6 + waves)[..., None] * np.array([0.95, 0.85, 0.8])
    middle = (side_px - 1) / 2
    light[np.hypot(step - middle, step[:, None] - middle) > 0.46 * side_px] = 0.02
    codes, _ = _core.develop(light.astype(np.float32), "srgb", "clip", 8)
    return _core.png_bytes(codes, "srgb", [])


def rendered(suffix: str, size: int = 32) -> bytes:
    """A picture of ours, with its recipe."""
    with TemporaryDirectory() as folder:
        path = Path(folder, f"a{suffix}")
        nc.render("akoya-g", "booth", size=size, samples=1).save(path)
        return path.read_bytes()


@cache
def whole() -> dict[str, bytes]:
    """One of each kind, by the ending of its name."""
    return {
        ".toml": PEARL.encode(),
        ".csv": SPECTRUM.encode(),
        ".hdr": panorama(),
        ".png": rendered(".png"),
        ".exr": rendered(".exr"),
    }


def _cut(rng: random.Random, content: bytes) -> bytes:
    return content[: rng.randrange(len(content))]


def _changed(rng: random.Random, content: bytes) -> bytes:
    made = bytearray(content)
    reach = len(made) if rng.random() < 0.4 else min(len(made), 400)
    for _ in range(rng.choice([1, 3, 30])):
        made[rng.randrange(reach)] = rng.randrange(256)
    return bytes(made)


def _other_kind(rng: random.Random, _content: bytes) -> bytes:
    return rng.choice(list(whole().values()))


def _noise(rng: random.Random, _content: bytes) -> bytes:
    return rng.randbytes(rng.choice([1, 7, 4000]))


def _not_utf8(rng: random.Random, content: bytes) -> bytes:
    at = rng.randrange(len(content) + 1)
    return content[:at] + rng.choice([b"\xff\xfe", b"\xc3\x28", b"\x00", b"\x80"]) + content[at:]


def _huge(rng: random.Random, _content: bytes) -> bytes:
    """Small files that say they are large, and one that is."""
    header = struct.pack(">IIBBBBB", 60_000, 60_000, 8, 2, 0, 0, 0)
    chunk = struct.pack(">I", 13) + b"IHDR" + header
    chunk += struct.pack(">I", zlib.crc32(b"IHDR" + header))
    claims = [
        b"\x89PNG\r\n\x1a\n" + chunk,
        b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 900000 +X 900000\n" + b"\0" * 99,
        b"# much\n" * 400_000,
        b"",
    ]
    return rng.choice(claims)


_DAMAGE: list[Callable[[random.Random, bytes], bytes]] = [
    *(_cut, _changed, _changed, _other_kind, _noise, _not_utf8, _huge)
]


def damaged(seed: int) -> Dropped:
    """A damaged file."""
    rng = random.Random(seed)
    ending = rng.choice(list(whole()))
    return Dropped(f"damaged-{seed}{ending}", rng.choice(_DAMAGE)(rng, whole()[ending]))


def link() -> str:
    """A whole fragment of an address, of a pearl with a knob turned."""
    pearl = nc.Pearl.load("akoya-g")
    return fragment(pearl.replace(depth=0.31), nc.Scene.load("booth"))


def damaged_link(seed: int, whole_link: str) -> str:
    """A damaged fragment of an address."""
    rng = random.Random(seed)
    made = list(whole_link)
    for _ in range(rng.choice([1, 3, 20])):
        made[rng.randrange(len(made))] = rng.choice("AZaz09-_.#%é ")
    return "".join(made[: rng.randrange(2, len(made))] if rng.random() < 0.5 else made)


#: Opens files; how many times the page has opened any is told by the page itself.
OPENINGS = "document.querySelector('.page').dataset.openings"


def drop(page: Page, *files: Dropped) -> None:
    """Open files by the page's own picker, and wait until they were read."""
    before = page.evaluate(OPENINGS)
    payload = [
        {"name": name, "mimeType": "application/octet-stream", "buffer": content}
        for name, content in files
    ]
    page.set_input_files("input[type=file]", payload)
    page.wait_for_function(f"before => {OPENINGS} !== before", arg=before)


def follow(page: Page, to: str) -> None:
    """Go to a fragment of the page's address."""
    before = page.evaluate(OPENINGS)
    page.evaluate("to => { location.hash = to; }", to)
    page.wait_for_function(f"before => {OPENINGS} !== before", arg=before)


def shown(page: Page) -> str:
    """The pearl and scene that the page has."""
    page.evaluate("new Promise(done => setTimeout(done, 0))")
    return str(page.input_value("[data-key='depth'] .typed input"))


def survives(page: Page, seed: int, whole_link: str) -> str:
    """Drop a damaged file or follow a damaged link; one message, if any. Gives that."""
    before = shown(page)
    if seed % 5 == 0:
        follow(page, damaged_link(seed, whole_link))
    else:
        drop(page, damaged(seed))
    alerts = page.locator(".message.wrong")
    told = alerts.inner_text() if alerts.count() else ""
    assert alerts.count() <= 1
    assert not told or "damaged-" in told or "link" in told, (seed, told)
    assert page.locator(".failed").count() == 0, (seed, page.locator(".failed").inner_text())
    if told:
        assert shown(page) == before, seed
    if page.locator("dialog.opened").count():
        page.keyboard.press("Escape")
        page.locator("dialog.opened").wait_for(state="detached")
    elif told:
        page.click(".message.wrong button")
    return told


def main(count: int) -> None:
    """Drop so many damaged files, and say what was told how often."""
    from tests.pages.browser import chromium, guarded
    from tests.pages.viewer_host import hosted

    refused = 0
    with hosted() as url, chromium() as browser, guarded(browser, url) as guard:
        page = guard.open("/?lang=en").page
        page.locator(".pearl[data-stage=refined]").wait_for()
        for seed in range(count):
            refused += bool(survives(page, seed, link()))
        page.locator(".pearl[data-stage=refined]").wait_for()
    print(f"{count} damaged files and links: {refused} refused in one message, the others read")


if __name__ == "__main__":
    main(int(sys.argv[1]))
