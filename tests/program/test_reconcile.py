"""The self-consistency filter: one decision for every statement, each rule by its words, and laws over random programs."""

import math

import pytest
from furnished_room import furnished
from hypothesis import example, given, settings
from hypothesis import strategies as st

from robolayout.constraints import AssetRef, PointRef, Relation, WallRef
from robolayout.constraints.against_wall import AgainstWall
from robolayout.constraints.align_with import AlignWith
from robolayout.constraints.around import Around
from robolayout.constraints.ceiling_above import CeilingAbove
from robolayout.constraints.centered_on import CenteredOn
from robolayout.constraints.corner import Corner
from robolayout.constraints.distance_constraint import DistanceConstraint
from robolayout.constraints.facing_pair import FacingPair
from robolayout.constraints.mounted_on import MountedOn
from robolayout.constraints.next_to import NextTo
from robolayout.constraints.on_top_of import OnTopOf
from robolayout.constraints.point_towards import PointTowards
from robolayout.constraints.row import Row
from robolayout.constraints.symmetric_pair import SymmetricPair
from robolayout.constraints.under import Under
from robolayout.program import Decision, Guess, Program, Reconciled, Statement, read_program, reconcile
from robolayout.scene import Asset, Room, Scene

MORE = (
    Asset("sofa-0", "sofa", (0.9, 2.2, 0.8)),
    Asset("counter-0", "counter", (0.6, 3.4, 0.9)),
    Asset("bench-0", "bench", (0.4, 6.0, 0.5)),
    Asset("tower-0", "tower", (0.3, 0.3, 2.3)),
    *[Asset(f"shelf-{i}", "shelf", (0.3, 1.2, 2.0)) for i in range(3)],
)
WIDE = furnished(*MORE)


def decide(*calls: str, paper: bool = False, scene: Scene = WIDE, before: str = "") -> tuple[Decision, ...]:
    """Return the decisions about `solver.` calls."""
    text = before + "".join(f"solver.{call}\n" for call in calls)
    return reconcile(read_program(text, scene), scene, paper=paper).decisions


def last(*calls: str, **options) -> tuple[str, str, str | None]:
    """Return verdict, reason and replacement of the last call."""
    decision = decide(*calls, **options)[-1]
    return decision.verdict, decision.reason, decision.replacement and decision.replacement.relation.sentence()


