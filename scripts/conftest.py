"""What the Python tests share."""

import functools
from collections.abc import Callable
from pathlib import Path

import pytest

from mda_results import testing


@pytest.fixture
def write(tmp_path: Path) -> Callable[..., Path]:
    """testing.write_run() into a fresh directory."""
    return functools.partial(testing.write_run, tmp_path / "run")
