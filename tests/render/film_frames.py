"""The frames of a GIF as arrays, for the tests of animations."""

from __future__ import annotations

import io

import numpy as np
from PIL import Image


def frames(data):
    """Return each frame's pixels and its milliseconds."""
    image = Image.open(io.BytesIO(data))
    found = []
    for k in range(image.n_frames):
        image.seek(k)
        found.append((np.asarray(image.convert("RGB"), dtype=int), image.info["duration"]))
    return found