REJECTED = {
    (
        "against_wall(bed[0], walls[0])",
        "against_wall(bed[0], walls[1])",
    ): "bed-0 is already at walls[0]; a thing has one wall",
    ("mounted_on(picture[0], walls[0])", "against_wall(picture[0], walls[1])"): "picture-0 is already at walls[0]",
    ("next_to(chair[0], bed[0], 'left')", "next_to(chair[0], bed[0], 'right')"): (
        "it repeats next_to(chair-0, bed-0, left) (line 1); the first one counts"
    ),
    (
        "distance_constraint(bed[0], table[0], 1, 2)",
        "distance_constraint(table[0], bed[0], 1, 3)",
    ): "it repeats distance",
    (
        "symmetric_pair(chair[0], chair[1], bed[0])",
        "symmetric_pair(chair[1], chair[0], bed[0])",
    ): "it repeats symmetric",
    ("corner(chair[0], 1)", "corner(chair[0], 2)"): "chair-0 already has a corner",
    ("point_towards(chair[0], bed[0])", "align_with(chair[0], table[0])"): (
        "chair-0 is already turned by point_towards(chair-0, bed-0) (line 1); the first one counts"
    ),
    ("against_wall(bed[0], walls[1])", "point_towards(bed[0], table[0])"): "bed-0 is already turned by against_wall",
    ("point_towards(bed[0], table[0])", "against_wall(bed[0], walls[1])"): "bed-0 is already turned by point_towards",
    ("point_towards(chair[0], bed[0])", "around(chair, table[0])"): "chair-0 is already turned by point_towards",
    ("point_towards(chair[0], table[0], 180)", "around(chair, table[0])"): "chair-0 is already turned by point_towards",
    ("around(chair, table[0])", "point_towards(chair[2], table[0])"): "chair-2 is already turned by around",
    ("against_wall(bench[0], walls[1])",): "walls[1] has 5.00 m, bench-0 needs 6.00 m, and no other wall can hold it",
    ("against_wall(shelf[0], walls[0])", "row(shelf, walls[0])"): "need 3.60 m, and no other wall can hold them",
    ("facing_pair(bed[0], bed[0])",): "bed-0 is named twice; nothing stands in a relation to itself",
    ("around([chair[0], chair[1], chair[0]], table[0])",): "chair-0 is named twice",
    ("on_top_of(lamp[0], table[0])", "on_top_of(lamp[0], night_stand[0])"): "lamp-0 already stands on table-0",
    (
        "on_top_of(lamp[0], table[0])",
        "on_top_of(table[0], lamp[0])",
    ): "lamp-0 stands on table-0, so table-0 cannot stand on",
    ("on_top_of(bed[0], night_stand[0])",): (
        "bed-0 (2.00 x 1.60 m) is too large for the top of night_stand-0 (0.45 x 0.40 m)"
    ),
    ("on_top_of(tower[0], table[0])",): "on table-0, tower-0 would reach 3.05 m, above the ceiling at 2.60 m",
    ("on_top_of(picture[0], table[0])",): "picture-0 hangs at a wall; it does not stand on things",
    ("on_top_of(pendant[0], table[0])",): "pendant-0 hangs from the ceiling, so on_top_of does not apply to it",
    ("on_top_of(lamp[0], pendant[0])",): "pendant-0 hangs from the ceiling and carries nothing",
    ("against_wall(pendant[0], walls[0])",): "pendant-0 hangs from the ceiling, so against_wall does not apply to it",
    ("row([pendant[0], chair[0]], walls[0])",): "pendant-0 hangs from the ceiling, so row does not apply to it",
    ("mounted_on(bed[0], walls[0])",): "bed-0 does not hang at walls; against_wall puts it there",
    ("ceiling_above(table[0])",): "table-0 does not hang from the ceiling",
    ("under(table[0], chair)",): "0.75 m high and does not fit under chair-0: nothing that wide and deep does",
    ("under(rug[0], [pendant[0]])",): "pendant-0 hangs from the ceiling; nothing lies under it",
    ("centered_on(chair[0], table[0])",): "chair-0 and table-0 would be in the same place",
    ("facing_pair(chair[0], chair[1])", "facing_pair(chair[0], chair[1])"): "it repeats facing_pair",
    (
        "align_with(chair[0], bed[0])",
        "align_with(chair[1], bed[0])",
        "facing_pair(chair[0], chair[1])",
    ): "chair-0 is already",
}


@pytest.mark.parametrize(("calls", "reason"), REJECTED.items(), ids=range(len(REJECTED)))
def test_what_contradicts_is_rejected_with_the_reason(calls, reason):
    verdict, words, replacement = last(*calls)
    assert (verdict, replacement) == ("rejected", None)
    assert reason in words


UPDATED = {
    ("against_wall(long[0], walls[0])",): (
        "walls[0] has 2.90 m beside its door, long-0 needs 4.20 m; walls[1] is the nearest that can hold it",
        "against_wall(long-0, walls[1])",
    ),
    ("against_wall(counter[0], walls[2])", "against_wall(sofa[0], walls[2])"): (
        "walls[2] has 4.00 m, of which counter-0 takes 3.40 m; walls[1] is the nearest that can hold it",
        "against_wall(sofa-0, walls[1])",
    ),
    ("row(shelf, walls[0], gap=0.1)",): (
        "walls[0] has 2.90 m beside its door, shelf-0 and shelf-1 and shelf-2 need 3.80 m; walls[1] is the nearest",
        "row([shelf-0, shelf-1, shelf-2], walls[1], gap=0.1)",
    ),
    ("row([shelf[0], counter[0], sofa[0]], walls[0])",): (
        "need 6.80 m, and no other wall can hold them, so the row has none",
        "row([shelf-0, counter-0, sofa-0])",
    ),
    ("facing_pair(chair[0], chair[1])", "facing_pair(chair[1], chair[2])"): (
        "chair-1 is already turned by facing_pair(chair-0, chair-1) (line 1), so only chair-2 turns",
        "point_towards(chair-2, chair-1)",
    ),
    ("on_top_of(table[0], rug[0])",): (
        "rug-0 is flat: table-0 stands on the floor and the rug lies under it",
        "under(rug-0, [table-0])",
    ),
    ("distance_constraint(chair[0], table[0], 0, 0.1, weight=2)",): (
        "the centres of chair-0 and table-0 are at least 0.65 m apart, so max_distance becomes that",
        "distance_constraint(chair-0, table-0, min_distance=0, max_distance=0.65, weight=2)",
    ),
    ("distance_constraint(chair[0], chair[1], 9, 12)",): (
        "the centres of chair-0 and chair-1 are at most 5.90 m apart here, so min_distance becomes that",
        "distance_constraint(chair-0, chair-1, min_distance=5.9, max_distance=12)",
    ),
    ("distance_constraint(chair[0], walls[0], None, 0.1)",): (
        "the centre of chair-0 and walls[0] are at least 0.25 m apart",
        "distance_constraint(chair-0, walls[0], max_distance=0.25)",
    ),
    ("distance_constraint(chair[0], (-2, 0), 0, 1)",): (
        "the centre of chair-0 and (-2, 0, 0) are at least 2.25 m apart",
        "distance_constraint(chair-0, (-2, 0, 0), min_distance=0, max_distance=2.25)",
    ),
}


