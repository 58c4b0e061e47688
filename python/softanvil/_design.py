"""What a sweep simulates: a row of values for every drop."""

from __future__ import annotations

import itertools
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt
import pandas as pd

from ._errors import ParameterError, ScenarioError
from ._scenario import Scenario

if TYPE_CHECKING:
    from ._groups import Value

#: Lists of values by name for all combinations, or rows.
Parameters = "Mapping[str, Value | Sequence[Value]] | pd.DataFrame | Sequence[Mapping[str, Value]]"


def design(ranges: Mapping[str, tuple[float, float]], samples: npt.ArrayLike) -> pd.DataFrame:
    """Rows for `sweep` from samples of the unit cube, such as those of ``scipy.stats.qmc``.

    Args:
        ranges: Smallest and largest value of every parameter, in its unit, by name.
        samples: Points (rows, parameters), each number from 0 to 1.

    Returns:
        A row for every point, a column for every parameter.

    Raises:
        ValueError: Samples of another shape, or outside the cube.
    """
    points = np.asarray(samples, dtype=float)
    if points.ndim != 2 or points.shape[1] != len(ranges):
        raise ValueError(f"samples of the shape {points.shape} are refused: expected (rows, {len(ranges)})")
    if not bool(np.all((points >= 0) & (points <= 1))):
        raise ValueError("samples outside 0 to 1 are refused: expected points of the unit cube")
    low, high = np.array(list(ranges.values()), dtype=float).T
    return pd.DataFrame(low + points * (high - low), columns=list(ranges))


def rows(base: Scenario, parameters: Any) -> pd.DataFrame:
    """The rows that `parameters` mean, a column for every name, in SI units."""
    if isinstance(parameters, pd.DataFrame):
        table = parameters.reset_index(drop=True)
    elif isinstance(parameters, Mapping):
        levels = {name: _levels(values) for name, values in parameters.items()}
        table = pd.DataFrame(itertools.product(*levels.values()), columns=list(levels))
    else:
        table = pd.DataFrame(list(parameters))
    # A name that is unknown is an error of the whole sweep.
    columns: dict[str, str] = {}
    for name in map(str, table.columns):
        base[name]
        full = base._settings.full_name(name)
        if full in columns:
            raise ScenarioError(f"{columns[full]} and {name} are the same parameter: expected every one once")
        columns[full] = name
    return pd.DataFrame({str(name): _in_si(base, str(name), table[name]) for name in table.columns}, index=table.index)


def _levels(values: Any) -> list[Any]:
    # A quantity of pint has a magnitude, of which an array has many.
    if isinstance(values, (str, bytes)) or not np.iterable(getattr(values, "magnitude", values)):
        return [values]
    return list(values)


def _in_si(base: Scenario, name: str, column: pd.Series[Any]) -> pd.Series[Any]:
    """Numbers of SI units for texts with units; what is refused stays as it is written, for the row to say so."""
    if pd.api.types.is_numeric_dtype(column) and not pd.api.types.is_bool_dtype(column):
        return column.astype(float)
    trial, unit = base.copy(), "1"

    def known(value: Any) -> Any:
        nonlocal unit
        if pd.api.types.is_scalar(value) and pd.isna(value):
            return None
        try:
            trial[name] = value
            return trial[name]
        except ParameterError as error:
            unit = error.unit
            return str(value)

    values = [known(value) for value in column]
    if all(value is None or isinstance(value, (int, float)) and not isinstance(value, bool) for value in values):
        return pd.Series(values, index=column.index, dtype=float)
    # Beside what is refused, all are texts; a number has its unit there, which it has to have.
    suffix = "" if unit == "1" else f" {unit}"
    texts = [None if value is None else value if isinstance(value, str) else f"{value!r}{suffix}" for value in values]
    return pd.Series(texts, index=column.index, dtype=object)
