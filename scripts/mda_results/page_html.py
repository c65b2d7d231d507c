"""Tables and facts as HTML that is whole without a script; the page's script adds to it."""

import html
import itertools
import math
from collections.abc import Iterable

from mda_results.render import Cell, Column, Estimate, Report, Table, shown

_OPEN_ROWS = 24  # tables with more scroll
_NUMBER = ' class="number"'
_PROSE = 40  # characters from which a cell may break its line


def text(words: str) -> str:
    return html.escape(words, quote=True)


def section(name: str, title: str, about: str, *parts: str) -> str:
    """A part of the page, to be linked as #name."""
    said = f'<p class="about">{text(about)}</p>' if about else ""
    return f'<section id="{name}"><h2>{text(title)}</h2>{said}{"".join(parts)}</section>'


def place(name: str, pair: bool = True) -> str:
    """An empty part that the script fills, two cards in a row where there is room."""
    return f'<div id="{name}" class="needs-js{" pair" if pair else ""}" hidden></div>'


def facts(pairs: Iterable[tuple[str, object]]) -> str:
    lines = (f"<dt>{text(name)}</dt><dd>{text(str(value))}</dd>" for name, value in pairs)
    return f'<dl class="facts">{"".join(lines)}</dl>'


def notes(lines: Iterable[str]) -> str:
    return "".join(f'<p class="note">{text(line)}</p>' for line in lines)


def report_cards(report: Report, folded: bool = False) -> str:
    """Lines and tables of a report."""
    return notes(report.lines) + "".join(table_card(table, folded) for table in report.tables)


def table_card(table: Table, folded: bool = False) -> str:
    """A table in a card of its own; long ones get a height of their own, empty ones their notes."""
    long = len(table.rows) > _OPEN_ROWS
    grid = f'<div class="scroll{" tall" if long else ""}">{_grid(table)}</div>'
    body = (grid if table.rows else "") + notes(table.notes)
    name = text(table.name)
    if folded:
        return (f'<details class="card" data-table="{name}"><summary>{text(table.title)}</summary>'
                f'<div class="tools"></div>{body}</details>')
    return (f'<div class="card" data-table="{name}"><header><h3>{text(table.title)}</h3>'
            f'<div class="tools"></div></header>{body}</div>')


def _grid(table: Table) -> str:
    words = [_is_words(table, j) for j in range(len(table.columns))]
    heads = "".join(f'<th scope="col"{"" if word else _NUMBER}>{text(c.header)}</th>'
                    for c, word in zip(table.columns, words))
    lines = (
        "<tr>" + "".join(map(_cell, row, table.columns, words)) + "</tr>" for row in table.rows)
    return (f"<table><thead>{_blocks(table.columns)}<tr>{heads}</tr></thead>"
            f"<tbody>{''.join(lines)}</tbody></table>")


def _is_words(table: Table, column: int) -> bool:
    return any(isinstance(row[column], str) for row in table.rows)


def _blocks(columns: list[Column]) -> str:
    """The line of common headings; none if there are none."""
    if not any(column.block for column in columns):
        return ""
    spans = [(block, len(list(members)))
             for block, members in itertools.groupby(columns, key=lambda c: c.block)]
    cells = "".join(f'<th colspan="{n}">{text(block)}</th>' for block, n in spans)
    return f'<tr class="blocks">{cells}</tr>'


def _cell(cell: Cell, column: Column, words: bool) -> str:
    if isinstance(cell, str):
        long = ' class="wide"' if len(cell) > _PROSE else ""
        name = f' data-algorithm="{text(cell)}"' if column.header == "algorithm" else ""
        return f"<td{long}{name}>{text(cell)}</td>"
    value = cell.value if isinstance(cell, Estimate) else cell
    known = value is not None and not (isinstance(value, float) and math.isnan(value))
    attribute = f' data-value="{value!r}"' if known else ""
    kind = "" if words else _NUMBER
    shown_text = text(shown(cell, column))
    if isinstance(cell, Estimate) and "[" in shown_text:
        first, rest = shown_text.split(" [", 1)
        shown_text = f'{first}<span class="interval"> [{rest}</span>'
    return f"<td{kind}{attribute}>{shown_text}</td>"
