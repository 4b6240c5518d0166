"""Every public result is a value: unchanging; copied, pickled, compared, hashed as its numbers."""

from __future__ import annotations

import copy
import dataclasses
import functools
import pickle
from collections.abc import Callable, Iterator, Mapping
from typing import Any

import numpy as np
import pytest
from dask.base import tokenize
from joblib import hash as hash_of

import nacreous as nc
from nacreous.value import value_class
from tests.support.values import examples, public_classes

#: What is offered and is no result: it holds nothing, or is an error.
NO_RESULTS = {"nacreous.problem.InputError"}

each_result = pytest.mark.parametrize("result", examples(), ids=lambda item: type(item).__name__)


@each_result
def test_no_result_fills_a_screen_by_its_repr(result: Any) -> None:
    assert len(repr(result)) < 3000


def copies(item: Any) -> Iterator[Any]:
    yield copy.copy(item)
    yield copy.deepcopy(item)
    for protocol in range(pickle.HIGHEST_PROTOCOL + 1):
        yield pickle.loads(pickle.dumps(item, protocol))


def arrays(item: Any) -> Iterator[np.ndarray[Any, Any]]:
    """Those that people can reach in a result."""
    if isinstance(item, np.ndarray):
        yield item
    elif isinstance(item, Mapping):
        for part in item.values():
            yield from arrays(part)
    elif isinstance(item, tuple):
        for part in item:
            yield from arrays(part)
    elif dataclasses.is_dataclass(item):
        for field in dataclasses.fields(item):
            yield from arrays(getattr(item, field.name))
    elif isinstance(item, nc.Image):
        yield from arrays((item.linear, item.layers))


def test_every_public_class_has_an_example() -> None:
    known = {f"{type(item).__module__}.{type(item).__qualname__}" for item in examples()}
    assert set(public_classes()) - known <= NO_RESULTS


@each_result
def test_a_result_refuses_that_a_field_is_set_or_deleted(result: Any) -> None:
    named = getattr(result, "__dataclass_fields__", None) or getattr(result, "_fields", None)
    named = named or getattr(type(result), "model_fields", None) or ["recipe", "anything"]
    for name in [*named, "anything"]:
        with pytest.raises((AttributeError, nc.InputError)):
            setattr(result, name, 1)
        with pytest.raises((AttributeError, nc.InputError)):
            delattr(result, name)


@each_result
def test_no_array_of_a_result_can_be_written_to_however_it_was_made(result: Any) -> None:
    for item in (result, *copies(result)):
        assert not any(array.flags.writeable for array in arrays(item))
        for array in arrays(item):
            if array.size:
                with pytest.raises(ValueError, match="WRITEABLE"):
                    array.flags.writeable = True


@each_result
def test_no_array_of_a_result_takes_another_shape_or_type(result: Any) -> None:
    item = copy.deepcopy(result)
    for array in arrays(item):
        if array.size:
            np.ndarray.shape.__set__(array, (1, *array.shape))
            np.ndarray.dtype.__set__(array, f"u{array.itemsize}" if array.itemsize < 16 else "2u8")
    assert item == result
    assert hash(item) == hash(result)
    assert [array.shape for array in arrays(item)] == [array.shape for array in arrays(result)]


@each_result
def test_a_result_comes_back_equal_from_copies_and_pickles(result: Any) -> None:
    for other in copies(result):
        assert other == result
        assert hash(other) == hash(result)
        assert {result: "known"}[other] == "known"
        assert repr(other) == repr(result)


@each_result
def test_results_of_other_numbers_are_not_equal(result: Any) -> None:
    assert result != 1
    assert sum(result == other for other in examples()) == 1
    for field in dataclasses.fields(result) if dataclasses.is_dataclass(result) else ():
        item = getattr(result, field.name)
        if field.init and field.compare and isinstance(item, np.ndarray) and item.dtype.kind == "f":
            assert dataclasses.replace(result, **{field.name: item + 1e-9}) != result


def test_the_arrays_that_people_give_stay_theirs() -> None:
    thickness_nm = np.array([400.0, 410.0])
    stack = nc.LayerStack(thickness_nm)
    thickness_nm[0] = 500.0
    assert stack.thickness_nm.tolist() == [400.0, 410.0]


def test_a_sweep_over_a_field_is_refused_and_replacing_it_makes_another_stack() -> None:
    stack = nc.LayerStack([400.0] * 10)
    with pytest.raises(AttributeError, match="protein_nm"):
        stack.protein_nm = 40.0  # type: ignore[misc]
    thicker = dataclasses.replace(stack, protein_nm=40.0)
    R = [nc.optics.reflectance(each, 0.0, 500.0)[0, 0] for each in (stack, thicker)]
    assert R[0] != R[1]
    assert thicker == nc.LayerStack([400.0] * 10, 40.0)


