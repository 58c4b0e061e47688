"""Sweeps: what they give, that they can be continued, and that neither cores nor workers nor their end change a bit."""

import importlib
import os
import signal
import subprocess
import sys
import textwrap
import time
from pathlib import Path

import numpy as np
import pandas as pd
import pytest
from distributed import Client
from scipy.stats import qmc

import softanvil as sa
from conftest import ROOT

EXAMPLES = ROOT / "python/examples"
RANGES = {"impactor.energy": (3.0, 15.0), "silicone.thickness": (10e-3, 20e-3)}


#: One process has all tests of one cluster.
on_cluster = pytest.mark.xdist_group("cluster")


def short():
    """A drop of a coarse mesh, some milliseconds of work."""
    return sa.preset("study").update({"mesh.element_size": "7.5 mm"})


def points(number):
    return sa.design(RANGES, qmc.Sobol(2, rng=1).random(number))


def same(one, other):
    pd.testing.assert_frame_equal(one, other, check_exact=True)


@pytest.fixture(scope="session")
def cluster(tmp_path_factory):
    """A scheduler and a function that starts workers, each a process."""
    folder = tmp_path_factory.mktemp("cluster")
    address, processes = folder / "scheduler.json", []

    def start(*arguments):
        with open(folder / f"{len(processes)}.log", "w") as log:
            process = subprocess.Popen([sys.executable, "-m", "dask", *arguments, "--scheduler-file", str(address)],
                                       stdout=log, stderr=log, cwd=folder,
                                       env={**os.environ, "PYTHONPATH": str(EXAMPLES)})
        processes.append(process)
        return process

    def worker():
        return start("worker", "--nthreads", "1", "--no-nanny", "--no-dashboard")

    start("scheduler", "--port", "0", "--no-dashboard", "--host", "127.0.0.1")
    while not address.exists():
        time.sleep(0.05)
    workers = [worker(), worker()]
    with Client(scheduler_file=str(address)) as client:
        client.wait_for_workers(2, timeout=60)
        yield client, workers, worker
    for process in processes:
        process.kill()
        process.wait()


def test_all_combinations_are_rows():
    table = sa.sweep(short(), {"impactor.energy": ["4.9 J", 9.8], "core.interface": ["bonded", "frictional"]})
    assert table["impactor.energy"].tolist() == [4.9, 4.9, 9.8, 9.8] and table["run"].tolist() == [0, 1, 2, 3]
    assert table["core.interface"].tolist() == ["bonded", "frictional"] * 2
    for row in table.itertuples():
        alone = sa.run(short().update({"impactor.energy": row[2], "core.interface": row[3]}))
        assert (row.peak_force, row.trace_hash, row.ending) == (alone.peak_force, alone.trace_hash, alone.ending)
    assert (table["error"] == "").all()


def test_failures_are_rows_with_their_reason():
    rows = [{"impactor.energy": 9.8}, {"impactor.energy": -1.0}, {"impactor.energy": 9.8, "impactor.height": 0.1},
            {"impactor.height": 0.1}, {"silicone.thickness": "1 um"}, {"core.interface": "glued"}, {"time.step": 5e-5}]
    table = sa.sweep(short(), rows)
    assert table["ending"].tolist() == ["complete", "failed", "failed", "complete", "failed", "failed", "failed"]
    for row, reason in [(1, "impactor.drop_energy = -1 J is refused: expected 0 to 100000 J"),
                        (2, "impactor.drop_energy and impactor.drop_height state the same thing"),
                        (4, "layers[0].thickness = 0.000001 m is refused"), (5, 'expected "bonded" or "frictional"'),
                        (6, "time.step = 0.00005 s is refused")]:
        assert reason in table["error"][row] and np.isnan(table["peak_force"][row]) and table["trace_hash"][row] == ""
    with pytest.raises(sa.ScenarioError, match="did you mean impactor.mass"):
        sa.sweep(short(), {"impactor.mas": [1.0]})


def test_a_text_that_is_refused_leaves_the_others_of_its_column():
    table = sa.sweep(short(), {"impactor.energy": ["5 J", "9.8", 4.9]})
    assert table["ending"].tolist() == ["complete", "failed", "complete"]
    assert "impactor.drop_energy = '9.8' is refused" in table["error"][1]
    assert table["peak_force"][0] == sa.run(short().update({"impactor.energy": 5.0})).peak_force


def test_a_table_keeps_the_index_of_its_design():
    design = pd.DataFrame({"impactor.energy": [4.9, 9.8]}, index=[7, 9])
    table = sa.sweep(short(), design)
    assert table.index.tolist() == [7, 9] and table["run"].tolist() == [0, 1]
    assert (pd.concat([design, table[["peak_force"]]], axis=1).notna()).all(axis=None)


def test_a_parameter_by_two_names_is_refused():
    with pytest.raises(sa.ScenarioError, match=r"silicone.c10 and layers\[0\].c10 are the same parameter"):
        sa.sweep(short(), pd.DataFrame({"silicone.c10": [1e5], "layers[0].c10": [2e5]}))


def test_what_is_no_scenario_is_refused():
    for wrong in (lambda: sa.run("study"), lambda: sa.run_many([short(), None])):
        with pytest.raises(TypeError, match="is no scenario: expected a softanvil.Scenario"):
            wrong()
    with pytest.raises(TypeError, match="expected several"):
        sa.run_many(short())


