"""RoboLayout."""
