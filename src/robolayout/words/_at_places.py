"""Where a thing stands or hangs in a room: at its walls, corners, doors and windows, in its middle, in one of its halves."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from robolayout.constraints import AssetRef, PointRef, WallRef
from robolayout.scene import Asset, Opening, Scene, Wall
from robolayout.words import _ways as ways_of
from robolayout.words._places import centre, corners_meant, halves_meant, wall_pairs, walls_meant
from robolayout.words._said import Place
from robolayout.words.demands import Way, stated


class AtPlaces:
    """Says in which ways things can be at the places of a scene's room."""

    def __init__(self, scene: Scene) -> None:
        self.scene, self.room = scene, scene.room

    def _asset(self, name: str) -> Asset:
        return self.scene.by_name[name]

    def _ways_at_walls(self, subjects: Sequence[str], place: Place, *, on: bool) -> Iterator[Way]:
        """Yield the ways in which things are at one wall together, or one half at each of two walls that face each other."""
        half = (len(subjects) + 1) // 2
        yield from self._at_walls(subjects[half:], subjects[:half], place, on=on)

    def _at_walls(self, subjects: Sequence[str], there: Sequence[str], place: Place, *, on: bool) -> Iterator[Way]:
        """Yield the ways in which things are at the wall where others are, or at the one across from it."""
        for one, two in wall_pairs(self.scene, same="same" in place.words):
            both = [*((a, one) for a in there), *((a, two) for a in subjects)]
            yield tuple(stated(self._held(a, on), AssetRef(a), WallRef(wall.index)) for a, wall in both)

    def _held(self, name: str, on: bool) -> str:
        """Return the statement that says that a thing is at a wall: hung on it, or standing against it."""
        hung = on and self._asset(name).on_wall and not self._asset(name).on_floor
        return "mounted_on" if hung or self._only_wall(name) else "against_wall"

    def _ways_at(self, a: str, place: Place, *, on: bool, share: bool) -> Iterator[Way]:
        """Yield the ways in which one thing can be at a place of the room."""
        ref = AssetRef(a)
        if place.name == "wall":
            hangs = self._held(a, on)
            walls = [w for w in walls_meant(self.scene, place) if self._fits(a, w)]
            free = len(walls) == len(self.room.walls)
            yield from [(stated(hangs, ref),)] if free else ((stated(hangs, ref, WallRef(w.index)),) for w in walls)
        elif place.name == "corner":
            yield from ((stated("corner", ref, vertex),) for vertex in corners_meant(self.scene, place))
        elif place.name in ("window", "door"):
            gap = (ways_of.AT_WINDOW if place.name == "window" else ways_of.AT_DOOR) * (1.5 if share else 1.0)
            yield from ((stated("near", ref, point, gap),) for point in self._points(place))
        elif place.name == "middle":
            x0, y0, x1, y1 = self.room.bounds
            most = max(ways_of.LEAST_MIDDLE, ways_of.MIDDLE_SHARE * min(x1 - x0, y1 - y0)) * (1.5 if share else 1.0)
            x, y = centre(self.scene)
            yield (stated("distance_constraint", ref, PointRef(x, y), None, round(most, 2)),)
        elif place.name == "side":
            yield from ((stated("zone", ref, half),) for half in halves_meant(self.scene, place))

    def _ways_flanking(self, subjects: Sequence[str], place: Place) -> Iterator[Way]:
        """Yield the ways in which things are at both sides of a door or window, in turn."""
        for opening in self._openings(place):
            wall = self.room.walls[opening.wall]
            (x, y), (dx, dy), (nx, ny) = wall.point(opening.center), wall.direction, wall.normal
            far, gap = sum(one.length for one in self.room.walls), opening.width / 2 + ways_of.BESIDE
            middle, ahead = PointRef(round(x, 3), round(y, 3)), (x + far * nx, y + far * ny)
            halves = [
                (
                    middle,
                    *(PointRef(u + side * far * dx, v + side * far * dy) for u, v in ((x, y), ahead)),
                    PointRef(*ahead),
                )
                for side in (1, -1)
            ]
            for first in (0, 1):
                yield tuple(
                    one
                    for i, a in enumerate(subjects)
                    for one in (
                        stated(self._held(a, on=True), AssetRef(a), WallRef(wall.index)),
                        stated("near", AssetRef(a), middle, gap),
                        stated("zone", AssetRef(a), halves[(i + first) % 2]),
                    )
                )

    def _fits(self, name: str, wall: Wall) -> bool:
        return self._asset(name).size[1] <= wall.length

    def _only_wall(self, name: str) -> bool:
        asset = self._asset(name)
        return asset.on_wall and not asset.on_floor and not asset.on_object

    def _openings(self, place: Place) -> tuple[Opening, ...]:
        return self.room.doors if place.name == "door" else self.room.windows

    def _points(self, place: Place) -> list[PointRef]:
        """Return the middles of doors or windows on the floor, or the middle of the room."""
        if place.name in ("door", "window"):
            spots = [self.room.walls[o.wall].point(o.center) for o in self._openings(place)]
            return [PointRef(round(x, 3), round(y, 3)) for x, y in spots]
        if place.name in ("middle", "room"):
            return [PointRef(*centre(self.scene))]
        walls = walls_meant(self.scene, place) if place.name == "wall" else []
        return [PointRef(round(w.midpoint[0], 3), round(w.midpoint[1], 3)) for w in walls]

    def _is(self, name: str, words: Sequence[str]) -> bool:
        asset = self._asset(name)
        return any(text.endswith(word) for text in (asset.category, asset.like) for word in words)
