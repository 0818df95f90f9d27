"""Compiled array programs: compiled once per size and machine, then loaded in a third of a second.

JAX only compiles. The machine code is kept (`cache`) and run by the runtime below JAX (`jaxlib`), which loads in a tenth of the
time that JAX takes, so that a process that finds its programs in the cache never imports JAX. Where that runtime is not one that
this was tested with, or a graphics card is at hand, JAX itself runs the program and keeps its own cache.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Hashable, Mapping, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import suppress
from functools import cache
from importlib import import_module
from importlib.util import find_spec
from threading import Lock
from types import SimpleNamespace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from robolayout.solve.cache import cache_folder, entry_key, has_entry, read_entry, write_entry

Leaf = NDArray[Any]
Run = Callable[[Sequence[Leaf]], list[Leaf]]
"""A program: arrays in, arrays out, both in the order of the tuples they come from."""

TESTED = ("0.10.", "0.11.", "0.12.")
"""Versions of the runtime whose inner interface `_loaded` knows."""

OLD = "0.10."
"""The last of them for Python 3.11: its compiler has an option more, its handlers of results an argument more."""

UNUSABLE = (AttributeError, KeyError, NotImplementedError, RuntimeError, TypeError, ValueError)
"""What loading raises when an entry or this module does not fit the runtime."""

OPTIONS: dict[str, Any] = {
    # Measured on the search (16 slots, 8 starts): 4.7 s of CPU to compile and 0.22 s to run with the compiler's defaults.
    "xla_backend_optimization_level": 1,  # a fifth less to compile, as fast to run
    "xla_cpu_multi_thread_eigen": False,  # the same numbers whatever the number of processors
}
"""What the compiler is told for processors."""

OLD_OPTIONS: dict[str, Any] = {"xla_cpu_use_fusion_emitters": False}  # a quarter less to compile, a quarter less to run
"""What it is told besides where it still knows it; a compiler that does not, refuses it."""

CARD_OPTIONS: dict[str, Any] = {"xla_gpu_deterministic_ops": True, "xla_gpu_autotune_level": 0}
"""What it is told for graphics cards: sums in one order and no race between kernels, so that the same input gives the same bytes."""

os.environ.setdefault("TF_CPP_MIN_LOG_LEVEL", "1")  # as JAX does, before it is loaded: the runtime greets at level 0


def call(target: str, *arguments: Any, **constants: Hashable) -> list[Leaf]:
    """Run a function as a compiled program.

    Args:
        target: Module in `robolayout.solve` and function, such as "search:advance".
        arguments: Arrays, or (nested) named tuples of arrays.
        constants: Keyword arguments that the program is compiled for; their `repr` must say all of them.

    Returns:
        The arrays of the result, in the order of its (nested) tuples.
    """
    return programs().future(target, arguments, constants).result()(leaves(arguments))


class Programs(dict[Hashable, "Future[Run]"]):
    """The programs of this process by function, shapes and constants; whoever asks for the same one waits for the same compilation."""

    def __init__(self) -> None:
        super().__init__()
        self._lock = Lock()
        self._workers = ThreadPoolExecutor(max_workers=2, thread_name_prefix="robolayout-compile")

    def future(self, target: str, arguments: tuple[Any, ...], constants: Mapping[str, Hashable]) -> Future[Run]:
        """Return the program for arguments of these shapes, to be waited for."""
        key = _key(target, arguments, constants)
        with self._lock:
            if key not in self:
                self[key] = self._workers.submit(_make, target, arguments, constants)
            return self[key]

    def compile_missing(
        self, target: str, arguments: tuple[Any, ...], constants: Mapping[str, Hashable]
    ) -> Future[None]:
        """Compile in the background what is not in the cache; return when it was looked for there.

        What is there is left alone: loading it takes time from those who may not need it.
        """

        def look() -> None:
            if not _native_runtime() or not has_entry(entry_key(*_key(target, arguments, constants), _options())):
                self.future(target, arguments, constants)

        return self._workers.submit(look)


@cache
def programs() -> Programs:
    """Return the programs of this process."""
    return Programs()


def _key(target: str, arguments: tuple[Any, ...], constants: Mapping[str, Hashable]) -> tuple[Hashable, ...]:
    """Return what tells a program from others: function, shapes and constants."""
    shapes = tuple((leaf.shape, leaf.dtype.str) for leaf in leaves(arguments))
    return target, shapes, tuple(sorted(constants.items()))


def leaves(value: Any) -> list[Leaf]:
    """Return the arrays in nested tuples, in order."""
    if isinstance(value, tuple):
        return [leaf for item in value for leaf in leaves(item)]
    return [np.asarray(value)]


def _make(target: str, arguments: tuple[Any, ...], constants: Mapping[str, Hashable]) -> Run:
    """Return a program from the cache, or compile it."""
    if not _native_runtime():
        _configure_jax()
        return _compiled(target, arguments, constants)[0]
    key = entry_key(*_key(target, arguments, constants), _options())
    entry = read_entry(key)
    if entry is not None:
        with suppress(*UNUSABLE):  # then it is compiled anew and written over
            return _loaded(*entry)
    run, compiled = _compiled(target, arguments, constants)
    results = [[list(info.shape), np.dtype(info.dtype).str] for info in compiled.out_info]
    write_entry(key, {"results": results}, compiled.runtime_executable().serialize())
    return run


def _native_runtime() -> bool:
    """Return whether programs run on the processor, by a runtime that `_loaded` knows."""
    cards = any(find_spec(name) for name in ("jax_cuda12_plugin", "jax_cuda13_plugin", "jax_rocm7_plugin"))
    platforms = os.environ.get("JAX_PLATFORMS", "" if cards else "cpu")
    return platforms == "cpu" and _version().startswith(TESTED)


def _version() -> str:
    """Return the version of the compiler and its runtime."""
    from jaxlib import version

    return version.__version__


def _options() -> dict[str, Any]:
    """Return what this compiler is told for processors."""
    return {**OPTIONS, **(OLD_OPTIONS if _version().startswith(OLD) else {})}


def _configure_jax() -> None:
    """Let JAX keep what it compiles, unless the user told it where to."""
    import jax

    folder = cache_folder()
    if folder is not None and getattr(jax.config, "jax_compilation_cache_dir", None) is None:
        jax.config.update("jax_compilation_cache_dir", str(folder / "jax"))
        jax.config.update("jax_persistent_cache_min_compile_time_secs", 0.0)
        jax.config.update("jax_persistent_cache_min_entry_size_bytes", -1)


def _compiled(target: str, arguments: tuple[Any, ...], constants: Mapping[str, Hashable]) -> tuple[Run, Any]:
    """Trace and compile a function for arguments of these shapes; return it as JAX runs it, and what JAX has of it."""
    import jax

    module, _, name = target.partition(":")
    function = getattr(import_module(f"robolayout.solve.{module}"), name)
    structure = jax.tree.structure(arguments)

    def flat(*values: Any) -> list[Any]:
        return jax.tree.leaves(function(*jax.tree.unflatten(structure, values), **constants))

    specs = [jax.ShapeDtypeStruct(leaf.shape, leaf.dtype) for leaf in leaves(arguments)]
    options = _options() if jax.default_backend() == "cpu" else CARD_OPTIONS
    doubles = any(
        spec.dtype == np.float64 for spec in specs
    )  # JAX must be told as soon as one argument works with them
    with jax.enable_x64(doubles):
        compiled = jax.jit(flat, keep_unused=True).lower(*specs).compile(compiler_options=options)

    def run(values: Sequence[Leaf]) -> list[Leaf]:
        with jax.enable_x64(doubles):
            return [np.asarray(value) for value in compiled(*values)]

    return run, compiled


@cache
def _runtime() -> tuple[Any, Any, Any]:
    """Return the runtime's client, its device, and the sharding of what lies on that whole."""
    from jaxlib import xla_client

    def whole(_sharding: Any, _axes: int) -> Any:
        return xla_client.HloSharding.replicate()

    # "On one device, as a whole", with the two parts that the runtime asks for and JAX's own class would add.
    here: Any = type("Here", (xla_client.SingleDeviceSharding,), {"memory_kind": None, "_to_xla_hlo_sharding": whole})
    client = xla_client.make_cpu_client()
    device = client.local_devices()[0]
    return client, device, here(device)


