"""Sweeps of many drops, on one machine or on a cluster of Dask."""

from __future__ import annotations

import contextlib
import importlib.util
import math
import os
import uuid
from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import pandas as pd

from . import _softanvil
from ._design import rows as rows_of
from ._pieces import Pieces
from ._scenario import Scenario

if TYPE_CHECKING:
    from ._groups import Value

#: Drops of a batch, at most: at 10 ms a drop two seconds, beside which the millisecond that a scheduler needs for a task is
#: nothing, and little enough to be lost with a worker.
LARGEST_BATCH = 200
#: Batches for every thread of a cluster, at least, so that none waits long for the last.
BATCHES_PER_THREAD = 8


def _simulate(
    settings: _softanvil.Settings, first: int, names: list[str], values: list[list[Any]], threads: int
) -> pd.DataFrame:
    """The rows of one batch; what a worker does."""
    keys, columns, endings, hashes, errors = _softanvil.run_rows(settings, names, values, threads)
    table = pd.DataFrame({"run": range(first, first + len(values))})
    for place, name in enumerate(names):
        table[name] = [row[place] for row in values]
    for key, column in zip(keys, columns, strict=True):
        table[key.removeprefix("result.")] = column
    return table.assign(ending=endings, trace_hash=hashes, error=errors)


def sweep(
    base: Scenario,
    parameters: Mapping[str, Value | Sequence[Value]] | pd.DataFrame | Sequence[Mapping[str, Value]],
    *,
    client: Any = None,
    out: str | os.PathLike[str] | None = None,
    batch: int | None = None,
    threads: int = 0,
    progress: bool = True,
) -> pd.DataFrame:
    """Simulates a drop for every row of a design; the numbers do not depend on how many cores or workers there are.

    Args:
        base: What is varied.
        parameters: Lists of values by the name of the parameter, of which all combinations are simulated, the last name
            changing fastest: ``{"impactor.energy": [4.9, 9.8], "layers[0].thickness": ["12 mm", "15 mm"]}``; or a row of values
            for every drop, as a data frame (see `design`) or as dictionaries. What a row leaves out (NaN, None) stays as in `base`.
        client: A ``distributed.Client``, whose workers simulate; without it the cores of this machine do.
        out: Folder for the results, a Parquet file for every batch as soon as it is done (needs pyarrow), and for the plan. A
            sweep that was ended there is continued: what is written is not simulated again. ``pandas.read_parquet(out)`` reads it.
        batch: Drops of a batch; without it enough for the scheduler to have little to do, 200 at most.
        threads: Threads without a client, 0 for one per core.
        progress: Whether a bar shows how far it is, where tqdm is installed; the dashboard of Dask shows the batches.

    Returns:
        A row for every drop, in the order of the design, with its index if it is a data frame: "run", from 0; the parameters, in SI units; the measured numbers in SI
        units; "ending" ("complete", "held", "in_contact", "no_contact" or "failed"); "trace_hash", equal for equal bits; "error",
        which is empty, or why the drop was refused or failed, and then the numbers are NaN.

    Raises:
        ScenarioError: A name that is unknown, or a folder that holds another sweep.
    """
    if batch is not None and batch < 1:
        raise ValueError(f"batch = {batch} is refused: expected 1 or more")
    design = rows_of(base, parameters)
    slots = sum(client.nthreads().values()) if client is not None else os.cpu_count() or 1
    size = batch or max(1, min(LARGEST_BATCH, math.ceil(len(design) / (BATCHES_PER_THREAD * max(1, slots)))))
    pieces = Pieces(out, base, design, size)
    names = list(design.columns)
    columns = [[None if value != value else value for value in design[name]] for name in names]
    values = [list(row) for row in zip(*columns, strict=True)] if names else []
    work = {piece: values[pieces.first(piece) : pieces.first(piece + 1)] for piece in pieces.missing()}
    with _bar(len(design), len(design) - sum(map(len, work.values())), progress) as advance:
        if client is None:
            made = _here(base, pieces, names, work, threads)
        else:
            made = _on_cluster(client, base, pieces, names, work)
        for piece, table in made:
            pieces.put(piece, table)
            advance(len(table))
    table = pieces.table()
    return table.set_axis(parameters.index) if isinstance(parameters, pd.DataFrame) else table


def _here(
    base: Scenario, pieces: Pieces, names: list[str], work: dict[int, list[list[Any]]], threads: int
) -> Iterator[tuple[int, pd.DataFrame]]:
    for piece, values in work.items():
        yield piece, _simulate(base._settings, pieces.first(piece), names, values, threads)


def _on_cluster(
    client: Any, base: Scenario, pieces: Pieces, names: list[str], work: dict[int, list[list[Any]]]
) -> Iterator[tuple[int, pd.DataFrame]]:
    from distributed import as_completed

    call = uuid.uuid4().hex[:8]
    futures = {
        client.submit(_simulate, base._settings, pieces.first(piece), names, values, 1,
                      key=f"softanvil-sweep-{call}-{piece}", pure=False): piece
        for piece, values in work.items()
    }
    try:
        completed: Any = as_completed
        for future, table in completed(list(futures), with_results=True):
            yield futures.pop(future), table
            future.release()
    finally:
        client.cancel(list(futures))


@contextlib.contextmanager
def _bar(total: int, done: int, progress: bool) -> Iterator[Any]:
    if not progress or importlib.util.find_spec("tqdm") is None:
        yield lambda drops: None
        return
    from tqdm.auto import tqdm

    with tqdm(total=total, initial=done, unit="drop", smoothing=0.1) as bar:
        yield bar.update
