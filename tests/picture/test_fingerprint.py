"""Pictures keep their bytes from one commit to the next, unless the change is wanted and told."""

import pytest

from nacreous.image import recipe_json
from tests.picture.fingerprint import (
    PEARLS,
    RECIPES,
    SCENES,
    SIZE_PX,
    Fingerprint,
    fingerprint,
    golden,
    pictured,
    recipe_file,
)


def test_the_file_has_every_pearl_in_every_scene():
    assert list(golden()) == [(pearl, scene) for scene in SCENES for pearl in PEARLS]


@pytest.mark.parametrize(("pearl", "scene"), RECIPES)
def test_recipes_that_other_programs_are_tested_with_are_those_of_today(pearl, scene):
    assert recipe_file(pearl, scene).read_text() == recipe_json(pearl, scene, SIZE_PX) + "\n"


@pytest.mark.parametrize("scene", SCENES)
def test_pictures_are_those_on_file(scene):
    on_file = golden()
    found = {pearl: fingerprint(pictured(pearl, scene)) for pearl in PEARLS}
    changed = [_told(pearl, on_file[pearl, scene], found[pearl]) for pearl in PEARLS]
    assert not any(changed), "\n".join(
        [
            f"{scene}: pictures changed; if that is meant, call ./just fingerprints and say why "
            "in CHANGELOG.md",
            *filter(None, changed),
        ]
    )


def test_paper_green_is_the_paper_pearl_of_before():
    """Until its growth became bluish, `paper` had these in the scenes where it lies alone."""
    before = "fe6e9ea431d65acb ce726d6f66efbf45 f5d0aa564b400bc3 123bba0cbdd58a79 984b83ed868064a4"
    alone = [scene for scene in SCENES if scene != "two-tier"]
    assert [golden()["paper-green", scene].digest for scene in alone] == before.split()


def _told(pearl: str, before: Fingerprint, now: Fingerprint) -> str:
    """What changed of a picture, "" for nothing."""
    if before == now:
        return ""
    largest = max(abs(a - b) for a, b in zip(before.means, now.means, strict=True))
    return f"  {pearl}: {before.digest} is {now.digest}; the means of its parts by {largest:.2g}"
