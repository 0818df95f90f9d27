"""Quality and speed, measured by a command: `python -m benchmarks` writes benchmarks/results/*.json and docs/benchmarks.md."""
