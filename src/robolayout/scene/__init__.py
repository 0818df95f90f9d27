"""The nouns: what is given (room, assets, agents) and what comes out (poses)."""

from robolayout.scene.agent import DEFAULT_AGENT, Agent, Figure, Hold
from robolayout.scene.agents_io import agent_from_dict, agent_names, agent_to_dict, load_agent, load_agents
from robolayout.scene.asset import FLAGS, FLAT_HEIGHT, Asset, program_variable, split_name, variable_name
from robolayout.scene.io import (
    check_dress,
    check_layout,
    digest,
    layout_digest,
    layout_from_dict,
    load_layout,
    load_scene,
    scene_digest,
    scene_from_dict,
    scene_to_dict,
)
from robolayout.scene.layout import Layout, Pose, Snapshot, Trace, vertical_span
from robolayout.scene.room import OPENINGS, ROUNDING, Leaf, Opening, Point, Room, Wall
from robolayout.scene.scene import DRESSINGS, Scene

__all__ = [
    "DEFAULT_AGENT", "DRESSINGS", "FLAGS", "FLAT_HEIGHT", "OPENINGS", "ROUNDING", "Agent", "Asset", "Figure", "Hold",
    "Layout", "Leaf", "Opening", "Point", "Pose", "Room", "Scene", "Snapshot", "Trace", "Wall", "agent_from_dict",
    "agent_names", "agent_to_dict", "check_dress", "check_layout", "digest", "layout_digest", "layout_from_dict",
    "load_agent", "load_agents", "load_layout", "load_scene", "program_variable", "scene_digest", "scene_from_dict",
    "scene_to_dict", "split_name", "variable_name", "vertical_span",
]  # fmt: skip
