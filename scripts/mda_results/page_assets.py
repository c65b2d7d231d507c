"""The script of the page: our modules and the chart library in one piece, and its licences."""

import html
import os
import subprocess
from pathlib import Path

from mda_results.rows import RunError

SOURCES = Path(__file__).resolve().parents[1] / "report_page"
ASSETS = SOURCES.parents[1] / "build" / "report-assets"  # made by scripts/setup.sh --report

_PACKAGES = ("echarts", "zrender", "tslib")  # what ends up in the page
_LICENCE_FILES = ("LICENSE", "LICENSE.txt", "NOTICE", "CopyrightNotice.txt")


def bundle() -> str:
    """Everything that runs in the page, minified; the same sources give the same text. Raises
    RunError when the chart library or the bundler is not there."""
    program = ASSETS / "node_modules" / ".bin" / "esbuild"
    missing = [path for path in (program, *(_package(name) for name in _PACKAGES))
               if not path.exists()]
    if missing:
        raise RunError("the page needs a chart library that is not here yet: run "
                       "scripts/setup.sh --report, which fetches it")
    command = [str(program), str(SOURCES / "main.js"), "--bundle", "--minify", "--format=iife",
               "--target=es2020", "--charset=utf8", "--legal-comments=none", "--log-level=error"]
    environment = {**os.environ, "NODE_PATH": str(ASSETS / "node_modules")}
    try:
        done = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
    except OSError as error:
        raise RunError(f"{program} cannot be run ({error.strerror}): run scripts/setup.sh --report "
                       "again") from None
    if done.returncode != 0:
        said = " ".join(done.stderr.split()) or "no reason given"
        raise RunError(f"esbuild cannot make the page's script: {said}")
    return done.stdout


def licences() -> str:
    """HTML with the licence texts of what bundle() puts into the page."""
    parts = ["<p>mda-bench and this page: Apache License 2.0. The charts are drawn by Apache "
             "ECharts, which brings zrender and tslib.</p>"]
    for name in _PACKAGES:
        texts = [(_package(name) / file).read_text(encoding="utf-8").strip()
                 for file in _LICENCE_FILES if (_package(name) / file).is_file()]
        shown = "\n\n".join(texts) or "The package brings no licence text."
        parts.append(f"<h3>{name}</h3>\n<pre>{html.escape(shown)}</pre>")
    return "\n".join(parts)


def _package(name: str) -> Path:
    return ASSETS / "node_modules" / name
