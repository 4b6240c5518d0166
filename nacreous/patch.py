"""Patches of a pearl's photograph, such as the paper's crops of 64 x 64 pixels (figure 2)."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nacreous.problem import InputError

Array = NDArray[np.float64]
Corner = tuple[int, int]

_HIGHLIGHT = 0.99
"""Linear light from which a pixel counts as clipped by a highlight."""
_SAFE_RADIUS = 0.85
"""Share of the pearl's radius in which patches are taken: the outline itself foreshortens them."""


def patches(photograph: ArrayLike, side_px: int, corners: list[Corner]) -> Array:
    """Square patches [patch, row, column, rgb] of a photograph, by their first pixels.

    >>> patches(np.zeros((100, 100, 3)), 64, [(0, 0), (36, 20)]).shape
    (2, 64, 64, 3)
    """
    picture = checked(photograph, side_px)
    rows, columns = picture.shape[0] - side_px, picture.shape[1] - side_px
    if not corners:
        raise InputError("texture: corners is empty; allowed: at least one (row, column)")
    for row, column in corners:
        if not (0 <= row <= rows and 0 <= column <= columns):
            raise InputError(
                f"texture: corner ({row}, {column}) puts a patch outside the photograph;"
                f" allowed: (0, 0) to ({rows}, {columns})"
            )
    return np.stack([picture[r : r + side_px, c : c + side_px] for r, c in corners])


def find_corners(photograph: ArrayLike, side_px: int = 64) -> list[Corner]:
    """First pixels of all patches inside the pearl that no highlight touches, side by side.

    The pearl is what differs in colour from the photograph's border (Otsu's threshold), taken as a
    disc **(ours)**. A photograph less than two patches wide is a crop, as in the paper's figure 2:
    its middle is the patch. A close-up without background needs corners given.
    """
    picture = checked(photograph, side_px)
    rows, columns = picture.shape[:2]
    if min(rows, columns) < 2 * side_px:
        return [((rows - side_px) // 2, (columns - side_px) // 2)]
    row, column, radius = _pearl(picture)
    steps = range(-int(radius / side_px) - 1, int(radius / side_px) + 1)
    grid = [(int(row) + i * side_px, int(column) + j * side_px) for i in steps for j in steps]

    def usable(corner: Corner) -> bool:
        top, left = corner
        far = [
            np.hypot(r - row, c - column)
            for r in (top, top + side_px)
            for c in (left, left + side_px)
        ]
        inside = top >= 0 and left >= 0 and top + side_px <= rows and left + side_px <= columns
        piece = picture[max(top, 0) : top + side_px, max(left, 0) : left + side_px]
        return inside and max(far) <= radius and bool(piece.max() < _HIGHLIGHT)

    found = [corner for corner in grid if usable(corner)]
    if not found:
        raise InputError(
            f"texture: no patch of {side_px} px without highlight in the pearl seen (radius"
            f" {radius:.0f} px); allowed: a larger pearl, a smaller side_px, or corners given"
        )
    return found


def checked(photograph: ArrayLike, side_px: int) -> Array:
    """The photograph as float64, if patches of `side_px` can be cut from it.

    Raises `InputError` unless it is [row, column, 3], finite, and at least one patch each way.
    """
    picture = np.asarray(photograph)
    if picture.ndim != 3 or picture.shape[2] != 3 or picture.dtype.kind not in "fiu":
        raise InputError(
            f"texture: the photograph is {picture.dtype} {list(picture.shape)};"
            " allowed: numbers [row, column, 3]"
        )
    if not 8 <= side_px <= 1024:
        raise InputError(f"texture: side_px is {side_px}; allowed: 8 to 1024")
    if min(picture.shape[:2]) < side_px:
        raise InputError(
            f"texture: the photograph has {picture.shape[0]} x {picture.shape[1]} pixels;"
            f" allowed: at least side_px = {side_px} each way"
        )
    if not np.isfinite(picture).all():
        place = tuple(np.argwhere(~np.isfinite(picture))[0].tolist())
        raise InputError(f"texture: the photograph is not a number at {place}; allowed: finite")
    return picture.astype(np.float64)


def _pearl(picture: Array) -> tuple[float, float, float]:
    """Row and column of the pearl's middle, and the radius that is safe, in pixels."""
    shade = np.sqrt(np.clip(picture, 0, None))  # steps of about equal visibility
    border = np.concatenate([shade[0], shade[-1], shade[:, 0], shade[:, -1]])
    distance = np.linalg.norm(shade - np.median(border, axis=0), axis=-1)
    count, edges = np.histogram(distance, bins=256, range=(0, distance.max() or 1))
    below, total = np.cumsum(count), np.cumsum(count * edges[:-1])
    # Otsu (1979): the threshold with the greatest variance between the two sides.
    spread = (total[-1] * below - total * below[-1]) ** 2 / np.maximum(
        below * (below[-1] - below), 1
    )
    rows, columns = np.nonzero(distance > edges[spread.argmax() + 1])
    if not rows.size:
        return picture.shape[0] / 2, picture.shape[1] / 2, 0.0
    return rows.mean(), columns.mean(), _SAFE_RADIUS * float(np.sqrt(rows.size / np.pi))
