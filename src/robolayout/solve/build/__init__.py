"""Builds a room from what a program says: propose places, weigh them, commit to the best, thing by thing."""

from robolayout.solve.build.furnish import furnished as furnished
