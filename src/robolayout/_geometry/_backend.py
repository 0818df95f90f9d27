"""Which library works a formula out: NumPy where its arrays go in, JAX where the compiled search traces it."""

from __future__ import annotations

from typing import Any

import numpy as np

Array = Any  # A NumPy or JAX array


def backend(*values: Any) -> Any:
    """Return the module whose functions take some arrays: `numpy` for its own, else `jax.numpy`, loaded when it is needed."""
    if all(isinstance(value, np.ndarray | np.generic) for value in values):
        return np
    import jax.numpy as jnp

    return jnp
