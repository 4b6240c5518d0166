"""A turn as one file that moves: animated pictures by Pillow, video by PyAV."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from nacreous import file, image
from nacreous.named_files import moved, relative_to
from nacreous.number import whole_of
from nacreous.problem import InputError
from nacreous.recipe import PREFIX
from nacreous.turn.plan import Plan
from nacreous.turn.series import Progress, shares

if TYPE_CHECKING:
    from numpy.typing import NDArray
    from PIL.Image import Image as Picture

    from nacreous.image import Image

#: Encoder and its options of each kind of video: a quality at which grain stays **(ours)**.
_VIDEO = {
    ".mp4": ("libx264", {"crf": "16", "preset": "slow"}),
    ".webm": ("libvpx-vp9", {"crf": "20", "b:v": "0"}),
}
#: Lossy WebP: pearls show no difference to a lossless one of four times the bytes **(ours)**.
_WEBP_QUALITY = 95
#: Pictures that the palette of a GIF is found from, spread over the turn.
_PALETTE_FRAMES = 8

#: Browsers play a GIF's frames of less than 0.02 s as if they were of 0.1 s.
_MOST_GIF_FPS = 50
#: Of all frames of an animated picture, which Pillow holds at once in 3 bytes each **(ours)**.
_MOST_PIXELS = 1_000_000_000

#: The kinds of file that move.
ENDINGS = (".png", ".gif", ".webp", *_VIDEO)


def check_place(place: Path, size: int, count: int, fps: int) -> None:
    """Refuse an ending, a place, or a size that its encoder cannot write, before any long work."""
    ending = place.suffix.lower()
    if ending not in ENDINGS:
        raise InputError(
            f"{place}: the ending is {place.suffix}; allowed: {', '.join(ENDINGS)}, or none for a "
            "folder"
        )
    _check_amount(place, size, count, fps)
    file.check_output(place, ENDINGS)
    if ending == ".webp":
        from PIL import features

        if not features.check("webp"):
            raise InputError(
                f"{place}: the Pillow here writes no WebP; allowed: .png or .gif, or after "
                "pip install --force-reinstall pillow"
            )
    if ending in _VIDEO:
        _check_video(place, size)


def keep(place: Path, laid: Plan, fps: int, progress: Progress | None) -> int:
    """Render all frames and write the file, whole or not at all; how many frames that were."""
    pictures = (image.render_recipe(made, show) for made, show in shares(laid.recipes, progress))
    ending = place.suffix.lower()
    with file.atomic(place) as temporary:
        if ending in _VIDEO:
            _write_video(temporary, map(_codes, pictures), laid.size, fps)
        else:
            _WRITERS[ending](temporary, pictures, len(laid.recipes), fps)
    return len(laid.recipes)


def _check_amount(place: Path, size: int, count: int, fps: int) -> None:
    """Refuse what no browser plays as fast, and more than fits into memory."""
    ending = place.suffix.lower()
    if ending == ".gif" and fps > _MOST_GIF_FPS:
        raise InputError(f"fps is {fps}; allowed for .gif: 1 to {_MOST_GIF_FPS}")
    if ending not in _VIDEO and count * size * size > _MOST_PIXELS:
        raise InputError(
            f"{place}: {count} frames of {size} x {size} are {count * size * size / 1e6:.0f} "
            f"megapixels; allowed for {ending}: {_MOST_PIXELS / 1e6:.0f}; a folder or a video "
            "takes more"
        )


def _codes(picture: Image) -> NDArray[np.uint8]:
    return picture.develop()[0].astype(np.uint8, copy=False)


def _pillow(picture: Image) -> Picture:
    import PIL.Image

    return PIL.Image.fromarray(_codes(picture))


def _durations(count: int, fps: int, step_ms: int) -> list[int]:
    """How long each frame stays, in ms: whole steps that keep pace with the frames a second.

    >>> _durations(5, 24, 1), sum(_durations(24, 24, 1)), _durations(3, 30, 10)
    ([42, 41, 42, 42, 41], 1000, [30, 40, 30])
    """
    at = [round(1000 * number / (fps * step_ms)) * step_ms for number in range(count + 1)]
    return [max(after - before, step_ms) for before, after in itertools.pairwise(at)]


def _write_png(place: Path, pictures: Iterator[Image], count: int, fps: int) -> None:
    """Without loss; it carries the first frame's recipe, as a picture of that frame does."""
    from PIL.PngImagePlugin import PngInfo

    first = next(pictures)
    info = PngInfo()
    for name, text in moved(first.recipe, relative_to(place.parent)).items():
        info.add_itxt(PREFIX + name, text)
    _pillow(first).save(
        place,
        save_all=True,
        append_images=list(map(_pillow, pictures)),
        duration=_durations(count, fps, 1),
        loop=0,
        pnginfo=info,
    )


