"""What is done for a solution that is not right: it is mended for longer, and other ways of what its program leaves open are tried."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from itertools import islice

from robolayout.program import Program
from robolayout.run.result import Progress
from robolayout.run.verdict import make_judge
from robolayout.scene import Pose, Scene
from robolayout.solve import EFFORTS, Solution, Solver, SolverConfig, askew, compile_problem, silent, solve_with


@dataclass(frozen=True)
class Bettering:
    """How many ways are looked at."""

    ways: int = 6  # most ways of open statements (the corners of a room) that are tried where one is not met
    solved: int = 3  # how many of them, nearest to right as built, are searched
    again: int = 2  # attempts at building each, where whole rooms are built up to twelve times
    worse: float = 2.0  # `Verdict.promise` by which these may be worse than what is to be bettered: they are to be mended, not made


BETTERING = Bettering()


def bettered(
    scene: Scene,
    program: Program,
    best: Solution,
    *,
    seed: int,
    config: SolverConfig | None,
    pinned: Mapping[str, Pose] | None = None,
    progress: Progress | None = None,
) -> Solution:
    """Return the best of a solution, mended for longer, and those with other ways of what the program leaves open.

    Other ways are for rooms that lack little but a statement. They begin with the room as it stands, which is soon done, and then
    with rooms that are built for them; of equals the one with the fewest things askew is taken.
    """
    judge, config = make_judge(scene, program), config or SolverConfig()
    if best.verdict.broken and not any(guess.position is not None for guess in program.guesses.values()):
        problem = replace(
            compile_problem(scene, program, seed=seed, pinned=pinned, built=best.layout), guess=best.layout
        )
        longer = Solver(problem, judge, config, seed=seed, progress=progress or silent).mend()
        best = min(best, replace(longer, trace=best.trace), key=lambda one: one.verdict.merit)
    # drawers that stay shut are no statements
    hopeless = config.effort.hopeless(best.verdict.broken, len(scene.assets))
    if hopeless or _said_holds(scene, program, best):
        return best
    brief = replace(config, effort=config.effort.at_most(EFFORTS["quick"]))
    ways = [*islice(_ways(scene, program, best), BETTERING.ways)]

    def rank(found: Solution) -> tuple[float, int]:
        return found.verdict.merit, sum(askew(scene.room, pose.yaw) != 0.0 for pose in found.layout.values())

    before = rank(best)[1]
    for built in (best.layout, None) if len(program.guesses) < len(scene.assets) else (None,):
        problems = [
            compile_problem(scene, way, seed=seed, pinned=pinned, built=built, attempts=BETTERING.again) for way in ways
        ]
        ranked = sorted((judge(one.guess).promise, i) for i, one in enumerate(problems))[: BETTERING.solved]
        ways = [ways[i] for _, i in ranked]  # whole rooms are built for these alone
        for problem in (problems[i] for amiss, i in ranked if amiss <= best.verdict.promise + BETTERING.worse):
            found = solve_with("default", problem, judge, seed=seed, config=brief, progress=progress)
            best = min(best, found, key=rank)
            if _said_holds(scene, program, best) and rank(best)[1] <= before:
                return best
    return best


def _said_holds(scene: Scene, program: Program, found: Solution) -> bool:
    """Return whether every statement of a program holds in what was found."""
    return all(one.relation.check(scene, found.layout).met for one in program.statements)


def _ways(scene: Scene, program: Program, found: Solution) -> Iterator[Program]:
    """Yield a program with each way of a statement that leaves one open (a corner) and is about something to blame."""
    blamed = set(found.verdict.culprits)
    for i, statement in enumerate(program.statements):
        if blamed.intersection(statement.relation.asset_names()):
            for way in statement.relation.ways(scene):
                settled = (replace(statement, relation=one) for one in way)
                changed = (*program.statements[:i], *settled, *program.statements[i + 1 :])
                yield replace(program, statements=changed)
