"""Many rooms: datasets by one command, as a sequence in a training loop, and any folder of rooms evaluated."""

from __future__ import annotations

from typing import TYPE_CHECKING

from robolayout._lazy import loader

if TYPE_CHECKING:
    from robolayout.many.dataset import batch
    from robolayout.many.evaluation import evaluate, write_evaluation
    from robolayout.many.room import Rooms, rooms
    from robolayout.many.spec import Spec, read_spec

__all__ = ["Rooms", "Spec", "batch", "evaluate", "read_spec", "rooms", "write_evaluation"]
__getattr__ = loader(__name__, __file__)  # one room is compared with others without the rest of it
