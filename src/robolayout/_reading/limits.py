"""Every bound on what is read."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Limits:
    """The most that a file of somebody else may hold; what holds more is refused with a sentence."""

    text: int = 10_000  # longest text in a file, in characters
    shown: int = 300  # characters of a path that a message shows
    length: float = 1000.0  # largest length in metres
    farthest: float = 10_000.0  # largest coordinate in metres, or other number of a list
    file_bytes: int = 20_000_000  # largest scene, layout or asset file in bytes
    mesh_bytes: int = 100_000_000  # largest mesh file in bytes
    pixels: int = 64_000_000  # pixels of all pictures of a file (8,000 x 8,000), each four bytes when it is looked at
    unpacked: int = 200_000_000  # bytes of all views, and of all accessors: twice the largest file, for shared ones
    triangles: int = 3_000_000  # triangles of a file in all; reading one takes about 250 bytes of memory
    pieces: int = 20_000  # pieces of a file: nodes, groups, solids or changes of material
    coordinate: float = 1e7  # coordinate, in the file's unit, beyond which a vertex is unusable
    picture: int = 1024  # most pixels along a side of a texture; larger ones are made smaller
    depth: int = 64  # lists, objects or bodies inside each other; a scene has seven
    values: int = 2_000_000  # values in a file; the largest scene has about 50,000
    digits: int = 100  # characters of a number; a double needs at most 25
    elements: int = 500_000  # elements of an XML file
    assets: int = 2000  # most assets of a scene
    name: int = 200  # characters of an asset's name
    smallest_side: float = 1e-4  # least side of an asset's box in metres
    largest_side: float = 100.0  # largest side of an asset's box in metres
    without: int = 100  # most names of parts that a thing is drawn without
    model_parts: int = 2000  # most links, most joints and most collision shapes of a model
    model_bytes: int = 50_000_000  # bytes of meshes and included files read in all
    model_points: int = 5_000_000  # points on all collision shapes together
    corners: int = 200  # most corners of a room
    openings: int = 100  # most doors, and most windows, of a room
    least_area: float = 0.01  # smallest floor area in square metres that counts as a room
    room_asked: float = 100.0  # metres of a room's longer side beyond which its unit is asked about
    room_side: float = 500.0  # metres of a room's longer side
    agents: int = 16  # most agents of a scene
    body: float = 20.0  # metres of any length of a body
    tested_walls: int = 50_000  # walls against which boxes are tested; the rest is left to the verifier
    named: int = 1000  # entries of one list of a SPEC
    folder_files: int = 5000  # mesh files that are looked at in one folder
    folder_json: int = 1_000_000  # largest metadata file in bytes
    drawn_triangles: int = 20_000  # an asset with more triangles is thinned out to at most this
    drawn_parts: int = 64  # an asset with more pieces is merged into one
    looked_at: int = 2000  # characters of a text in which words are looked for; the rest is ignored


LIMITS = Limits()
