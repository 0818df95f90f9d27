"""The grid tools against SciPy's."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as arrays
from scipy import ndimage

from robolayout._grid import components, distance, window_count, within

MASKS = arrays.arrays(np.bool_, st.tuples(st.integers(1, 20), st.integers(1, 20)))


@given(MASKS)
def test_components_are_scipys(mask: np.ndarray) -> None:
    expected, count = ndimage.label(mask, np.ones((3, 3)))
    labels, sizes = components(mask)
    assert np.array_equal(labels, expected)
    assert np.array_equal(sizes, np.bincount(expected.ravel())[1:])
    assert len(sizes) == count


def test_components_of_a_spiral_are_one() -> None:
    spiral = np.zeros((41, 41), dtype=bool)
    for k in range(0, 20, 2):
        spiral[k, k : 41 - k] = spiral[k : 41 - k, 40 - k] = spiral[40 - k, k : 41 - k] = True
        spiral[k + 2 : 41 - k, k] = True
        spiral[k + 2, k : k + 3] = True
    labels, sizes = components(spiral)
    assert len(sizes) == 1
    assert labels.max() == 1


@given(MASKS)
def test_distance_is_scipys(mask: np.ndarray) -> None:
    if mask.all():
        assert np.isinf(distance(mask)).all()
    else:
        assert np.allclose(distance(mask), ndimage.distance_transform_edt(mask))


@given(MASKS, st.integers(1, 9))
def test_a_limit_changes_no_distance_within_it(mask: np.ndarray, limit: int) -> None:
    full, limited = distance(mask), distance(mask, limit)
    near = full <= limit
    assert np.array_equal(full[near], limited[near])
    assert (limited[~near] > limit).all()


def test_distances_may_be_long() -> None:
    mask = np.ones((300, 400), dtype=bool)
    mask[0, 0] = False
    assert distance(mask)[-1, -1] == pytest.approx(np.hypot(299, 399))


@pytest.mark.parametrize("side", [1, 2, 3, 4, 7])
@given(mask=MASKS)
def test_windows_erode_and_dilate_as_scipys(side: int, mask: np.ndarray) -> None:
    square = np.ones((side, side), dtype=bool)
    assert np.array_equal(window_count(mask, side) == side**2, ndimage.binary_erosion(mask, square))
    if side % 2:
        assert np.array_equal(window_count(mask, side) > 0, ndimage.binary_dilation(mask, square))


@given(MASKS, st.floats(0.0, 9.0))
def test_what_is_within_is_not_farther_away(mask: np.ndarray, radius: float) -> None:
    radius += 1e-6
    assert np.array_equal(within(mask, radius), distance(~mask) <= radius)
