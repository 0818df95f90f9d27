"""The same set from a Ray cluster, whatever becomes of its nodes."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

import robolayout as rl
from robolayout import InputError
from tiny_sets import tiny_spec, tree

pytest.importorskip("ray")
pytestmark = pytest.mark.slow


def test_a_local_cluster_makes_the_set_that_processes_make(tmp_path: Path) -> None:
    table = tiny_spec(tmp_path, 4, formats=["mjcf"])
    told: list[Any] = []
    found = rl.batch(table, tmp_path / "ray", workers=2, cluster="local", progress=told.append)
    assert found.ok and told[-1].made == 4
    rl.batch(table, tmp_path / "local")
    assert tree(tmp_path / "ray") == tree(tmp_path / "local")


def test_a_node_that_goes_away_costs_nothing_but_time(tmp_path: Path) -> None:
    import ray
    from ray.cluster_utils import Cluster

    table, gone = tiny_spec(tmp_path, 10), list[Any]()
    cluster = Cluster(initialize_head=True, head_node_args={"num_cpus": 1})
    try:
        node = cluster.add_node(num_cpus=1)
        ray.init(address=cluster.address, log_to_driver=False)

        def leave(now: Any) -> None:
            if now.made == 3 and not gone:
                gone.append(node)
                cluster.remove_node(node, allow_graceful=False)

        found = rl.batch(table, tmp_path / "ray", workers=2, cluster=cluster.address, progress=leave)
    finally:
        ray.shutdown()
        cluster.shutdown()
    assert gone and found.ok
    rl.batch(table, tmp_path / "local")
    assert tree(tmp_path / "ray") == tree(tmp_path / "local")


def test_a_cluster_that_is_not_there_is_said(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"there is no Ray cluster at '127\.0\.0\.1:1'"):
        rl.batch(tiny_spec(tmp_path, 1), tmp_path / "set", cluster="127.0.0.1:1")
