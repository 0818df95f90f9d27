"""Rooms of sentences, each laid out once, and their things by kind."""

from __future__ import annotations

from functools import cache

import robolayout as rl
from robolayout.run.result import Result

made = cache(rl.generate)


def of(result: Result, kind: str) -> list[str]:
    return [name for name in result.layout if name.rsplit("-", 1)[0] == kind]
