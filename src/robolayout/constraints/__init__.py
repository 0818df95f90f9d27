"""The vocabulary: one relation a file, with arguments, solver rows, exact check and one-line meaning."""

from importlib import import_module
from importlib.metadata import entry_points

from robolayout._reading.plugins import loaded
from robolayout.constraints._exact import TOLERANCE as TOLERANCE
from robolayout.constraints._implicit import implicit_terms as implicit_terms
from robolayout.constraints._overlap import share_height as share_height
from robolayout.constraints._refs import AssetRef as AssetRef
from robolayout.constraints._refs import PointRef as PointRef
from robolayout.constraints._refs import Ref as Ref
from robolayout.constraints._refs import WallRef as WallRef
from robolayout.constraints._registry import RELATIONS as RELATIONS
from robolayout.constraints._registry import own_relations
from robolayout.constraints._registry import register as register
from robolayout.constraints._registry import register_file as register_file
from robolayout.constraints._relation import FAR as FAR
from robolayout.constraints._relation import ClearTerm as ClearTerm
from robolayout.constraints._relation import FrameTerm as FrameTerm
from robolayout.constraints._relation import Interval as Interval
from robolayout.constraints._relation import MirrorTerm as MirrorTerm
from robolayout.constraints._relation import Outcome as Outcome
from robolayout.constraints._relation import OverlapTerm as OverlapTerm
from robolayout.constraints._relation import Relation as Relation
from robolayout.constraints._relation import Term as Term
from robolayout.constraints._relation import Way as Way
from robolayout.constraints._relation import argument as argument
from robolayout.constraints._standing import covers as covers
from robolayout.constraints._standing import hangs as hangs
from robolayout.constraints._standing import supporter as supporter

_BUILT_IN = """
against_wall distance_constraint on_top_of inside align_with point_towards symmetric_pair next_to near in_front_of
behind left_of right_of facing_pair corner centered_on around row grid under mounted_on ceiling_above above
keep_clear zone at_window by_door mid_wall snug grouped toward in_rows in_shape between any_of
"""  # one module each, in the order of the vocabulary

for _word in _BUILT_IN.split():
    register(*own_relations(import_module(f"{__name__}.{_word}")))
for _point in entry_points(group="robolayout.constraints"):
    register(loaded(_point, "Relation", lambda found: isinstance(found, type) and issubclass(found, Relation)))