@pytest.mark.parametrize(("calls", "answer"), UPDATED.items(), ids=range(len(UPDATED)))
def test_what_is_impossible_is_mended_and_no_more(calls, answer):
    scene = furnished(*MORE, Asset("long-0", "long", (0.4, 4.2, 1.0)))
    verdict, words, replacement = last(*calls, scene=scene)
    assert verdict == "updated"
    assert answer[0] in words
    assert replacement == answer[1]


ACCEPTED = [
    ("against_wall(bed[0], walls[0])",),
    ("distance_constraint(rug[0], table[0], 0, 0)",),
    ("distance_constraint(pendant[0], table[0], 0, 0.1)",),
    ("distance_constraint(lamp[0], night_stand[0], 0, 0.1)", "on_top_of(lamp[0], night_stand[0])"),
    ("distance_constraint(chair[0], table[0], 0.7, 0.8)",),
    ("distance_constraint(chair[0], (2, 2), 0, 0)",),
    ("distance_constraint(chair[0], walls[0])",),
    ("centered_on(rug[0], table[0])",),
    ("centered_on(picture[0], bed[0])",),
    ("keep_clear(chair[0], 'front')", "keep_clear(chair[0], 'left')"),
    ("point_towards(chair[0], table[0])", "around(chair, table[0])"),
    ("against_wall(shelf[0], walls[1])", "row(shelf, walls[1])"),
    ("align_with(shelf[0], walls[0], 90)", "row(shelf, gap=0.1)"),
    ("align_with(shelf[0], walls[0], 90)", "grid(shelf, 1, 3, 0.5)"),
    ("against_wall(sofa[0], walls[2])", "mounted_on(picture[0], walls[2])", "against_wall(bed[0], walls[2])"),
    ("align_with(chair[0], chair[1])", "align_with(chair[1], chair[0])"),
    (
        "on_top_of(lamp[0], night_stand[0])",
        "on_top_of(night_stand[0], table[0])",
        "distance_constraint(lamp[0], table[0], 0, 0)",
    ),
    ("against_wall(bed[0], walls[1])", "corner(bed[0])"),
]

SECOND_HEADINGS = {
    ("against_wall(bed[0], walls[1])", "align_with(bed[0], walls[1], 90)"): None,
    ("against_wall(bed[0], walls[1])", "align_with(bed[0], walls[1], 99.9)"): None,
    ("against_wall(bed[0], walls[1])", "align_with(bed[0], walls[1], 80.1)"): None,
    ("against_wall(bed[0], walls[1])", "align_with(bed[0], walls[1], 101)"): "walls[1]) (line 1), 11 degrees away",
    ("align_with(bed[0], walls[3])", "against_wall(bed[0], walls[2])"): None,
    ("align_with(bed[0], walls[3])", "against_wall(bed[0], walls[1])"): "walls[3]) (line 1), 90 degrees away",
    (
        "mounted_on(picture[0], walls[2])",
        "align_with(picture[0], walls[0], 90)",
    ): "walls[2]) (line 1), 180 degrees away",
    ("align_with(chair[0], bed[0], 5)", "align_with(chair[1], bed[0])", "align_with(chair[0], chair[1])"): None,
    ("align_with(chair[0], bed[0])", "align_with(chair[1], table[0])", "align_with(chair[0], chair[1])"): "turned by",
    ("against_wall(bed[0], walls[1])", "align_with(table[0], bed[0])", "align_with(table[0], walls[3], 90)"): (
        "table-0 is already turned by align_with(table-0, bed-0) (line 2), 180 degrees away; the first one counts"
    ),
    ("against_wall(bed[0], walls[0])", "point_towards(bed[0], table[0])"): "turned by",
}


