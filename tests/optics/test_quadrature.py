"""Integrals of many tables at once, against closed forms."""

from __future__ import annotations

import numpy as np
import pytest

from nacreous.optics.quadrature import Array, Places, UnresolvedError, integrals

#: Where each integrand has its kink.
KINK = np.array([0.1, 1 / 3, 0.5, 0.77])


def kinks(of: Places, at: Array) -> Array:
    """|x - kink|, a fringe and a constant, [piece, node, 3]."""
    away = np.abs(at - KINK[of, None])
    return np.stack([away, np.cos(40 * KINK[of, None] * at), np.ones_like(at)], axis=2)


def test_integrals_are_their_closed_forms_to_the_tolerance() -> None:
    found = integrals(kinks, len(KINK), 3, 1e-9, 4, 1000)
    closed = [(KINK**2 + (1 - KINK) ** 2) / 2, np.sin(40 * KINK) / (40 * KINK), np.ones(4)]
    np.testing.assert_allclose(found, np.transpose(closed), rtol=0, atol=1e-9)


def test_a_polynomial_of_degree_31_needs_one_piece() -> None:
    asked = []

    def power(_: Places, at: Array) -> Array:
        asked.append(at.size)
        return np.asarray((2 * at[:, :, None] - 1) ** np.arange(32))

    found = integrals(power, 1, 32, 1.0, 1, 1)[0]
    np.testing.assert_allclose(found[::2], 1 / np.arange(1, 33, 2), rtol=0, atol=1e-15)
    np.testing.assert_allclose(found[1::2], 0, rtol=0, atol=1e-15)
    assert asked == [21]


def test_an_integral_does_not_depend_on_those_beside_it() -> None:
    together = integrals(kinks, len(KINK), 3, 1e-9, 4, 1000)
    for row in range(len(KINK)):
        alone = integrals(lambda of, at, row=row: kinks(of + row, at), 1, 3, 1e-9, 4, 1000)
        np.testing.assert_array_equal(alone[0], together[row])


def test_so_many_values_that_memory_takes_them_in_parts_are_the_same() -> None:
    def wide(of: Places, at: Array) -> Array:
        return np.asarray(np.repeat(kinks(of, at), 5000, axis=2))

    found = integrals(wide, len(KINK), 15000, 1e-4, 2, 1000)
    np.testing.assert_array_equal(found[:, ::5000], integrals(kinks, len(KINK), 3, 1e-4, 2, 1000))


def test_more_pieces_than_allowed_are_refused_and_nothing_asked_is_nothing() -> None:
    def noise(_: Places, at: Array) -> Array:
        return np.asarray(np.sign(np.sin(1e9 * at**2)))[:, :, None]

    with pytest.raises(UnresolvedError):
        integrals(noise, 1, 1, 1e-9, 4, 200)
    assert integrals(noise, 0, 1, 1e-9, 4, 200).shape == (0, 1)
