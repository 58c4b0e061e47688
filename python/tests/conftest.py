import os
from pathlib import Path

import matplotlib
import pytest

matplotlib.use("Agg")

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture
def root():
    """The root of the repository."""
    return ROOT


@pytest.fixture(scope="session", autouse=True)
def no_display():
    os.environ["MPLBACKEND"] = "Agg"
