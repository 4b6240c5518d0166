"""How long the viewer takes from the hand to the canvas, in headless Chromium, and how right it is.

    python benchmarks/viewer.py --workers 1
    python benchmarks/viewer.py --lobes 2
    python benchmarks/viewer.py --share
    python benchmarks/viewer.py --pixels

Speed: `akoya-rg`, 64 columns, 512 x 512, on black cloth; medians of ms from the input's event to
the next picture drawn, at rest before each. "refined" is until the whole picture of 16 samples is
drawn. Errors of the first picture against the refined: CIEDE2000 over the pearl, mean and 95th
percentile. `--share` tells how much sooner two workers refine than one, by turns. `--pixels`
compares refined pictures of twelve pearls in all scenes with those of `nacreous.render`, code by
code. The page is that of `./just viewer`. docs/viewer.md has figures.
"""

from __future__ import annotations

import argparse
import statistics
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import numpy as np
from numpy.typing import NDArray
from playwright.sync_api import Browser, Page

import nacreous as nc
from nacreous.colour import decode, delta_e_2000, lab_from_xyz, xyz_from_rgb
from nacreous.viewer import FOLDER
from nacreous.viewer.link import fragment
from tests.pages.browser import chromium
from tests.pages.viewer_host import hosted

RUNS = 15
SIZE_PX = 512
PEARLS = (
    "akoya-rg",
    "akoya-r",
    "akoya-g",
    "akoya-pink",
    "akoya-cream",
    "akoya-dyed-blue",
    "akoya-thin",
    "south-sea-white",
    "south-sea-gold",
    "tahitian",
    "paper",
    "paper-summer-harvest",
)
SCENES = ("north-window-black", "north-window-white", "booth", "aurora", "paper", "two-tier")

#: Sees when pictures are drawn, and keeps their codes.
WATCH = """
const drawn = [];
const put = CanvasRenderingContext2D.prototype.putImageData;
CanvasRenderingContext2D.prototype.putImageData = function (image, ...rest) {
    put.call(this, image, ...rest);
    if (this.canvas.classList.contains("pearl"))
        drawn.push({ at: performance.now(), side: image.width, codes: image.data });
};
Object.assign(globalThis, { drawn });
"""

#: Moves a slider by one step and tells how long the next picture took, and how large it is.
SLIDE = """async ([key, up]) => {
    const slider = document.querySelector(`[data-key="${key}"] input[type=range]`);
    const before = drawn.length, began = performance.now();
    slider.value = String(Number(slider.value) + (up ? 1 : -1) * 20);
    slider.dispatchEvent(new Event("input", { bubbles: true }));
    while (drawn.length === before) await new Promise(requestAnimationFrame);
    return [drawn[before].at - began, drawn[before].side];
}"""

#: The same for the hand on the pearl, which it drags by some pixels at a time.
DRAG = """async moves => {
    const pearl = document.querySelector(".pearl"), box = pearl.getBoundingClientRect();
    const hand = (kind, x) => pearl.dispatchEvent(new PointerEvent(kind, {
        bubbles: true, pointerId: 1, isPrimary: true, button: 0, buttons: 1,
        clientX: x, clientY: box.top + box.height / 2 }));
    const found = [];
    let x = box.left + box.width / 2;
    hand("pointerdown", x);
    for (let move = 0; move < moves; move++) {
        const before = drawn.length, began = performance.now();
        hand("pointermove", x += move % 2 ? 6 : -5);
        while (drawn.length === before) await new Promise(requestAnimationFrame);
        found.push([drawn[before].at - began, drawn[before].side]);
    }
    hand("pointerup", x);
    return found;
}"""


#: Waits for a whole picture after the page was told another. In the page: its policy lets no text
#: be run that is asked from outside again and again.
SHOWN = """async side => {
    const shown = () => drawn.at(-1)?.side === side
        && document.querySelector(".pearl").dataset.stage === "refined";
    const since = performance.now();
    for (let still = 0; still < 3; still = shown() ? still + 1 : 0) {
        if (performance.now() - since > 120000) throw new Error("no whole picture in two minutes");
        await new Promise(go => setTimeout(go, 100));
    }
}"""


