"""Where decisions on the way from a recipe to pixels live: in crates/render, and nowhere else."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path

from nacreous.spec import Pearl, Scene
from nacreous.spec.key import every_key

ROOT = Path(__file__).parents[2]

#: The number of bounces, the order in which light is worked out, and what each stage is made by.
STAGES = re.compile(
    r"\b(BOUNCES|(Surroundings|Film|Surface|Response|Transport|Irradiance|Rings|Light|Sampler"
    r"|Reflections)::new\b|Parameters::new\b)|\.(settled|with_glows|glow|resolved_for)\("
)

JUSTIFIED = {
    # A photograph is analysed before there is a recipe; the renderer is handed what was found.
    ("nacreous/texture.py", "low_per_mm"),
    ("nacreous/texture.py", "high_per_mm"),
    ("nacreous/texture.py", "mm_per_pixel"),
    # The paper's measurements look along rays of their own, so that the renderer's can be wrong. A
    # lamp has a direction or a position, and a camera all of its keys: none is left open.
    ("nacreous/paper/sight.py", "azimuth_deg"),
    ("nacreous/paper/sight.py", "elevation_deg"),
    ("nacreous/paper/sight.py", "position_mm"),
    ("nacreous/paper/sight.py", "distance_mm"),
    ("nacreous/paper/circle.py", "distance_mm"),
    # Lights go round from where they stand: one in no place is refused before.
    ("nacreous/turn/motion.py", "azimuth_deg"),
    ("nacreous/turn/motion.py", "elevation_deg"),
    ("nacreous/turn/motion.py", "position_mm"),
    ("nacreous/turn/motion.py", "facing"),
    # A card tells where each number comes from: the file, or else the renderer, which is asked.
    ("nacreous/trade/stated.py", "facet_spread_rad"),
    ("nacreous/trade/stated.py", "area"),
    ("nacreous/card/grading.py", "nacre_mm"),
    ("nacreous/card/grading.py", "area"),
    ("nacreous/card/card.py", "field_mm"),
}


def sources(folder: str, ending: str) -> Iterator[tuple[str, str]]:
    """Path and text of each file of ours in a folder."""
    for path in sorted((ROOT / folder).rglob(f"*{ending}")):
        yield path.relative_to(ROOT).as_posix(), path.read_text("utf-8")


def without_comments(rust: str) -> str:
    return re.sub(r"//.*", "", rust)


def test_crates_render_alone_orders_the_stages_and_counts_the_bounces() -> None:
    knowing = {
        path
        for path, text in sources("crates", ".rs")
        if STAGES.search(without_comments(text)) and not path.startswith("crates/image/")
    }
    assert {path.rpartition("/")[0] for path in knowing} == {
        "crates/render/src",
        "crates/render/src/pearl",
        "crates/render/src/stages",
    }
    assert "crates/render/src/stages/around.rs" in knowing


def test_the_number_of_bounces_stands_on_one_line() -> None:
    stated = [
        path
        for path, text in sources("crates", ".rs")
        for line in without_comments(text).splitlines()
        if re.search(r"\bBOUNCES\b.*=", line)
    ]
    assert stated == ["crates/render/src/stages/around.rs"]


def left_open() -> set[str]:
    """The keys of numbers that a file may leave open and the renderer then finds."""
    return {
        key.path.rpartition(".")[2]
        for model in (Pearl, Scene)
        for key in every_key(model)
        if key.field.default is None and "float" in str(key.field.annotation)
    }


def test_python_resolves_no_key_that_was_left_open() -> None:
    """Outside nacreous/spec nobody reads such a key, and nobody can put a value in its place."""
    keys = left_open()
    assert {"pitch_mm", "outer_um", "mixing", "facet_spread_rad", "distance_mm"} <= keys
    reading = {
        (path, node.attr)
        for path, text in sources("nacreous", ".py")
        if "nacreous.spec" in text and not path.startswith("nacreous/spec/")
        for node in ast.walk(ast.parse(text))
        if isinstance(node, ast.Attribute) and node.attr in keys
        if ast.unparse(node.value) != "_core"  # the renderer asked
    }
    assert reading == JUSTIFIED
