"""Damaged pearl and scene files: what people, editors and bad luck do to them."""

from __future__ import annotations

import random
import re
from collections.abc import Callable

from nacreous.spec import Pearl, Scene, preset
from nacreous.spec.key import every_key
from tests.viewer.random_spec import random_file

_VALUES = r"""
    true false 3 -7 2.5 -0.0 1e400 -inf inf nan 1e-320 +3 1_000 0.1_5 0x1F [] {} [{}] ''
    9223372036854775807 9223372036854775808 2020-02-30 2024-02-29 2020-01-01T07:32:00Z 07:32:00
    2020-01-01T00:00:00.5-07:30 [1,2] [1,2,3] [1,2,3,4] [[1]] [400.0,0] [0.4,0.3] [1.5,0.1] [1.5,-1]
    {n_o=1.5} {n_o=-1,n_e=true,z=1} [true,'a'] [0.5] [{},3] [{x=1},{y=2}] [{azimuth_deg=1}]
    "D65" "D66" "999K" "26000K" "#12345" "#ABCDEF" "02-29" "13-01" "2023-02-29" "0000-01-01"
    "a.csv" "x.toml" "akoya" "Transport" "*" "*1000" "真珠" "\u200b" "a\nb" "\u001b[m"
"""
#: What no key, or hardly one, may be.
STRANGE = [
    *_VALUES.split(),
    *("9" * 30, "9" * 400, "9" * 5000, "0x" + "f" * 4000),
    *('"' + "ab " * 50 + '"', "[" + "0," * 30 + "]"),
]

#: What is put in by mistake.
SIGNS = [
    *("", "\\u12", "\\ud800", "\x07", "\U0001f41a", '"""', "'''", "é"),
    *"\"'[]{}=.,\n#\\\r\t0- ",
]

#: Files whose keys are each right.
CONTRADICTIONS = {
    "pearl": [
        "model = 'illuminant'\n[coat]\ndent_mm = 2\nbanding = 1\n[film]\n[surface]\nfacets = 'ggx'",
        "[surface]\nfalloff_mm = 30\nmirror_weight = 0.5\n[interference]\nthreshold = 0.1",
        'body_colour = "#ffffff"\n[interference]',
        'model = "illuminant"\n[nacre]\npreset = "akoya"\nprotein = { n_o = 1.5, n_e = 1.6 }',
        'model = "illuminant"\n[nacre]\nthickness_nm = [400]\naragonite = "aragonite"',
        "[nacre]\naragonite = [1.53, 0.01]",
        "diameter_mm = 2\n[body]\nnacre_mm = 1.2345678\n[shape]\ndrill_mm = 3",
        "[shape]\nlumps = 0.2\nlump_mm = 0.5",
        "[nacre]\nprotein_nm = 0.02",
        "[nacre]\nthickness_nm = [0.38, 0.41]",
        "[nacre]\nthickness_nm = [400]\nseed = 3\nharvest = '12-15'\nfoo = 1",
        '[nacre]\nseeding = "2023-05-01"',
        '[nacre]\nseeding = "2023-05-01"\nharvest = "2023-05-01"',
        '[nacre]\nseeding = "2003-05-01"\nharvest = 2023-05-07',
        "[nacre]\nthickness_noise_nm = 400\nthickness_summer_nm = 400\nthickness_winter_nm = 400",
        "[nacre]\nthickness_noise_nm = 350.5\nthickness_winter_nm = 300",
        "[nacre]\nlayers_winter = 0\nlayers_summer = 0\nlayers_noise = 0",
        "[texture]\nlow_per_mm = 3\nhigh_per_mm = 0.3",
        "table = 3\ncamera = 2",
        "[camera]\nexposure = 2",
    ],
    "scene": [
        "[[lamps]]",
        "[[lamps]]\nazimuth_deg = 3\n[[lamps]]\nelevation_deg = 3",
        "[[lamps]]\nazimuth_deg = 3\nposition_mm = [1, 2, 3]",
        "[[lamps]]\nposition_mm = [12, 16, 0]",
        "[[lamps]]\nposition_mm = [1, 2]",
        "[[windows]]\nposition_mm = [1, 2, 3]\nfacing = [0, 0, 0]",
        "[[windows]]",
        "[[windows]]\nbelow_mm = 1\ndistance_mm = 30\nposition_mm = [100, 0, 0]",
        "[[windows]]\ndistance_mm = 30",
        "[[windows]]\nbelow_mm = 1\nfacing = [1, 0, 0]",
        "[[windows]]\nbelow_mm = 1\n[[windows]]\nbelow_mm = 2.50",
        '[sky]\npath = "a.hdr"',
        '[sky]\nkind = "panorama"',
        '[[rows]]\npearls = ["paper"]',
        "[[rows]]\npearls = [" + '"*",' * 300 + "]\n[[rows]]\npearls = [" + '"*",' * 101 + "]",
        "[[rows]]\npearls = [" + '"*",' * 401 + "]",
        "[[rows]]\npearls = []\nlabel = ''",
        "nacre = 3\ndepth = 0.5",
        "lamps = 3\nwindows = [1]\nrows = [[], {}]",
    ],
}