#: Waits for the whole picture, and asks for no frame meanwhile: each is drawn by a processor that
#: the workers then lack.
WHOLE = """() => new Promise(done => {
    const pearl = document.querySelector(".pearl");
    const look = () => pearl.dataset.stage === "refined" && (watch.disconnect(), done());
    const watch = new MutationObserver(look);
    watch.observe(pearl, { attributes: true });
    look();
})"""


@contextmanager
def viewer(workers: int) -> Iterator[Page]:
    """The page of a static host, with so many workers."""
    with hosted() as address, chromium() as browser:
        yield opened(browser, address, workers)


def opened(browser: Browser, address: str, workers: int) -> Page:
    """The page, with nothing of it kept from before, once its picture is whole."""
    page = browser.new_page(viewport={"width": 1440, "height": 900})
    processors = f"Object.defineProperty(navigator, 'hardwareConcurrency', {{ value: {workers} }})"
    page.add_init_script(processors + ";" + WATCH)
    page.goto(f"{address}/?lang=en")
    page.wait_for_selector(".pearl[data-stage=refined]", timeout=120_000)
    refined(page)
    return page


def refined(page: Page) -> None:
    """Wait for the whole picture."""
    page.evaluate(WHOLE)
    page.wait_for_timeout(300)


def typed(page: Page, key: str, value: float) -> None:
    """Type a number into a knob."""
    page.evaluate(
        "() => document.querySelectorAll('details:not([open]) > summary').forEach(s => s.click())"
    )
    field = page.locator(f"[data-key='{key}'] .typed input")
    field.fill(str(value))
    field.press("Enter")
    refined(page)


def told(name: str, found: list[list[float]]) -> None:
    """A row of the table."""
    ms = [took for took, _ in found]
    sides = sorted({int(side) for _, side in found})
    print(f"{name:28}{statistics.median(ms):8.1f}{max(ms):8.1f}   {sides}", flush=True)


def speed(workers: int, lobes: int) -> None:
    """Print how long what takes."""
    with viewer(workers) as page:
        typed(page, "surface.waviness_rad", 0 if lobes == 1 else 0.05)
        print(f"{workers} workers, {lobes} lobes: ms from the event to the canvas")
        print(f"{'':28}{'median':>8}{'most':>8}   px a side")
        for name, key in (
            ("stack: tablets in winter", "nacre.thickness_winter_nm"),
            ("stack: disorder", "nacre.thickness_noise_nm"),
            ("body: pigment's strength", "body.pigment_strength"),
            ("grain", "grain"),
            ("shininess", "shininess"),
        ):
            found = []
            for run in range(RUNS):
                found.append(page.evaluate(SLIDE, [key, run % 2 == 0]))
                refined(page)
            told(name, found)
        page.click("#tab-scene")
        told("camera, dragged", page.evaluate(DRAG, 4 * RUNS)[RUNS:])
        refined(page)
        found = []
        for run in range(RUNS):
            found.append(page.evaluate(SLIDE, ["camera.exposure", run % 2 == 0]))
            refined(page)
        told("exposure", found)
        errors(page)
        whole(page)


def errors(page: Page) -> None:
    """Print how far first pictures are from the refined."""
    page.click("#tab-pearl")
    found = []
    for run in range(4):
        count = page.evaluate("drawn.length")
        page.evaluate(SLIDE, ["nacre.thickness_winter_nm", run % 2 == 0])
        refined(page)
        sides: list[list[Any]] = page.evaluate(
            "from => [drawn[from], drawn.at(-1)].map(one => [one.side, Array.from(one.codes)])",
            count,
        )
        first, last = (np.array(codes).reshape(side, side, 4) for side, codes in sides)
        if first.shape == last.shape:
            apart = delta_e_2000(_lab(first), _lab(last))
            # The cloth is black and dark; what is light is the pearl.
            pearl = last[:, :, :3].sum(axis=-1) > 150
            found.append((apart[pearl].mean(), np.percentile(apart[pearl], 95)))
    if not found:
        print("first pictures were all small: the machine is busy")
        return
    mean, most = np.mean(found, axis=0)
    print(f"first pictures of {SIZE_PX} px: CIEDE2000 {mean:.2f}, 95th percentile {most:.2f}")