def _write_webp(place: Path, pictures: Iterator[Image], count: int, fps: int) -> None:
    shown = [_pillow(picture) for picture in pictures]
    durations = _durations(count, fps, 1)
    shown[0].save(
        place,
        save_all=True,
        append_images=shown[1:],
        duration=durations,
        loop=0,
        quality=_WEBP_QUALITY,
    )


def _write_gif(place: Path, pictures: Iterator[Image], count: int, fps: int) -> None:
    """256 colours, the same for all frames, so that what stands still does not flicker."""
    import PIL.Image

    shown = [_pillow(picture) for picture in pictures]
    chosen = shown[:: max(1, count // _PALETTE_FRAMES)]
    together = PIL.Image.fromarray(np.concatenate([np.asarray(one) for one in chosen]))
    palette = together.quantize(256, PIL.Image.Quantize.MEDIANCUT)
    reduced = [
        one.quantize(palette=palette, dither=PIL.Image.Dither.FLOYDSTEINBERG) for one in shown
    ]
    durations = _durations(count, fps, 10)
    reduced[0].save(place, save_all=True, append_images=reduced[1:], duration=durations, loop=0)


_WRITERS: dict[str, Callable[[Path, Iterator[Image], int, int], None]] = {
    ".png": _write_png,
    ".gif": _write_gif,
    ".webp": _write_webp,
}


def _check_video(place: Path, size: int) -> None:
    """PyAV must be there with its encoder; colours are kept by squares of four pixels."""
    if whole_of("size", size, 1, 8192) % 2:
        raise InputError(f"size is {size}; allowed for {place.suffix}: an even number")
    without = "allowed without it: .png, .gif, .webp or a folder"
    try:
        import av
    except ImportError:
        raise InputError(
            f"{place}: video needs PyAV, which is not installed:   pip install 'nacreous[video]'; "
            f"{without}"
        ) from None
    encoder = _VIDEO[place.suffix.lower()][0]
    if encoder not in av.codecs_available:
        raise InputError(f"{place}: the PyAV here has no {encoder}; {without}")


def _write_video(place: Path, codes: Iterator[NDArray[np.uint8]], size: int, fps: int) -> None:
    """Codes of sRGB, tagged as such; colours by the matrix of ITU-R BT.709."""
    import av
    from av.video.reformatter import Colorspace

    encoder, options = _VIDEO[place.suffix.lower()]
    with av.open(str(place), "w") as container:
        stream = container.add_stream(encoder, rate=fps, options=options)
        if not isinstance(stream, av.VideoStream):
            raise InputError(f"{place}: the PyAV here makes no pictures of {encoder}")
        stream.width = stream.height = size
        stream.pix_fmt = "yuv420p"
        context = stream.codec_context
        # ITU-T H.273: primaries and matrix 1 are BT.709, curve 13 is sRGB, range 1 is limited.
        context.color_primaries, context.colorspace = 1, 1
        context.color_trc, context.color_range = 13, 1
        for shown in codes:
            frame = av.VideoFrame.from_ndarray(shown, format="rgb24")
            frame = frame.reformat(format="yuv420p", dst_colorspace=Colorspace.ITU709)
            container.mux(stream.encode(frame))
        container.mux(stream.encode())
