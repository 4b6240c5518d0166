"""Cards of pearls, made and kept."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from io import BytesIO
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from nacreous import file, image
from nacreous.card.factor import Factor
from nacreous.card.grading import CULTURES, graded
from nacreous.card.making import own_keys
from nacreous.card.translation import Texts
from nacreous.measure import Measures, measure
from nacreous.number import said, whole_of
from nacreous.problem import InputError
from nacreous.recipe import recipe
from nacreous.spec import Pearl, Scene
from nacreous.spec.load import shared_out
from nacreous.trade import with_words
from nacreous.value import value_class

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from nacreous.recipe import Given

__all__ = ["ENDINGS", "MOST_PEARLS", "Card", "make", "save"]

#: Neutral grey under a diffuse panel of D65 (ISO 3668), as a grading laboratory's: brown squares
#: under light of equal energy, as in the scene paper, would tint the overtone **(ours)**.
SCENE = "booth"
#: What a page of cards can be.
ENDINGS = (".html", ".png")
#: The most cards on a page: of more, a PNG would be taller than matplotlib draws **(ours)**.
MOST_PEARLS = 48


@value_class
class Card:
    """A pearl, its picture in a scene, and its factors.

    given: what the pearl was loaded from, as a command names it; None of a model without a file.
    scene: what the scene was loaded from, likewise; scene_name: what it is called. codes: uint8
    [row, column, rgb], the picture in sRGB. samples: the most that a pixel took. words, overrides:
    what changed the files, as `--word` and `--set` have it.
    """

    pearl: Pearl
    given: str | None
    scene: str | None
    scene_name: str
    culture: str | None
    codes: NDArray[np.uint8]
    samples: int
    factors: tuple[Factor, ...]
    words: tuple[str, ...] = ()
    overrides: tuple[str, ...] = ()

    @property
    def size(self) -> int:
        """Pixels a side."""
        return len(self.codes)

    @property
    def png(self) -> bytes:
        """The picture as a PNG."""
        from PIL import Image as Pillow

        held = BytesIO()
        Pillow.fromarray(self.codes).save(held, "PNG", optimize=True)
        return held.getvalue()


def make(
    pearls: Sequence[Given],
    scene: str | Path | Scene = SCENE,
    culture: str | None = None,
    size: int = 512,
    samples: int = 16,
    progress: Callable[[float], None] | None = None,
    words: Sequence[str] = (),
    overrides: Sequence[str] = (),
) -> list[Card]:
    """Render, measure and grade each pearl by itself.

    pearls: 1 to `MOST_PEARLS` files, presets' names or models. scene, size, samples: as for
    `nacreous.render`. culture: one of `CULTURES`, for the word of the nacre. progress: called with
    the finished share. words, overrides: "luster=Fair" and "depth=0.7", for every pearl and for the
    scene, of files and presets alone; where both set a key, the latter counts. Raises `InputError`,
    before the first picture.
    """
    if isinstance(pearls, str | Path | Pearl):
        pearls = [pearls]
    whole_of("the number of pearls", len(pearls), 1, MOST_PEARLS)
    if culture is not None and culture not in CULTURES:
        raise InputError(f"culture is {said(culture)}; allowed: {', '.join(CULTURES)}")
    loaded, around = loaded_with(pearls, scene, words, overrides)
    recipes = [recipe(one, around, size, samples) for one in loaded]
    cards = []
    for number, (pearl, given, made) in enumerate(zip(loaded, pearls, recipes, strict=True)):
        picture = image.render_recipe(made, _share(number, len(loaded), progress))
        factors = graded(pearl, _measured(picture, pearl, around), culture)
        codes = np.asarray(picture.develop()[0], np.uint8)
        named = None if isinstance(given, Pearl) else str(given)
        scene_given = None if isinstance(scene, Scene) else str(scene)
        how = (named, scene_given, around.name, culture, codes, samples, factors)
        cards.append(Card(pearl, *how, tuple(words), tuple(overrides)))
    return cards


def loaded_with(
    pearls: Sequence[Given],
    scene: str | Path | Scene,
    words: Sequence[str],
    overrides: Sequence[str],
) -> tuple[list[Pearl], Scene]:
    """Files and presets, with what words and overrides set; models as they are."""
    settings = with_words(words, overrides)
    models = isinstance(scene, Scene) or any(isinstance(one, Pearl) for one in pearls)
    if settings and models:
        raise InputError("words or overrides are given with a model; allowed: with files, presets")
    of_pearl, of_scene = shared_out(settings)
    around = scene if isinstance(scene, Scene) else Scene.load(scene, of_scene)
    return [one if isinstance(one, Pearl) else Pearl.load(one, of_pearl) for one in pearls], around


def save(path: str | Path, cards: Sequence[Card], language: str = "en") -> None:
    """Write cards as one page; the ending decides: .html or .png. Same cards, same bytes.

    language: "en" or "ja". A PNG in Japanese needs a Japanese font; HTML leaves that to the reader.
    The file is whole or not there. Raises `InputError`.
    """
    place, texts = check_place(path, language), Texts(language)
    check_letters(place, [card.pearl for card in cards], [card.given for card in cards])
    with file.atomic(place) as temporary:
        if place.suffix.lower() == ".png":
            from nacreous.card.sheet import draw

            draw(temporary, cards, texts, place.name)
        else:
            from nacreous.card.page import html

            temporary.write_text(html(cards, language, place.name), encoding="utf-8")


def check_place(path: str | Path, language: str) -> Path:
    """Refuse a place, an ending, a language, and Japanese without a font, before long work."""
    place = file.check_output(file.named(path), ENDINGS)
    if Texts(language).language == "ja" and place.suffix.lower() == ".png":
        from nacreous.figure import japanese_fonts

        if not japanese_fonts():
            raise InputError(
                f"{place}: no Japanese font here to draw a picture with:   "
                "sudo apt install fonts-noto-cjk   (or write .html, which needs none)"
            )
    return place


def check_letters(place: Path, pearls: Sequence[Pearl], given: Sequence[str | None] = ()) -> None:
    """Refuse a picture of names, keys and paths that no font here has the letters of."""
    if place.suffix.lower() != ".png":
        return
    from nacreous.figure import letters_without_a_font

    drawn = [*(str(one) for one in given), *(line for one in pearls for line in own_keys(one))]
    if missing := letters_without_a_font("".join([*drawn, *(pearl.name for pearl in pearls)])):
        raise InputError(
            f"{place}: no font here has {missing} of the pearl's file to draw a picture with; "
            "install one, for Japanese:   sudo apt install fonts-noto-cjk   (or write .html)"
        )


def _measured(picture: image.Image, pearl: Pearl, scene: Scene) -> Measures | str:
    """The measures, or why there are none: several pearls, or one too small or cut off."""
    mm_per_pixel = image.field_mm(pearl, scene) / len(picture.linear)
    try:
        return measure(picture, mm_per_pixel=mm_per_pixel)
    except InputError as problem:
        return str(problem)


def _share(
    number: int, count: int, progress: Callable[[float], None] | None
) -> Callable[[float], None] | None:
    return None if progress is None else lambda done: progress((number + done) / count)
