"""A body learns to drive in rooms that are certified for it: every reset is another room, made when it is needed.

    python examples/room_env.py

The environment has the methods of Gymnasium's (`reset` and `step` with their five values) and needs only MuJoCo (extra
`sim`). The body drives from the door to a thing of the room that the report says it can reach; it sees where the thing is
from where it stands, and how far the nearest obstacle is in sixteen directions.
"""

from __future__ import annotations

import math
from typing import Any

import mujoco
import numpy as np

import robolayout as rl
from robolayout.export import EXPORTERS, Options

SPEC = {"rooms": ["bedroom", "living room", "office"], "bodies": ["turtlebot4"], "count": 1000}
RAYS = 16
"""Directions in which the body looks."""
FAR = 5.0
"""Metres that it sees at most."""
SPEED = (0.5, 1.5)
"""Metres and radians a second at full action."""
STEP = 0.1
"""Seconds of one step."""
LIMIT = 600
"""Steps of an episode."""


class RoomEnv:
    """One body in one room after the other.

    Args:
        spec: What rooms there are; see docs/many.md.
        seed: Settles the rooms and the goals.
    """

    def __init__(self, spec: Any = SPEC, seed: int = 0) -> None:
        self.rooms = rl.rooms(spec, seed=seed)
        self.rng = np.random.default_rng(seed)

    def reset(self, *, seed: int | None = None, options: Any = None) -> tuple[np.ndarray, dict[str, Any]]:
        """Put the body at the door of a new certified room; a seed is the number of the room."""
        number = int(self.rng.integers(len(self.rooms))) if seed is None else seed % len(self.rooms)
        room = self.rooms[number]
        body = room.report.agents[0]
        routes = {name: route.points for name, route in body.navigation.routes.items() if len(route.points) > 1}
        self.goal = sorted(routes)[int(self.rng.integers(len(routes)))]
        self.route, self.reach = routes[self.goal], body.agent.reach
        self.radius = body.agent.radius
        xml, files = EXPORTERS["mjcf"].files(room.scene, room.layout, Options())
        self.model = mujoco.MjModel.from_xml_string(xml.decode(), files)
        self.data = mujoco.MjData(self.model)
        mujoco.mj_forward(self.model, self.data)
        self.place, self.steps = np.array(self.route[0], dtype=float), 0
        ahead = np.array(self.route[1]) - self.place
        self.yaw = math.atan2(ahead[1], ahead[0])
        return self._seen(), {"room": number, "goal": self.goal, "things": len(room.scene.assets)}

    def step(self, action: np.ndarray) -> tuple[np.ndarray, float, bool, bool, dict[str, Any]]:
        """Drive for a moment: forward speed and turn, each from -1 to 1."""
        speed, turn = (float(value) for value in np.clip(action, -1.0, 1.0))
        before, self.steps = self._distance(), self.steps + 1
        self.yaw += turn * SPEED[1] * STEP
        ahead = np.array([math.cos(self.yaw), math.sin(self.yaw)])
        free = self._free(ahead if speed >= 0 else -ahead) - self.radius
        travelled = float(np.clip(abs(speed) * SPEED[0] * STEP, 0.0, max(free, 0.0)))
        self.place = self.place + math.copysign(travelled, speed) * ahead
        there = self._distance() < 0.15
        bumped = free <= 0.0
        reward = before - self._distance() + 10.0 * there - 0.1 * bumped
        return self._seen(), reward, there, self.steps >= LIMIT, {"bumped": bumped}

    def _distance(self) -> float:
        """Return how far the end of the route is."""
        return float(np.linalg.norm(np.array(self.route[-1]) - self.place))

    def _seen(self) -> np.ndarray:
        """Return where the goal is from the body, and how far obstacles are."""
        away = np.array(self.route[-1]) - self.place
        angle = math.atan2(away[1], away[0]) - self.yaw
        looks = self.yaw + 2 * math.pi * np.arange(RAYS) / RAYS
        free = [self._free(np.array([math.cos(look), math.sin(look)])) for look in looks]
        return np.array([np.linalg.norm(away), math.cos(angle), math.sin(angle), *free], dtype=np.float32)

    def _free(self, way: np.ndarray) -> float:
        """Return how far the nearest thing is in a direction, a hand above the floor."""
        start, hit = np.array([*self.place, 0.1]), np.zeros(1, dtype=np.int32)
        found = mujoco.mj_ray(self.model, self.data, start, np.array([*way, 0.0]), None, 1, -1, hit)
        return FAR if found < 0 else min(float(found), FAR)


def along(env: RoomEnv) -> np.ndarray:
    """Return the action of a driver that follows the certified route."""
    points = np.array(env.route)
    nearest = int(np.argmin(np.linalg.norm(points - env.place, axis=1)))
    away = points[min(nearest + 1, len(points) - 1)] - env.place
    error = (math.atan2(away[1], away[0]) - env.yaw + math.pi) % (2 * math.pi) - math.pi
    return np.array([max(0.0, math.cos(error)) ** 4, np.clip(4.0 * error, -1.0, 1.0)])


def main(episodes: int = 3) -> None:
    """Drive a few episodes along the certified routes, and say how they ended."""
    env = RoomEnv()
    for episode in range(episodes):
        _, info = env.reset(seed=episode)
        done = late = False
        total, bumps = 0.0, 0
        while not (done or late):
            _, reward, done, late, told = env.step(along(env))
            total, bumps = total + reward, bumps + told["bumped"]
        end = f"there after {env.steps * STEP:.1f} s" if done else "not there"
        print(
            f"room {info['room']} ({info['things']} things), to {info['goal']}: {end}, {bumps} bumps, reward {total:.1f}"
        )


if __name__ == "__main__":
    main()
