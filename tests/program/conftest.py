"""The scene of the program tests."""

import pytest
from furnished_room import furnished

from robolayout.scene import Scene


@pytest.fixture(scope="session")
def scene() -> Scene:
    return furnished()