@pytest.mark.parametrize(
    ("one", "other", "equal"),
    [
        (0.0, -0.0, True),
        (np.nan, float("nan"), True),
        (np.array([0.0, np.nan]), np.array([-0.0, np.nan]), True),
        (np.array([1.0]), np.array([[1.0]]), False),
        ([1, [2, 3]], (1, (2, 3)), True),
        ({"a": 1, "b": 2}, {"b": 2, "a": 1}, True),
        ({"a": np.zeros(2)}, {"a": np.ones(2)}, False),
    ],
)
def test_values_compare_as_their_numbers(one: Any, other: Any, equal: bool) -> None:
    first, second = Kept(one), Kept(other)
    assert (first == second) is equal
    assert (hash(first) == hash(second)) or not equal


def test_values_of_different_classes_are_never_equal() -> None:
    @value_class
    class Other:
        item: Any

    assert Kept(1) != Other(1)


@value_class
class Kept:
    """A value of one field."""

    item: Any


def test_a_medium_of_a_module_pickles_and_a_lambda_says_so() -> None:
    unpickled: Callable[[Any], Any] = lambda nm: 1.5 + 0 * nm  # noqa: E731
    with pytest.raises((pickle.PicklingError, AttributeError)):
        pickle.dumps(nc.LayerStack([400.0], protein=unpickled))


@pytest.mark.parametrize(
    ("one", "other"),
    [
        ({"aragonite": 1.5}, {"aragonite": 1.5 + 0j}),
        ({"aragonite": 1.5}, {"aragonite": np.float32(1.5)}),
        ({"aragonite": 1.5}, {"aragonite": np.array(1.5)}),
        ({"substrate": 2}, {"substrate": 2.0}),
        ({"substrate": (2, 1.5 + 0j)}, {"substrate": [2.0, np.float64(1.5)]}),
        ({"protein_nm": 0.0}, {"protein_nm": -0.0}),
        ({"protein_nm": [0.0, 1.0]}, {"protein_nm": [-0.0, 1.0]}),
        ({"cover": [(1, 0.0)]}, {"cover": [(1.0 + 0j, -0.0)]}),
    ],
)
def test_equal_stacks_are_one_to_hash_dask_and_joblib(one: Any, other: Any) -> None:
    first, second = (nc.LayerStack([380.0, 390.0], **given) for given in (one, other))
    assert first == second
    for known in (hash, tokenize, hash_of):
        assert known(first) == known(second)


@pytest.mark.parametrize("other", [2.0, 2 + 0j, np.float32(2.0), np.int8(2)])
def test_equal_numbers_have_one_token_in_any_value(other: Any) -> None:
    assert Kept(2) == Kept(other)
    assert tokenize(Kept(2)) == tokenize(Kept(other)) != tokenize(Kept(2.5))


def test_a_number_that_single_precision_rounds_is_another_number() -> None:
    """NumPy calls them equal, though they have other hashes."""
    assert Kept(1.1) != Kept(np.float32(1.1))


def test_joblib_knows_a_picture_and_its_copy_as_one() -> None:
    picture = nc.render("paper", size=8, samples=1)
    assert hash_of(pickle.loads(pickle.dumps(picture))) == hash_of(picture)


@each_result
def test_dask_knows_equal_results_by_one_token(result: Any) -> None:
    token = tokenize(result)
    assert [tokenize(other) for other in copies(result)] == [token] * (3 + pickle.HIGHEST_PROTOCOL)


def test_an_array_of_a_stack_cannot_be_unlocked() -> None:
    stack = nc.LayerStack(np.array([400.0, 500.0]))
    with pytest.raises(ValueError, match="cannot set WRITEABLE"):
        stack.thickness_nm.flags.writeable = True


def test_a_deep_copy_of_a_stack_has_the_same_media() -> None:
    stack = nc.LayerStack([400.0], protein=functools.partial(np.full_like, fill_value=1.5))
    assert copy.deepcopy(stack) == stack
    assert hash(copy.deepcopy([stack])[0]) == hash(stack)


class Uniform(nc.LayerStack):
    """Layers all alike, with an `__init__` of its own."""

    def __init__(self, layers: int, label: str) -> None:
        super().__init__([380.0] * layers)
        object.__setattr__(self, "label", label)


def test_a_stacks_sub_class_copies_and_pickles_with_what_it_keeps_beside() -> None:
    stack = Uniform(5, "five")
    for other in copies(stack):
        assert type(other) is Uniform
        assert other == stack
        assert vars(other)["label"] == "five"


def test_results_of_every_kind_of_film_cannot_be_unlocked() -> None:
    covered = nc.LayerStack([380.0, 395.0], [18.0, 25.0], cover=[(1.48, 2000.0)])
    for light in (
        nc.optics.energies(covered, [0.0, 0.5], [450.0, 550.0]),
        nc.optics.energies(nc.LayerStack([400.0]), 0.0, [450.0], coherence_nm=5000.0),
        nc.optics.on_plate(covered, 1.0, [0.0, 0.5], [450.0, 550.0]),
    ):
        for share in arrays(light):
            with pytest.raises(ValueError, match="WRITEABLE"):
                share.flags.writeable = True


def test_an_array_that_its_owner_could_unlock_is_copied() -> None:
    layers = np.array([400.0, 500.0])
    layers.flags.writeable = False
    stack = nc.LayerStack(layers)
    layers.flags.writeable = True
    layers[0] = 7.0
    assert stack.thickness_nm[0] == 400.0
