#!/usr/bin/python3
"""Draws the figures of a study, or of the ranking, from a run, as SVG and PNG."""

import argparse
import sys
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

from mda_results import (battistelli_figures, battistelli_overview, bojilov_figures, known_targets,
                         lee_figures, plotting, pool, position_targets, rank_figures,
                         three_sensors)
from mda_results.output import print_or_tell
from mda_results.rows import RunError, unfinished

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Drawn = dict[str, Callable[[], "Figure"]]  # by file name; raises RunError if it cannot be


def _battistelli(directory: Path) -> tuple[str, list[str], Drawn]:
    run = known_targets.load(directory)
    return run.name, run.warnings, {**battistelli_figures.figures(run),
                                    **battistelli_overview.figures(run)}


def _lee(directory: Path) -> tuple[str, list[str], Drawn]:
    run = position_targets.load([directory])
    return run.name, run.warnings, lee_figures.figures(run)


def _bojilov(directory: Path) -> tuple[str, list[str], Drawn]:
    run = three_sensors.load(directory)
    return run.name, [*run.warnings, *run.lacking], bojilov_figures.figures(run)


def _ranking(directory: Path) -> tuple[str, list[str], Drawn]:
    loaded = pool.load([directory])
    return ", ".join(loaded.names), loaded.warnings, rank_figures.figures(loaded)


_STUDIES = {"battistelli2008": _battistelli, "bojilov1995": _bojilov, "lee1998": _lee,
            "ranking": _ranking}


def main(arguments: list[str] | None = None) -> int:
    """Exit code: 0 well, 2 bad usage or input, 5 writing failed."""
    options = _parse(arguments)
    directory = options.out if options.out is not None else options.run / "figures"
    try:
        written = _draw(options.study, options.run, options.only, directory)
    except RunError as error:
        print(f"figures.py: {error}", file=sys.stderr)
        return 2
    except OSError as error:
        print(f"figures.py: cannot write to {directory}: {error.strerror}", file=sys.stderr)
        return 5
    return print_or_tell("".join(f"{path}\n" for path in written), "figures.py")


def _parse(arguments: list[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("study", choices=sorted(_STUDIES), help="which figures")
    parser.add_argument("run", type=Path, metavar="RUN", help="directory of a run")
    parser.add_argument("--out", type=Path, metavar="DIR",
                        help="where the files go; without it RUN/figures")
    parser.add_argument("--only", metavar="NAME,...", type=lambda names: names.split(","),
                        help="these figures only, such as figure_4,gap_by_k; each must be possible")
    options = parser.parse_args(arguments)
    if options.out is not None and options.out.exists() and not options.out.is_dir():
        parser.error(f"--out {options.out} is not a directory")
    return options


def _draw(study: str, directory: Path, only: list[str] | None, out: Path) -> list[Path]:
    """Every figure that the run has the data for, or those of `only`; the others are named."""
    plotting.pyplot()
    name, warnings, figures = _STUDIES[study](directory)
    unknown = [f for f in only or () if f not in figures]
    if unknown:
        raise RunError(f"there is no figure {unknown[0]}; there are {', '.join(figures)}")
    for warning in [*unfinished(directory), *warnings]:
        print(f"figures.py: warning: {warning}", file=sys.stderr)
    written: list[Path] = []
    for figure_name, draw in figures.items():
        if only is not None and figure_name not in only:
            continue
        try:
            figure = draw()
        except RunError as error:
            if only is not None:
                raise
            print(f"figures.py: {figure_name} is left out: {error}", file=sys.stderr)
            continue
        out.mkdir(parents=True, exist_ok=True)
        written += plotting.save(figure, figure_name, out)
    if not written:
        raise RunError(f"{name} has the data of no figure")
    return written


if __name__ == "__main__":
    sys.exit(main())
