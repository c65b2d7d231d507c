"""Output to places that may be full, closed, or without a reader."""

import os
import sys
from pathlib import Path


def print_or_tell(text: str, program: str) -> int:
    """Prints; exit code 0, or 5 after one sentence on standard error if that cannot be done."""
    if sys.stdout is None:
        print(f"{program}: cannot write to standard output: it is closed", file=sys.stderr)
        return 5
    try:
        sys.stdout.reconfigure(encoding="utf-8")
        sys.stdout.write(text)
        sys.stdout.flush()
    except OSError as error:
        # What is still in the buffer would be written again, and fail again, at the end.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        print(f"{program}: cannot write to standard output: {error.strerror}", file=sys.stderr)
        return 5
    return 0


def write_whole(path: Path, text: str) -> None:
    """Writes a file or, raising OSError, leaves what was there."""
    part = path.with_name(f"{path.name}.{os.getpid()}.part")
    try:
        part.write_text(text, encoding="utf-8")
        part.replace(path)
    except OSError:
        part.unlink(missing_ok=True)
        raise