@pytest.mark.parametrize("calls", SECOND_HEADINGS, ids=range(len(SECOND_HEADINGS)))
def test_a_second_heading_is_kept_if_it_agrees_within_ten_degrees(calls):
    verdict, words, _ = last(*calls)
    wanted = SECOND_HEADINGS[calls]
    assert (verdict, words) == ("accepted", "as asked") if wanted is None else verdict == "rejected" and wanted in words


@pytest.mark.parametrize(
    ("x", "call", "verdict"),
    [
        (2.0, "point_towards(bed[0], table[0])", "accepted"),
        (2.39, "point_towards(bed[0], table[0])", "accepted"),  # the front of the bed looks at the table's edge
        (2.45, "point_towards(bed[0], table[0])", "rejected"),  # past it, and 13 degrees off its centre
        (3.5, "point_towards(bed[0], walls[0])", "accepted"),  # the front meets the wall, far from its middle
        (2.0, "point_towards(bed[0], walls[3])", "rejected"),
        (2.0, "point_towards(bed[0], table[0], 180)", "rejected"),
        (3.0, "point_towards(bed[0], (3, 0.1))", "accepted"),
        (2.0, "point_towards(bed[0], (0.1, 0.5), 30)", "accepted"),  # it looks 30 degrees to the left of the point
        (2.0, "point_towards(bed[0], (0.1, 0.5), -30)", "rejected"),
    ],
)
def test_what_looks_at_something_agrees_with_a_wall_where_the_guesses_say_so(x, call, verdict):
    """A bed at walls[2], the far one, looks along -y; the table stands 2 m before (2, 4)."""
    places = f"bed[0].position = [{x}, 4, 0.25]\ntable[0].position = [2, 2, 0.4]\n"
    assert last("against_wall(bed[0], walls[2])", call, before=places)[0] == verdict


@pytest.mark.parametrize(
    ("second", "verdict"),
    [
        ("align_with(chair[0], walls[0], 120)", "accepted"),  # far from the middle of what it meets
        ("align_with(chair[0], walls[0], 90)", "rejected"),  # along the wall
        ("align_with(chair[0], chair[1])", "accepted"),  # which looks at the wall, too, from elsewhere
    ],
)
def test_a_front_that_shall_meet_a_wall_has_a_choice_of_headings(second, verdict):
    """Whichever is said first: neither contradicts the other."""
    places = "chair[0].position = [1, 1, 0.45]\nchair[1].position = [1, 4.4, 0.45]\n"
    looks = ("point_towards(chair[1], walls[3])", "point_towards(chair[0], walls[3])")
    assert last(*looks, second, before=places)[0] == verdict
    if verdict == "accepted":
        assert [decision.verdict for decision in decide(looks[0], second, looks[1], before=places)] == [verdict] * 3


@pytest.mark.parametrize("calls", ACCEPTED, ids=range(len(ACCEPTED)))
def test_what_can_be_true_is_left_alone(calls):
    assert [(d.verdict, d.reason, d.replacement) for d in decide(*calls)] == [("accepted", "as asked", None)] * len(
        calls
    )


def test_a_distance_is_never_fitted_to_the_guess():
    far_apart = "chair[0].position = [0.5, 0.5, 0.45]\ntable[0].position = [3.5, 4.5, 0.4]\n"
    assert last("distance_constraint(chair[0], table[0], 0.7, 0.8)", before=far_apart) == ("accepted", "as asked", None)


