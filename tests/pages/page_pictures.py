"""Draw the pictures of docs/participants.md from the pages themselves.

    python -m tests.pages.page_pictures docs/pictures [FOLDER]

FOLDER: also keep every page there, in English on a laptop and in Japanese on a telephone.
"""

import sys
import tempfile
from pathlib import Path

from PIL import Image

from tests.pages.browser import WHOLE, Guarded, Participant, chromium, frozen, guarded
from tests.support.server_process import served

STUDY = WHOLE.replace("size_px = 512, samples = 1, width_mm = 40", "size_px = 1024, width_mm = 60")
LAPTOP = {"width": 1280, "height": 800}
TELEPHONE = {"width": 390, "height": 844}

#: What each picture shows, by the names of pages.
SHEET = ("consent", "card", "blind-spot", "gamma", "dark", "contrast", "colour", "pair", "break")
PHONE = ("consent", "card", "colour", "pair")


def walk(guard: Guarded, language: str, folder: Path) -> None:
    """Go through the study, and take a picture of each page when it is first seen."""
    person = guard.open()
    taken = set()

    def seen(name: str) -> None:
        if name not in taken:
            taken.add(name)
            person.page.mouse.move(0, 0)
            person.page.wait_for_timeout(200)
            person.page.screenshot(path=folder / f"{language}-{name}.png")

    person.seen = seen
    person.agree(language)
    person.at("groups")
    person.page.click("label >> nth=0")
    person.go("groups")
    person.go("notes")
    screen(person)
    person.trials(lambda trial: "left")


def screen(person: Participant) -> None:
    """The screen check, on a window of any size."""
    person.go("screen")
    person.at("full")
    person.page.click("button.quiet")
    person.until(".page-window, .page-card")
    if person.page.query_selector(".page-window"):
        person.at("window")
        person.page.click(".actions button")
    person.go("card")
    person.until(".page-blind-spot .sheet")
    person.page.click("button.main")
    person.page.wait_for_timeout(1500)
    person.at("blind-spot")
    person.page.click("button.quiet")
    person.at("distance")
    person.page.fill("#distance", "60")
    person.page.click("button.main")
    person.go("gamma")
    person.at("dark")
    person.page.click(".patches button >> nth=2")
    person.at("contrast")
    for _ in range(10):
        person.page.click(".rings .up")
    person.at("colour")
    for _ in range(7):
        person.page.click(".digits .none")


def side_by_side(paths: list[Path], columns: int, width: int) -> Image.Image:
    """Pictures of one size in rows, each `width` wide, on a grey that parts them."""
    pictures = [Image.open(path).convert("RGB") for path in paths]
    height = round(pictures[0].height * width / pictures[0].width)
    rows = -(-len(pictures) // columns)
    size = (columns * (width + 8) + 8, rows * (height + 8) + 8)
    sheet = Image.new("RGB", size, (200, 200, 200))
    for place, picture in enumerate(pictures):
        row, column = divmod(place, columns)
        small = picture.resize((width, height), Image.Resampling.LANCZOS)
        sheet.paste(small, (8 + column * (width + 8), 8 + row * (height + 8)))
    return sheet


def few_colours(picture: Image.Image) -> Image.Image:
    """The same in 256 colours, among which those of small areas have their part."""
    counted = picture.getcolors(picture.width * picture.height) or []
    several = [colour for count, colour in counted for _ in range(round(count**0.5))]
    sample = Image.new("RGB", (len(several), 1))
    sample.putdata(several)
    return picture.quantize(palette=sample.quantize(256), dither=Image.Dither.NONE)


def main(pictures: Path, folder: Path) -> None:
    telephone = {"viewport": TELEPHONE, "has_touch": True, "is_mobile": True}
    with tempfile.TemporaryDirectory() as place:
        study = frozen(STUDY, Path(place) / "study")
        with served(study) as server, chromium() as browser:
            with guarded(browser, server.url, viewport=LAPTOP) as guard:
                walk(guard, "en", folder)
            with guarded(browser, server.url, **telephone) as guard:
                walk(guard, "ja", folder)
    for name, language, pages, columns, width in (
        ("pages", "en", SHEET, 3, 360),
        ("pair", "en", ("pair",), 1, 800),
        ("phone", "ja", PHONE, 4, 240),
    ):
        paths = [folder / f"{language}-{page}.png" for page in pages]
        sheet = few_colours(side_by_side(paths, columns, width))
        sheet.save(pictures / f"participants-{name}.png", optimize=True)


if __name__ == "__main__":
    if len(sys.argv) == 3:
        main(Path(sys.argv[1]), Path(sys.argv[2]))
    else:
        with tempfile.TemporaryDirectory() as place:
            main(Path(sys.argv[1]), Path(place))
