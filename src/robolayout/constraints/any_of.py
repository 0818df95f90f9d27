"""`any_of`: one of several statements holds."""

from __future__ import annotations

from dataclasses import dataclass

from robolayout.constraints._refs import Ref
from robolayout.constraints._relation import Outcome, Relation, Term, Way, argument, best_way
from robolayout.scene import Layout, Scene


@dataclass(frozen=True)
class AnyOf(Relation):
    """At least one of `choices` holds, whichever: each a statement, or a list of statements that hold together."""

    name = "any_of"
    moves = ("choices",)
    surrogate = True  # as what it is made of
    example = "solver.any_of([solver.corner(plant[0], 0), solver.near(plant[0], sofa[0])])"

    choices: tuple[Way, ...] = argument("statement", many=True)

    def refs(self) -> tuple[Ref, ...]:
        """Return everything that its statements are about, each once; the subjects of all first."""
        several = [one.refs() for way in self.choices for one in way]
        return tuple(dict.fromkeys([*(refs[0] for refs in several), *(ref for refs in several for ref in refs)]))

    def ways(self, scene: Scene) -> tuple[Way, ...]:
        """Return the choices; of one that is a single statement with ways of its own, these."""
        opened = (choice[0].ways(scene) if len(choice) == 1 else () for choice in self.choices)
        return tuple(way for choice, own in zip(self.choices, opened, strict=True) for way in own or (choice,))

    def terms(self, scene: Scene, near: Layout) -> tuple[Term, ...]:
        """Return the rows of the choice of which least lacks."""
        return tuple(term for one in best_way(self.choices, scene, near)[0] for term in one.terms(scene, near))

    def check(self, scene: Scene, layout: Layout) -> Outcome:
        """As the best of its choices."""
        return best_way(self.choices, scene, layout)[1]

    def sentence(self) -> str:
        """Return it as program-like text: `any_of([corner(plant-0), near(plant-0, sofa-0)])`."""
        return f"any_of([{', '.join(self._shown(way) for way in self.choices)}])"

    def _shown(self, way: Way) -> str:
        text = ", ".join(one.sentence() for one in way)
        return text if len(way) == 1 else f"[{text}]"
