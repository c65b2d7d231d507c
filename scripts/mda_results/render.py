"""Tables and how they are written: aligned text, Markdown, CSV."""

import csv
import io
import itertools
import json
import math
import textwrap
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

MISSING = "—"
_WIDTH = 118  # of running text


@dataclass(frozen=True)
class Estimate:
    """A value with its interval; what follows is None where no interval can be given."""

    value: float
    low: float | None = None
    high: float | None = None
    error: float | None = field(default=None, compare=False)  # standard error


Cell = str | int | float | Estimate | None  # None and NaN: does not apply or is not known


@dataclass(frozen=True)
class Column:
    header: str
    block: str = ""  # neighbours of the same block stand under one common heading
    digits: str = ""  # format specification of floats, as in ".1f"
    interval: bool = False  # holds Estimates
    once: bool = False  # text leaves out a value equal to the one above

    @property
    def full_header(self) -> str:
        return f"{self.block} {self.header}".strip()


@dataclass
class Table:
    name: str  # of its CSV file
    title: str
    columns: list[Column]
    rows: list[list[Cell]]
    notes: list[str] = field(default_factory=list)


@dataclass
class Report:
    name: str
    lines: list[str]  # what a reader must know before the tables
    tables: list[Table]
    figures: dict[str, Callable[[], Any]] = field(default_factory=dict)  # matplotlib, by file name


def shown(cell: Cell, column: Column) -> str:
    if isinstance(cell, Estimate):
        value = shown(cell.value, column)
        if cell.low is None or cell.high is None:
            return value
        return f"{value} [{cell.low:{column.digits}}, {cell.high:{column.digits}}]"
    if cell is None or (isinstance(cell, float) and math.isnan(cell)):
        return MISSING
    return f"{cell:{column.digits}}" if isinstance(cell, float) else str(cell)


def to_text(report: Report) -> str:
    """Aligned plain text, for a terminal."""
    about = [textwrap.fill(line, _WIDTH, subsequent_indent="  ") for line in report.lines]
    parts = ["\n".join(about)]
    for table in report.tables:
        notes = [
            textwrap.fill(note, _WIDTH, initial_indent="  ", subsequent_indent="    ")
            for note in table.notes
        ]
        parts.append("\n".join([table.title, *_text_grid(table), *notes]))
    return "\n\n".join(parts) + "\n"


def _text_grid(table: Table) -> list[str]:
    cells = [[shown(cell, c) for cell, c in zip(row, table.columns)] for row in table.rows]
    headers = [c.header for c in table.columns]
    widths = [max(map(len, texts)) for texts in zip(headers, *cells)]
    blocks = _block_line([c.block for c in table.columns], widths)
    words = [any(isinstance(row[j], str) for row in table.rows) for j in range(len(widths))]

    def line(texts: list[str]) -> str:
        padded = (t.ljust(w) if is_word else t.rjust(w)
                  for t, w, is_word in zip(texts, widths, words))
        return "  ".join(padded).rstrip()

    above: list[str] = [""] * len(widths)
    lines = []
    for texts in cells:
        lines.append(line(["" if c.once and t == up else t
                           for t, up, c in zip(texts, above, table.columns)]))
        above = texts
    return [*blocks, line(headers), "  ".join("-" * w for w in widths), *lines]


def _block_line(blocks: list[str], widths: list[int]) -> list[str]:
    """The line of common headings, each centred over its columns; none if there are no blocks.

    Widens `widths` where a heading is longer than its columns.
    """
    if not any(blocks):
        return []
    parts = []
    for block, members in itertools.groupby(range(len(blocks)), key=lambda j: blocks[j] or -j):
        columns = list(members)
        heading = f" {block} " if isinstance(block, str) else ""
        width = sum(widths[j] + 2 for j in columns) - 2
        widths[columns[0]] += max(0, len(heading) - width)
        parts.append(heading.center(max(width, len(heading)), "." if heading else " "))
    return ["  ".join(parts).rstrip()]


def to_markdown(report: Report) -> str:
    """Markdown with pipe tables."""
    parts = [f"# {report.name}", "\n".join(f"- {line}" for line in report.lines)]
    for table in report.tables:
        headers = [c.full_header for c in table.columns]
        grid = [headers, ["---"] * len(headers)]
        grid += [[shown(cell, c) for cell, c in zip(row, table.columns)] for row in table.rows]
        lines = ["| " + " | ".join(t.replace("|", "\\|") for t in row) + " |" for row in grid]
        parts += [f"## {table.title}", "\n".join(lines)]
        if table.notes:
            parts.append("\n".join(f"- {note}" for note in table.notes))
    return "\n\n".join(parts) + "\n"


def write_csv(table: Table, directory: Path) -> Path:
    """Writes DIRECTORY/<name>.csv, as csv_lines(), and returns its path."""
    path = directory / f"{table.name}.csv"
    path.write_text(csv_lines(table), encoding="utf-8", newline="")
    return path


def csv_lines(table: Table) -> str:
    """The table as CSV in full precision.

    An interval takes two further columns, `… low` and `… high`; an empty field is what text shows
    as a dash.
    """
    stream = io.StringIO()
    writer = csv.writer(stream, lineterminator="\n")
    writer.writerow([name for c in table.columns for name in _csv_headers(c)])
    for row in table.rows:
        fields = zip(row, table.columns)
        writer.writerow([v for cell, column in fields for v in _csv_values(cell, column)])
    return stream.getvalue()


def to_json(report: Report) -> str:
    """One object: name, about, tables; a table has its name, title, columns, rows (lists, not
    rounded) and notes. An Estimate is {"value", "low", "high"}; what is not known or not finite is null."""
    tables = [{"name": t.name, "title": t.title, "columns": [c.full_header for c in t.columns],
               "rows": [[_json_value(cell) for cell in row] for row in t.rows], "notes": t.notes}
              for t in report.tables]
    whole = {"name": report.name, "about": report.lines, "tables": tables}
    return json.dumps(whole, ensure_ascii=False, allow_nan=False, indent=1) + "\n"


def _json_value(cell: Cell) -> object:
    if isinstance(cell, Estimate):
        return {name: _json_value(getattr(cell, name)) for name in ("value", "low", "high")}
    return None if isinstance(cell, float) and not math.isfinite(cell) else cell


def _csv_headers(column: Column) -> list[str]:
    name = column.full_header
    return [name, f"{name} low", f"{name} high"] if column.interval else [name]


def _csv_values(cell: Cell, column: Column) -> list[Cell]:
    if isinstance(cell, Estimate):
        values: list[Cell] = [cell.value, cell.low, cell.high]
    else:
        values = [cell, None, None] if column.interval else [cell]
    return [None if isinstance(v, float) and math.isnan(v) else v for v in values]
