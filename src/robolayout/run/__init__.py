"""The flow: groups, attempts, critic, and the output folder of a run."""
