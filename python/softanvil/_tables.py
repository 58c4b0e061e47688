"""What there is to set and to read, as tables."""

from __future__ import annotations

import pandas as pd

from . import _softanvil


def parameters() -> pd.DataFrame:
    """Every parameter of the test and of a layer, by name: unit, legal range or labels, meaning."""
    rows = [{**row, "labels": " | ".join(row["labels"])} for row in _softanvil.parameters()]
    columns = ["name", "kind", "unit", "minimum", "maximum", "labels", "description"]
    return pd.DataFrame(rows)[columns].set_index("name")


def outputs() -> pd.DataFrame:
    """Every output, by name: unit and meaning."""
    return pd.DataFrame(_softanvil.outputs(), columns=["name", "unit", "description"]).set_index("name")


def fields() -> pd.DataFrame:
    """Every field, by name: unit and meaning."""
    return pd.DataFrame(_softanvil.fields(), columns=["name", "unit", "description"]).set_index("name")
