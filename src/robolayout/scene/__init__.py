"""The nouns: what is given (room, assets, agents) and what comes out (poses)."""

from robolayout.scene.agent import DEFAULT_AGENT, Agent, Source
from robolayout.scene.asset import FLAT_HEIGHT, Asset, variable_name
from robolayout.scene.layout import Layout, Pose, Snapshot, Trace, vertical_span
from robolayout.scene.room import LANDING_DEPTH, Opening, Point, Room, Wall
from robolayout.scene.scene import Scene

__all__ = [
    "DEFAULT_AGENT",
    "FLAT_HEIGHT",
    "LANDING_DEPTH",
    "Agent",
    "Asset",
    "Layout",
    "Opening",
    "Point",
    "Pose",
    "Room",
    "Scene",
    "Snapshot",
    "Source",
    "Trace",
    "Wall",
    "variable_name",
    "vertical_span",
]