def test_paper_mode_takes_the_wall_nearest_to_the_guess():
    """By its segment: in an L-shaped room the line of a far wall may run past a nearer place."""
    room = Room(((0, 0), (6, 0), (6, 2), (2, 2), (2, 6), (0, 6)), 2.6)
    scene = Scene(room, (Asset("chair-0", "chair", (0.5, 0.5, 0.9)),))
    guess = "chair[0].position = [1.7, 5.0, 0.45]\n"
    call = "against_wall(chair[0], walls[0])"
    assert last(call, scene=scene, before=guess) == ("accepted", "as asked", None)
    assert last(call, scene=scene, paper=True) == ("accepted", "as asked", None)
    assert last(call, scene=scene, before=guess, paper=True) == (
        "updated",
        "walls[3] is the nearest to the first guess",
        "against_wall(chair-0, walls[3])",
    )
    near_the_line_of_wall_2 = "chair[0].position = [0.3, 2.1, 0.45]\n"
    assert last(call, scene=scene, before=near_the_line_of_wall_2, paper=True)[2] == "against_wall(chair-0, walls[5])"


def test_report_of_the_decisions():
    text = "solver.corner(bed[0])\nsolver.corner(bed[0], 1)\nsolver.distance_constraint(chair[0], table[0], 0, 0.1)"
    result = reconcile(read_program(text, WIDE), WIDE)
    assert result.to_dict()["counts"] == {"accepted": 1, "updated": 1, "rejected": 1}
    assert result.to_dict()["statements"][1] == {
        "number": 2,
        "line": 2,
        "source": "solver.corner(bed[0], 1)",
        "asked": "corner(bed-0, 1)",
        "verdict": "rejected",
        "reason": "bed-0 already has a corner",
        "replacement": None,
    }
    assert result.rejections == ("line 2: solver.corner(bed[0], 1): bed-0 already has a corner.",)
    assert [s.number for s in result.program.statements] == [1, 3]
    assert result.program.guesses == {}


def test_statements_about_another_scene_are_rejected():
    strange = (Corner(AssetRef("throne-0")), AgainstWall(AssetRef("bed-0"), WallRef(9)))
    result = reconcile(Program(statements=tuple(Statement(r) for r in strange)), WIDE)
    assert [d.reason for d in result.decisions] == [
        "throne-0 is not in this scene",
        "walls[9] does not exist: the room has 4 walls",
    ]


NAMES = [asset.name for asset in WIDE.assets]
things = st.sampled_from(NAMES).map(AssetRef)
walls = st.integers(0, 3).map(WallRef)
points = st.builds(PointRef, st.floats(-5, 9), st.floats(-5, 9))
lengths = st.one_of(st.none(), st.floats(0, 12))
several = st.lists(things, min_size=1, max_size=4).map(tuple)
relations: st.SearchStrategy[Relation] = st.one_of(
    st.builds(AgainstWall, things, walls),
    st.builds(MountedOn, things, walls, st.one_of(st.none(), st.floats(0, 3))),
    st.builds(OnTopOf, things, things),
    st.builds(DistanceConstraint, things, st.one_of(things, walls, points), lengths, lengths),
    st.builds(AlignWith, things, st.one_of(things, walls), st.sampled_from([0.0, 6.0, 90.0])),
    st.builds(PointTowards, things, st.one_of(things, points)),
    st.builds(FacingPair, things, things),
    st.builds(SymmetricPair, things, things, st.one_of(things, walls)),
    st.builds(NextTo, things, things),
    st.builds(Around, several, things),
    st.builds(Row, several, st.one_of(st.none(), walls)),
    st.builds(Under, things, several),
    st.builds(Corner, things),
    st.builds(CenteredOn, things, st.one_of(st.none(), things)),
    st.builds(CeilingAbove, things),
)
guesses = st.dictionaries(
    st.sampled_from(NAMES), st.tuples(st.floats(0, 4), st.floats(0, 5), st.floats(0, 2.6)), max_size=6
)


def as_program(said: list[Relation], places: dict[str, tuple[float, float, float]]) -> Program:
    """Return a program of relations and first places."""
    statements = tuple(Statement(relation, i, "", i) for i, relation in enumerate(said, start=1))
    return Program("", statements, {name: Guess(place, None) for name, place in places.items()})


PAIR = (AssetRef("bed-0"), AssetRef("bench-0"))


