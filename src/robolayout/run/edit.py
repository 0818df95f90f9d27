"""Editing: a layout to start from, and what of it stays."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from robolayout._errors import InputError, UnknownNameError
from robolayout.program import Guess
from robolayout.scene import Layout, Pose, Scene, layout_from_dict, load_layout


def as_start(scene: Scene, start: Layout | Mapping[str, Any] | str | Path) -> Layout:
    """Return the layout to start from, checked against its scene."""
    if isinstance(start, str | Path):
        return load_layout(start, scene)
    checked = layout_from_dict(start.to_dict() if isinstance(start, Layout) else start, scene)
    return Layout({name: start[name] for name in checked}) if isinstance(start, Layout) else checked


def pinned_poses(scene: Scene, start: Layout | None, keep: Sequence[str], free: Sequence[str]) -> dict[str, Pose]:
    """Return the poses that stay, of what is to be kept or of all that is not free."""
    for name in (*keep, *free):
        if name not in scene.by_name:
            raise UnknownNameError("asset", name, scene.by_name)
    if keep and free:
        raise InputError("keep and free exclude each other: name what stays, or name all that may move.")
    if start is None:
        if keep or free:
            raise InputError("keep and free need a layout to start from: give one (--from layout.json, start=layout).")
        return {}
    for name in keep:
        if name not in start:
            raise InputError(f"{name!r} cannot be kept: the layout to start from does not place it.")
    staying = set(keep) or (set(start) - set(free) if free else set[str]())
    return {name: start[name] for name in start if name in staying}


def guesses_of(layout: Layout) -> dict[str, Guess]:
    """Return the poses of a layout as guesses."""
    return {name: Guess((pose.x, pose.y, pose.z), pose.yaw) for name, pose in layout.items()}
