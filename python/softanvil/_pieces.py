"""The batches of a sweep, and what is done of them: in memory, or in a folder from which it can be continued."""

from __future__ import annotations

import hashlib
import json
import os
from pathlib import Path

import pandas as pd

from . import _softanvil
from ._errors import ScenarioError
from ._scenario import Scenario

#: Names that begin so are passed over by readers of Parquet folders.
PLAN, DESIGN = "_plan.json", "_design.csv"


class Pieces:
    """Tables of the batches of a sweep.

    Args:
        out: Folder to keep them in; none for memory.
        base: What is varied.
        design: A row of values for every drop.
        size: Rows of a batch; of a sweep that is continued those of its start.
    """

    def __init__(self, out: str | os.PathLike[str] | None, base: Scenario, design: pd.DataFrame, size: int) -> None:
        self.rows, self.size = len(design), size
        self.folder = None if out is None else Path(out)
        self.tables: dict[int, pd.DataFrame] = {}
        if self.folder is not None:
            self._open(self.folder, base, design)

    def _open(self, folder: Path, base: Scenario, design: pd.DataFrame) -> None:
        try:
            import pyarrow  # noqa: F401
        except ImportError:
            raise ImportError("a sweep with a folder needs pyarrow: pip install 'softanvil[cluster]'") from None
        text = design.to_csv(index=False)
        told = json.dumps([_softanvil.version(), base._settings.content(), text]).encode()
        digest = hashlib.sha256(told).hexdigest()
        folder.mkdir(parents=True, exist_ok=True)
        plan = folder / PLAN
        if plan.exists():
            known = json.loads(plan.read_text(encoding="utf-8"))
            if known["digest"] != digest:
                raise ScenarioError(f"{folder} holds another sweep (of {known['rows']} drops): expected a folder of its own")
            self.size = known["batch"]
            return
        if any(folder.glob("*.parquet")):
            raise ScenarioError(f"{folder} holds files of Parquet and no plan: expected a folder of its own")
        (folder / DESIGN).write_text(text, encoding="utf-8")
        content = {"digest": digest, "rows": self.rows, "batch": self.size, "version": _softanvil.version()}
        _write(plan, json.dumps(content, indent=1).encode())

    def count(self) -> int:
        """How many batches there are."""
        return -(-self.rows // self.size)

    def first(self, piece: int) -> int:
        """The first row of a batch; of the one behind the last, the number of rows."""
        return min(piece * self.size, self.rows)

    def _path(self, folder: Path, piece: int) -> Path:
        return folder / f"part-{piece:06d}.parquet"

    def missing(self) -> list[int]:
        """The batches that are not done."""
        if self.folder is None:
            return list(range(self.count()))
        return [piece for piece in range(self.count()) if not self._path(self.folder, piece).exists()]

    def put(self, piece: int, table: pd.DataFrame) -> None:
        """Takes what came of a batch; in a folder it stands there whole or not at all."""
        if self.folder is None:
            self.tables[piece] = table
            return
        path = self._path(self.folder, piece)
        scratch = path.with_name(f"_{path.name}.{os.getpid()}")
        table.to_parquet(scratch, index=False)
        os.replace(scratch, path)

    def table(self) -> pd.DataFrame:
        """All rows in the order of the design."""
        folder = self.folder
        tables = [self.tables[piece] if folder is None else pd.read_parquet(self._path(folder, piece))
                  for piece in range(self.count())]
        return pd.concat(tables, ignore_index=True) if tables else pd.DataFrame({"run": []})


def _write(path: Path, content: bytes) -> None:
    scratch = path.with_name(f"{path.name}.{os.getpid()}")
    scratch.write_bytes(content)
    os.replace(scratch, path)