def test_neither_threads_nor_batches_change_a_bit():
    design = points(16)
    whole = sa.sweep(short(), design, threads=1, batch=16)
    for threads, batch in [(0, None), (2, 3), (5, 1)]:
        same(sa.sweep(short(), design, threads=threads, batch=batch), whole)
    assert whole[list(RANGES)].to_numpy() == pytest.approx(design.to_numpy(), abs=0)


def test_a_folder_is_continued_and_not_taken_by_another_sweep(tmp_path):
    design = points(16)
    whole = sa.sweep(short(), design, out=tmp_path, batch=4)
    same(pd.read_parquet(tmp_path), whole)
    kept = {path.name: path.stat().st_mtime_ns for path in tmp_path.glob("part-*")}
    assert len(kept) == 4
    (tmp_path / "part-000002.parquet").unlink()
    same(sa.sweep(short(), design, out=tmp_path), whole)
    now = {path.name: path.stat().st_mtime_ns for path in tmp_path.glob("part-*")}
    assert {name for name in kept if kept[name] != now[name]} == {"part-000002.parquet"}
    for base, other in [(short(), points(8)), (sa.preset("elastic"), design)]:
        with pytest.raises(sa.ScenarioError, match="holds another sweep"):
            sa.sweep(base, other, out=tmp_path)


def test_a_sweep_that_was_killed_goes_on(tmp_path):
    script = textwrap.dedent(f"""
        import sys; sys.path.insert(0, {str(sys.path[0])!r})
        from test_sweep import points, short
        import softanvil as sa
        sa.sweep(short(), points(256), out={str(tmp_path / 'out')!r}, batch=4)
    """)
    process = subprocess.Popen([sys.executable, "-c", script], cwd=tmp_path)
    while len(list((tmp_path / "out").glob("part-*"))) < 5 and process.poll() is None:
        time.sleep(0.005)
    process.send_signal(signal.SIGKILL)
    process.wait()
    left = {path: path.read_bytes() for path in (tmp_path / "out").glob("part-*")}
    assert 5 <= len(left) < 64
    table = sa.sweep(short(), points(256), out=tmp_path / "out")
    assert all(path.read_bytes() == content for path, content in left.items())
    same(table, sa.sweep(short(), points(256)))


@on_cluster
def test_a_cluster_gives_the_same_bits(cluster):
    client, _, _ = cluster
    design = points(32)
    same(sa.sweep(short(), design, client=client, batch=3), sa.sweep(short(), design))


@on_cluster
def test_a_worker_that_is_killed_loses_nothing_and_does_nothing_twice(cluster, tmp_path):
    client, workers, worker = cluster
    design, out = points(512), tmp_path / "out"
    script = textwrap.dedent(f"""
        import sys, time, os, signal, pathlib
        while len(list(pathlib.Path({str(out)!r}).glob("part-*"))) < 10:
            time.sleep(0.005)
        os.kill({workers[0].pid}, signal.SIGKILL)
    """)
    killer = subprocess.Popen([sys.executable, "-c", script])
    table = sa.sweep(short(), design, client=client, out=out, batch=4)
    assert killer.wait(timeout=10) == 0 and workers[0].wait(timeout=10) == -signal.SIGKILL
    assert table["run"].tolist() == list(range(512)) and len(list(out.glob("part-*"))) == 128
    assert (table["ending"] == "complete").all()
    same(table, sa.sweep(short(), design))
    workers[0] = worker()


@on_cluster
def test_results_and_scenarios_travel(cluster):
    client, _, _ = cluster
    scenarios = [short().update({"impactor.energy": energy}) for energy in (4.9, 9.8)]
    results = client.gather(client.map(sa.run, scenarios))
    assert [result.trace_hash for result in results] == [sa.run(scenario).trace_hash for scenario in scenarios]


@pytest.fixture
def example(monkeypatch):
    """A function that imports an example."""
    monkeypatch.syspath_prepend(str(EXAMPLES))
    return importlib.import_module


@on_cluster
def test_the_example_of_a_calibration(cluster, example):
    calibration = example("calibrate_on_cluster")
    truth = (np.log10(1.48e5), np.log10(1.32e5))
    found = calibration.calibrate(cluster[0], calibration.numbers(truth), generations=6)
    assert found.fun < 0.02 and found.x == pytest.approx(truth, abs=0.15)


@on_cluster
def test_the_example_of_an_fmu(cluster, example, tmp_path):
    # The tests of the whole have a library beside the program; alone one is built.
    program = os.environ.get("SOFTANVIL_CLI")
    built = ["--library", str(Path(program).with_name("libsoftanvil.so"))] if program else []
    sa._softanvil.command(["fmu", "--fmi", "2", "--out", str(tmp_path), *built])
    energies = [4.9, 9.8, 14.7]
    table = example("fmu_sweep").sweep(cluster[0], str(tmp_path / "softanvil-fmi2.fmu"), energies)
    alone = [sa.run(sa.preset("study").update({"impactor.energy": energy, "time.duration": 15e-3})) for energy in energies]
    assert table["result.peak_force"].tolist() == [result.peak_force for result in alone]


def test_designs_have_to_fit():
    with pytest.raises(ValueError, match=r"expected \(rows, 2\)"):
        sa.design(RANGES, np.zeros((3, 3)))
    with pytest.raises(ValueError, match="unit cube"):
        sa.design(RANGES, [[0.0, 2.0]])
    with pytest.raises(ValueError, match="batch = 0"):
        sa.sweep(short(), points(2), batch=0)
    assert len(sa.sweep(short(), points(2).iloc[:0])) == 0
