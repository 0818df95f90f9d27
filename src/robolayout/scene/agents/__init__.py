"""The built-in agents: one TOML file each, every figure with its source; `order` is its place in lists."""