def damaged(kind: str, chance: random.Random) -> tuple[str, bytes]:
    """How a file was damaged, and what it holds then; now and then nothing is wrong with it."""
    how = chance.choice(list(WAYS))
    text = WAYS[how](kind, chance)
    return how, text if isinstance(text, bytes) else text.encode()


def _whole(kind: str, chance: random.Random) -> str:
    if chance.random() < 0.5:
        return preset.text(kind, chance.choice(preset.names(kind)))
    return random_file(_model(kind), chance)


def _model(kind: str) -> type[Pearl] | type[Scene]:
    return Pearl if kind == "pearl" else Scene


def _strange_value(kind: str, chance: random.Random) -> str:
    """Values of some keys replaced."""
    lines = _whole(kind, chance).split("\n")
    places = [n for n, line in enumerate(lines) if re.match(r"[a-z_]+ = ", line)]
    for place in chance.sample(places, min(len(places), chance.randint(1, 4))):
        lines[place] = lines[place].partition(" = ")[0] + " = " + chance.choice(STRANGE)
    return "\n".join(lines)


def _strange_key(kind: str, chance: random.Random) -> str:
    """Any key of the model with a strange value, or one in the wrong table, alone in its file."""
    written = []
    for one in chance.sample(list(every_key(_model(kind))), chance.randint(1, 6)):
        path = one.path.replace(".0.", ".") if chance.random() < 0.2 else one.path
        if chance.random() < 0.2:
            path = path.rpartition(".")[2]
        if ".0." not in path and path not in written:
            written.append(path)
    return "".join(f"{path} = {chance.choice(STRANGE)}\n" for path in written)


def _misspelt(kind: str, chance: random.Random) -> str:
    """Letters of keys exchanged, left out or doubled, or keys that nobody knows."""
    lines = _whole(kind, chance).split("\n")
    places = [n for n, line in enumerate(lines) if re.match(r"[a-z_]{3,} = ", line)]
    for place in chance.sample(places, min(len(places), chance.randint(1, 3))):
        key, _, rest = lines[place].partition(" = ")
        at = chance.randrange(len(key))
        key = chance.choice(
            (
                key[:at] + key[at + 1 :],
                key[:at] + key[at:][::-1],
                key[: at + 1] + key[at:],
                key.upper(),
                '"odd key\\u0007 真珠"',
                chance.choice(list(every_key(_model(kind)))).path.rpartition(".")[2],
                '"__proto__"',
                "constructor",
            )
        )
        lines[place] = f"{key} = {rest}"
    return "\n".join(lines)


def _cut(kind: str, chance: random.Random) -> str:
    text = _whole(kind, chance)
    return text[: chance.randrange(len(text))]


def _typing(kind: str, chance: random.Random) -> str:
    """A few letters taken out or put in anywhere."""
    text = _whole(kind, chance)
    for _ in range(chance.randint(1, 4)):
        at = chance.randrange(len(text))
        put = chance.choice(SIGNS)
        text = text[:at] + put + text[at + chance.randint(0, 2) :]
    return text.replace("\n", "\r\n") if chance.random() < 0.2 else text


def _twice(kind: str, chance: random.Random) -> str:
    """A line or a table that stands twice."""
    lines = _whole(kind, chance).split("\n")
    for _ in range(chance.randint(1, 2)):
        start = chance.randrange(len(lines))
        part = lines[start : start + chance.randint(1, 4)]
        at = chance.randrange(len(lines))
        lines[at:at] = part
    return "\n".join(lines)


def _deep(kind: str, chance: random.Random) -> str:
    opening = chance.choice(("[", "{a=", "[{a="))
    depth = chance.choice((5, 31, 32, 33, 40, 5000))
    dotted = ".".join("a" * chance.choice((3, 31, 32, 33, 400)))
    return chance.choice((f"name = {opening * depth}", f"{dotted} = 1", f"x = 1\n[{dotted}]"))


def _bytes(kind: str, chance: random.Random) -> bytes:
    """Encodings that TOML is not of, single bytes that UTF-8 has not, and no text at all."""
    text = "# 真珠\n" + _whole(kind, chance)
    content = bytearray(text.encode())
    content[chance.randrange(len(content))] = chance.choice((0, 0x80, 0xC0, 0xE3, 0xFF))
    return chance.choice(
        (
            bytes(content),
            text.encode("utf-16"),
            text.encode("shift_jis", "replace"),
            "\ufeff".encode() + b"depth = 7\npitch_mm = 0\n",
            b"",
            b"\n# nothing\n",
            b"\xed\xa0\x80",
        )
    )


def _contradiction(kind: str, chance: random.Random) -> str:
    return chance.choice(CONTRADICTIONS[kind])


def _many(kind: str, chance: random.Random) -> str:
    """More problems than are told."""
    count = chance.choice((20, 21, 45))
    if kind == "pearl":
        return "[nacre]\nthickness_nm = [" + "0, true, " * count + "]"
    return "".join(f"key-{number} = 1\n" for number in range(count)) + "pitch_mm = 'a'\n"


WAYS: dict[str, Callable[[str, random.Random], str | bytes]] = {
    "strange value": _strange_value,
    "strange key": _strange_key,
    "misspelt": _misspelt,
    "cut": _cut,
    "typing": _typing,
    "twice": _twice,
    "deep": _deep,
    "bytes": _bytes,
    "contradiction": _contradiction,
    "many": _many,
}
