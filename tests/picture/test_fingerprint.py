"""Pictures keep their bytes from one commit to the next, unless the change is wanted and told."""

import pytest

from tests.picture.fingerprint import PEARLS, SCENES, Fingerprint, fingerprint, golden, pictured


def test_the_file_has_every_pearl_in_every_scene():
    assert list(golden()) == [(pearl, scene) for scene in SCENES for pearl in PEARLS]


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


def _told(pearl: str, before: Fingerprint, now: Fingerprint) -> str:
    """What changed of a picture, "" for nothing."""
    if before == now:
        return ""
    largest = max(abs(a - b) for a, b in zip(before.means, now.means, strict=True))
    return f"  {pearl}: {before.digest} is {now.digest}; the means of its parts by {largest:.2g}"
