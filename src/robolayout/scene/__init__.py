"""The nouns: what is given (room, assets, agents) and what comes out (poses)."""

from robolayout.scene.agent import DEFAULT_AGENT, Agent, Source
from robolayout.scene.agents_io import agent_from_dict, agent_names, agent_to_dict, load_agent, load_agents
from robolayout.scene.asset import FLAT_HEIGHT, Asset, program_variable, split_name, variable_name
from robolayout.scene.digest import digest, layout_digest, scene_digest
from robolayout.scene.io import check_dress, layout_from_dict, load_layout, load_scene, scene_from_dict, scene_to_dict
from robolayout.scene.layout import Layout, Pose, Snapshot, Trace, vertical_span
from robolayout.scene.room import LANDING_DEPTH, Opening, Point, Room, Wall
from robolayout.scene.scene import DRESSINGS, Scene

__all__ = [
    "DEFAULT_AGENT",
    "DRESSINGS",
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
    "agent_from_dict",
    "agent_names",
    "agent_to_dict",
    "check_dress",
    "digest",
    "layout_digest",
    "layout_from_dict",
    "load_agent",
    "load_agents",
    "load_layout",
    "load_scene",
    "program_variable",
    "scene_digest",
    "scene_from_dict",
    "scene_to_dict",
    "split_name",
    "variable_name",
    "vertical_span",
]