def _loaded(about: Mapping[str, Any], code: bytes) -> Run:
    """Return a program from its machine code; one of `UNUSABLE` is raised where it does not fit this runtime."""
    from jaxlib import _jax, xla_client  # type: ignore[attr-defined]

    client, device, sharding = _runtime()
    executable = client.deserialize_executable(code, executable_devices=xla_client.DeviceList((device,)))
    # Shapes and types of arrays, as the runtime asks for them.
    kinds = [SimpleNamespace(shape=tuple(s), dtype=np.dtype(d), weak_type=False) for s, d in about["results"]]
    unchecked = (True,) if _version().startswith(OLD) else ()
    handlers = [_jax.array_result_handler(kind, sharding, True, *unchecked) for kind in kinds]
    during_call = _jax.HostBufferSemantics.IMMUTABLE_ONLY_DURING_CALL

    def put(value: Leaf) -> Any:
        value = np.ascontiguousarray(value).reshape(value.shape)
        kind = SimpleNamespace(shape=value.shape, dtype=value.dtype, weak_type=False)
        return _jax.batched_device_put(kind, sharding, [value], [device], True, False, during_call, True)

    def run(values: Sequence[Leaf]) -> list[Leaf]:
        results = executable.execute_sharded([put(value) for value in values]).consume_with_handlers(handlers)
        return [np.array(memoryview(result)) for result in results]

    return run