def _lab(codes: NDArray[Any]) -> NDArray[Any]:
    linear = decode(codes[:, :, :3] / 255)
    return np.asarray(lab_from_xyz(xyz_from_rgb(linear)))


def whole(page: Page) -> None:
    """Print how long the refined picture takes."""
    took = [refined_ms(page, run) for run in range(6)]
    print(f"{'refined':28}{statistics.median(took):8.0f}{max(took):8.0f}")


def refined_ms(page: Page, run: int) -> float:
    """From the event to the whole picture."""
    began = page.evaluate("performance.now()")
    page.evaluate(SLIDE, ["nacre.thickness_winter_nm", run % 2 == 0])
    refined(page)
    return float(page.evaluate("drawn.at(-1).at") - began)


def share() -> None:
    """Print how much sooner two workers refine than one, by turns: machines change their pace."""
    took: dict[int, list[float]] = {1: [], 2: []}
    with hosted() as address, chromium() as browser:
        for _ in range(4):
            for workers, those in took.items():
                page = opened(browser, address, workers)
                typed(page, "surface.waviness_rad", 0)
                those.extend([refined_ms(page, run) for run in range(6)])
                page.close()
    one, two = (statistics.median(those) for those in took.values())
    print(f"refined: {one:.0f} ms by one worker, {two:.0f} by two; {one / two:.2f} times")


def start(workers: int) -> None:
    """Print how long a page takes from its address to its first picture; knobs answer then."""
    with hosted() as address, chromium() as browser:
        took = []
        for _ in range(RUNS):
            page = opened(browser, address, workers)
            took.append(page.evaluate("drawn[0].at"))
            page.close()
    print(f"{'from address to picture':28}{statistics.median(took):8.0f}{max(took):8.0f}")


def pixels() -> None:
    """Compare refined pictures with those of the command line."""
    worst = 0
    with viewer(2) as page:
        for pearl in PEARLS:
            for scene in SCENES:
                worst = max(worst, _apart(page, pearl, scene))
    print(f"largest difference of a code: {worst}")


def _apart(page: Page, pearl: str, scene: str) -> int:
    """The largest difference of a code between page and command line; 0 where both refuse."""
    try:
        made = nc.render(pearl, scene=scene, size=SIZE_PX, samples=16).develop()[0]
    except nc.InputError as refusal:
        print(f"{pearl:24}{scene:22}refused: {refusal}", flush=True)
        return 0
    link = fragment(nc.Pearl.load(pearl), nc.Scene.load(scene))
    page.evaluate("link => { location.hash = link; }", link)
    page.wait_for_timeout(500)  # the first is there already
    page.evaluate(SHOWN, SIZE_PX)
    shown = np.array(page.evaluate("Array.from(drawn.at(-1).codes)"), dtype=int)
    apart = np.abs(shown.reshape(SIZE_PX, SIZE_PX, 4)[:, :, :3] - made)
    print(f"{pearl:24}{scene:22}{apart.max():4}  {(apart > 0).mean():.6f} differ", flush=True)
    return int(apart.max())


def main() -> None:
    """Do what the command says."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--workers", type=int, default=1)
    parser.add_argument("--lobes", type=int, choices=(1, 2), default=1)
    parser.add_argument("--share", action="store_true")
    parser.add_argument("--pixels", action="store_true")
    options = parser.parse_args()
    if not (FOLDER / "index.html").is_file():
        sys.exit("the viewer's page is not built:   ./just viewer")
    if options.pixels:
        pixels()
    elif options.share:
        share()
    else:
        speed(options.workers, options.lobes)
        start(options.workers)


if __name__ == "__main__":
    main()
