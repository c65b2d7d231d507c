"""The machine of a session, as `mda-bench doctor` sees it, and the programs that ran on it."""

import hashlib
import json
import subprocess
from collections.abc import Iterable
from datetime import datetime, timezone
from pathlib import Path
from typing import Any

from mda_results.rows import RunError


def state(mda_bench: Path) -> dict[str, Any]:
    """What `mda-bench doctor --json` prints; raises RunError if it does not."""
    words = [str(mda_bench), "doctor", "--json"]
    try:
        done = subprocess.run(words, capture_output=True, text=True, check=False)
        return json.loads(done.stdout)
    except OSError as error:
        raise RunError(f"{words[0]} cannot be run: {error.strerror}") from None
    except ValueError:
        raise RunError(f"'{' '.join(words)}' printed no JSON: {done.stderr.strip()}") from None


def hashes(programs: Path, names: Iterable[str]) -> dict[str, str]:
    """SHA-256 of the programs that are in a directory."""
    return {name: hashlib.sha256((programs / name).read_bytes()).hexdigest()
            for name in sorted(names) if (programs / name).is_file()}


def now() -> str:
    """The time, UTC."""
    return datetime.now(timezone.utc).strftime("%Y-%m-%dT%H:%M:%SZ")