@settings(max_examples=300, deadline=None)
@example([Row(PAIR, None), Row(PAIR, WallRef(0))], {}, False)
@example([AgainstWall(PAIR[0], WallRef(0)), Row(PAIR, WallRef(0))], {}, False)
@given(st.lists(relations, max_size=25), guesses, st.booleans())
def test_laws_of_the_filter(said, places, paper):
    program = as_program(said, places)
    result: Reconciled = reconcile(program, WIDE, paper=paper)
    assert tuple(d.statement for d in result.decisions) == program.statements, "one decision each, in order"
    for decision in result.decisions:
        assert decision.reason
        assert (decision.replacement is not None) == (decision.verdict == "updated")
        if decision.replacement:
            before, after = decision.statement, decision.replacement
            assert set(after.relation.asset_names()) == set(before.relation.asset_names()), "no asset comes or goes"
            assert (after.line, after.number) == (before.line, before.number)
            assert after.relation != before.relation
    numbers = [statement.number for statement in result.program.statements]
    assert numbers == sorted(set(numbers)), "the order stays"
    assert result.program.guesses == program.guesses
    again = reconcile(result.program, WIDE, paper=paper)
    assert again.program == result.program, "a second pass changes nothing"
    assert all(d.verdict == "accepted" for d in again.decisions)


def assert_headings_agree(kept: list[Relation]) -> None:
    """What walls turn is turned one way, and nothing whose heading depends on places (there are no guesses) is turned twice."""
    turned: dict[str, list[float | None]] = {}
    for relation in kept:
        if isinstance(relation, AgainstWall | MountedOn):
            x, y = WIDE.room.walls[relation.wall.index].normal
            turned.setdefault(relation.a.name, []).append(math.degrees(math.atan2(y, x)))
        elif isinstance(relation, AlignWith) and isinstance(relation.b, WallRef):
            x, y = WIDE.room.walls[relation.b.index].direction
            turned.setdefault(relation.a.name, []).append(math.degrees(math.atan2(y, x)) + relation.angle)
        elif isinstance(relation, PointTowards):
            turned.setdefault(relation.a.name, []).append(None)
    for yaws in turned.values():
        assert None not in yaws or len(yaws) == 1
        assert all(abs(math.remainder(yaw - yaws[0], 360.0)) <= 10.0 for yaw in yaws[1:])


@settings(max_examples=150, deadline=None)
@given(st.lists(relations, max_size=25))
def test_what_is_kept_does_not_contradict_itself(said):
    kept = [s.relation for s in reconcile(as_program(said, {}), WIDE).program.statements]
    carried = [r.a.name for r in kept if isinstance(r, OnTopOf)]
    assert len(carried) == len(set(carried))
    carrier = {r.a.name: r.b.name for r in kept if isinstance(r, OnTopOf)}
    for name in carrier:
        steps = 0
        while name in carrier:
            name, steps = carrier[name], steps + 1
            assert steps <= len(NAMES), "no circle"
    at_wall = [r.a.name for r in kept if isinstance(r, AgainstWall | MountedOn)]
    assert len(at_wall) == len(set(at_wall))
    assert_headings_agree(kept)
    for relation in kept:
        if isinstance(relation, AgainstWall | MountedOn):
            width = WIDE.by_name[relation.a.name].size[1]
            assert width <= WIDE.room.walls[relation.wall.index].length
        if isinstance(relation, DistanceConstraint):
            low, high = relation.min_distance or 0.0, relation.max_distance
            assert high is None or low <= high
            assert low <= math.hypot(4, 5) or isinstance(relation.b, PointRef)


@settings(max_examples=100, deadline=None)
@given(st.lists(relations, max_size=12), st.lists(relations, max_size=12))
def test_new_statements_do_not_unsettle_what_was_kept(first, more):
    """Grouped planning adds statements: except for what stands on what, earlier decisions stand."""
    ground = [r for r in first if not isinstance(r, DistanceConstraint | CenteredOn | AgainstWall | MountedOn | Row)]
    more = [r for r in more if not isinstance(r, OnTopOf)]
    before = reconcile(as_program(ground, {}), WIDE)
    after = reconcile(as_program([*ground, *more], {}), WIDE)
    assert after.decisions[: len(ground)] == before.decisions
