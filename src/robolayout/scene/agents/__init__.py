"""The built-in agents: one TOML file each, every figure with its source."""

BUILT_IN = (
    "turtlebot4",
    "stretch3",
    "fetch",
    "tiago",
    "spot",
    "unitree_g1",
    "robot_vacuum",
    "amr",
    "forklift",
    "adult",
    "child_6",
    "elder_walker",
    "wheelchair",
    "dog_medium",
    "cat",
)
"""Names of the built-in agents; each is a file of that name beside this one."""
