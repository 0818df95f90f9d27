"""The scene: everything that is given before anything is placed."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, field, replace
from functools import cached_property

from robolayout._errors import SceneError
from robolayout.scene.agent import DEFAULT_AGENT, Agent
from robolayout.scene.agents_io import check_headroom
from robolayout.scene.asset import Asset, by_variable
from robolayout.scene.room import Room

DRESSINGS = ("none", "some", "full")  # how much may lie about on the surfaces of a room


@dataclass(frozen=True)
class Scene:
    """What is given: a room, assets, an instruction and one or more agents."""

    room: Room
    assets: tuple[Asset, ...]  # everything to be placed, in the order of the file
    task_description: str = ""  # the instruction in plain language
    layout_criteria: str = ""  # what the result should be like, in plain language
    agents: tuple[Agent, ...] = (DEFAULT_AGENT,)  # the bodies that the layout must serve
    dress: str = "none"  # how much lies about on its surfaces once it is furnished: one of `DRESSINGS`
    name: str = "scene"  # short name, from the file's name
    warnings: tuple[str, ...] = field(default=(), compare=False)  # what was mended on reading, one sentence each

    def __post_init__(self) -> None:
        if not self.agents:
            raise SceneError("agents is empty; name at least one body or leave it out for a disc of radius 0.30 m.")
        if twice := [name for name, count in Counter(asset.name for asset in self.assets).items() if count > 1]:
            raise SceneError(f"two assets are called {twice[0]!r}; give each its own name.")

    @property
    def agent(self) -> Agent:
        """The first agent."""
        return self.agents[0]

    @cached_property
    def by_name(self) -> dict[str, Asset]:
        """Assets by name."""
        return {asset.name: asset for asset in self.assets}

    @cached_property
    def variables(self) -> dict[str, tuple[Asset, ...]]:
        """Assets by program variable, in the order of their index."""
        return by_variable(self.assets)

    @cached_property
    def expressions(self) -> dict[str, str]:
        """How a program writes each asset, by its name ("night_stand-0": "night_stand[0]"), grouped by variable."""
        return {a.name: f"{variable}[{i}]" for variable, group in self.variables.items() for i, a in enumerate(group)}

    def with_agents(self, *agents: Agent) -> Scene:
        """Return the same scene for other agents, none of which may be higher than the room."""
        check_headroom(agents, self.room)
        return replace(self, agents=agents)
