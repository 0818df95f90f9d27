"""Running kept machine code by the runtime below JAX (`jaxlib`), which loads in a tenth of the time that JAX takes."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from functools import cache
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

Leaf = NDArray[Any]

os.environ.setdefault("TF_CPP_MIN_LOG_LEVEL", "1")  # as JAX does, before it is loaded: the runtime greets at level 0

UNUSABLE = (AttributeError, KeyError, NotImplementedError, RuntimeError, TypeError, ValueError)
"""What loading raises when an entry or this module does not fit the runtime."""


class _Kind(NamedTuple):
    """Shape and type of an array, as the runtime asks for them."""

    shape: tuple[int, ...]
    dtype: np.dtype[Any]
    weak_type: bool = False


@cache
def _runtime() -> tuple[Any, Any, Any]:
    """Return the client, its device, and the sharding of what lies on that whole."""
    from jaxlib import xla_client

    def whole(_sharding: Any, _axes: int) -> Any:
        return xla_client.HloSharding.replicate()

    # "On one device, as a whole", with the two parts that the runtime asks for and JAX's own class would add.
    here: Any = type("Here", (xla_client.SingleDeviceSharding,), {"memory_kind": None, "_to_xla_hlo_sharding": whole})
    client = xla_client.make_cpu_client()
    device = client.local_devices()[0]
    return client, device, here(device)


def dump(compiled: Any) -> tuple[dict[str, Any], bytes]:
    """Return what `load` needs of a program that JAX compiled: shapes and types of its results, and its machine code."""
    results = [[list(info.shape), np.dtype(info.dtype).str] for info in compiled.out_info]
    return {"results": results}, compiled.runtime_executable().serialize()


def load(about: dict[str, Any], code: bytes) -> Callable[[Sequence[Leaf]], list[Leaf]]:
    """Return a program from its machine code.

    Raises:
        UNUSABLE: It does not fit this runtime.
    """
    from jaxlib import _jax, xla_client  # type: ignore[attr-defined]

    client, device, sharding = _runtime()
    executable = client.deserialize_executable(code, executable_devices=xla_client.DeviceList((device,)))
    kinds = [_Kind(tuple(shape), np.dtype(kind)) for shape, kind in about["results"]]
    handlers = [_jax.array_result_handler(kind, sharding, True, True) for kind in kinds]
    during_call = _jax.HostBufferSemantics.IMMUTABLE_ONLY_DURING_CALL

    def put(value: Leaf) -> Any:
        value = np.ascontiguousarray(value).reshape(value.shape)
        kind = _Kind(value.shape, value.dtype)
        return _jax.batched_device_put(kind, sharding, [value], [device], True, False, during_call, True)

    def run(values: Sequence[Leaf]) -> list[Leaf]:
        results = executable.execute_sharded([put(value) for value in values]).consume_with_handlers(handlers)
        return [np.array(memoryview(result)) for result in results]

    return run
