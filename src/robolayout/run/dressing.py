"""Small things put into a finished room, each of them judged, and the judged room with them."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from robolayout.run.attempt import Clock
from robolayout.scene import DRESSINGS, Layout
from robolayout.solve import Dressed, dress
from robolayout.verify import physics, verify

if TYPE_CHECKING:
    from robolayout.run.result import Result


def dressed(result: Result, amount: str, *, seed: int) -> Result:
    """Return a run's room with small things on its surfaces (`DRESSINGS`); what the judge does not pass is left out."""
    clock = Clock()
    with clock.station("dress"):
        found = _passed(result.layout, dress(result.scene, result.layout, amount, seed=seed))
    if not found.names:
        return result
    new, old = verify(found.scene, found.layout), result.report
    scene = replace(found.scene, dress=DRESSINGS[0])  # it is done
    report = replace(old, scene=scene, layout=found.layout, physics=new.physics, agents=new.agents)
    return replace(result, scene=scene, layout=found.layout, report=report.with_timing(clock.seconds))


def _passed(before: Layout, found: Dressed) -> Dressed:
    """Return a dressed room without the small things that the judge does not pass."""
    astray = set(physics(found.scene, found.layout).failing) - set(before)
    if not astray:
        return found
    assets = tuple(asset for asset in found.scene.assets if asset.name not in astray)
    layout = Layout({name: pose for name, pose in found.layout.items() if name not in astray})
    scene = replace(found.scene, assets=assets)
    return Dressed(scene, layout, tuple(name for name in found.names if name not in astray))
