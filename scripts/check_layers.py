#!/usr/bin/python3
"""Reads the #include lines of all C++ files and reports those that break the layers.

Algorithms and scenarios meet only in algorithms/api: a solver sees no filter and no Eigen, a maker
of problems sees no solver, and the harness names no algorithm, it walks the catalogue.

  layer                  may include, beside itself and the standard library
  algorithms/api         nothing
  algorithms/backends    api; COIN, LEMON (nobody else may)
  algorithms/<family>    api, backends; of its own family, what is not itself an algorithm
  algorithms/catalog.*   api, every family
  algorithms/testing     api, backends, catalog.h; what tests may
  scenarios              algorithms/api; Eigen, Boost
  harness                algorithms/api, catalog.h, scenarios; fmt, CLI11, nlohmann-json, toml++,
                         omp.h, headers of the operating system
  *_test.cc, *_bench.cc  what their layer may, algorithms/testing, in algorithms also catalog.h;
                         GoogleTest, RapidCheck, Google Benchmark, headers of the operating system

A folder named testing serves tests: its files may include what tests may, and only tests and other
files of such folders may include them.

Own headers are named from the root in quotes, all others in angle brackets. Every header has
#pragma once.
"""

from __future__ import annotations

import argparse
import re
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

OWN_FOLDERS = ("algorithms", "scenarios", "harness")

# Third-party headers by the start of their name. A name without dot and slash is of the standard
# library.
THIRD_PARTY = {
    "COIN": ("Cbc", "Cgl", "Clp", "Coin", "Osi", "coin/"),
    "LEMON": ("lemon/",),
    "lp_solve": ("lpsolve/",),
    "GLPK": ("glpk.h",),
    "Eigen": ("Eigen/", "unsupported/Eigen/", "eigen3/"),
    "Boost": ("boost/",),
    "fmt": ("fmt/",),
    "CLI11": ("CLI/",),
    "nlohmann-json": ("nlohmann/",),
    "toml++": ("toml++/",),
    "OpenMP": ("omp.h",),
    "GoogleTest": ("gtest/", "gmock/"),
    "RapidCheck": ("rapidcheck",),
    "Google Benchmark": ("benchmark/",),
}
TEST_LIBRARIES = frozenset({"GoogleTest", "RapidCheck", "Google Benchmark", "operating system"})

OPERATING_SYSTEM = re.compile(r"(sys/)?[a-z_]+\.h")
INCLUDE = re.compile(r'^\s*#\s*include\s*(?P<open>["<])(?P<name>[^">]+)[">]')


@dataclass(frozen=True)
class Layer:
    """Where a file stands, and what it may include; own layers by the names of layer_of()."""

    name: str
    own: frozenset[str]
    libraries: frozenset[str] = frozenset()


def layer_of(path: str) -> str:
    """The layer of a file named from the root; "" outside the own folders.

    A family of algorithms is its own layer: "algorithms/flow".
    """
    parts = path.split("/")
    if parts[0] in ("scenarios", "harness") and len(parts) > 1:
        return parts[0]
    if parts[0] != "algorithms" or len(parts) < 2:
        return ""
    return "/".join(parts[:2]) if len(parts) > 2 else "algorithms"


def is_family(layer: str) -> bool:
    return layer.startswith("algorithms/") and layer not in (
        "algorithms/api",
        "algorithms/backends",
        "algorithms/testing",
    )


def is_test(path: str) -> bool:
    return path.endswith(("_test.cc", "_bench.cc"))


def serves_tests(path: str) -> bool:
    return is_test(path) or "testing" in path.split("/")[:-1]


def rules_for(path: str) -> Layer:
    """What the file at `path` (from the root) may include."""
    name = layer_of(path)
    rules = {
        "algorithms/api": Layer(name, frozenset({"algorithms/api"})),
        "algorithms/backends": Layer(
            name,
            frozenset({"algorithms/api", "algorithms/backends"}),
            frozenset({"COIN", "LEMON", "lp_solve", "GLPK"}),
        ),
        "algorithms/testing": Layer(name, frozenset({"algorithms/api", "algorithms/backends"})),
        "algorithms": Layer(name, frozenset({"algorithms/api", "algorithms", "<family>"})),
        "scenarios": Layer(
            name, frozenset({"algorithms/api", "scenarios"}), frozenset({"Eigen", "Boost"})
        ),
        "harness": Layer(
            name,
            frozenset({"algorithms/api", "algorithms", "scenarios", "harness"}),
            frozenset({"fmt", "CLI11", "nlohmann-json", "toml++", "OpenMP", "operating system"}),
        ),
    }.get(name) or Layer(name, frozenset({"algorithms/api", "algorithms/backends", name}))
    if serves_tests(path):
        others = {"algorithms/testing"}
        if name.startswith("algorithms"):
            others.add("algorithms")
        label = f"a test of {name}" if is_test(path) else name
        return Layer(label, rules.own | others, rules.libraries | TEST_LIBRARIES)
    return rules


def library_of(name: str) -> str:
    """The library that a header in angle brackets belongs to."""
    for library, starts in THIRD_PARTY.items():
        if name.startswith(starts):
            return library
    if "." not in name and "/" not in name:
        return "standard library"
    return "operating system" if OPERATING_SYSTEM.fullmatch(name) else "a library of no layer"


def includes(path: Path) -> Iterator[tuple[int, str, str]]:
    """Line number, opening character ('"' or '<') and name of every #include line."""
    lines = path.read_text(encoding="utf-8").splitlines()
    for number, line in enumerate(lines, start=1):
        if found := INCLUDE.match(line):
            yield number, found["open"], found["name"]


def algorithm_headers(root: Path) -> frozenset[str]:
    """The headers that declare a factory of an algorithm: those that the catalogue includes."""
    catalog = root / "algorithms" / "catalog.cc"
    if not catalog.is_file():
        return frozenset()
    return frozenset(name for _, _, name in includes(catalog) if is_family(layer_of(name)))


def own_header_fault(root: Path, path: str, name: str, algorithms: frozenset[str]) -> str | None:
    """What is wrong with `path` including the own header `name`, if anything is."""
    if ".." in name.split("/") or name.split("/")[0] not in OWN_FOLDERS:
        return f'"{name}" is not named from the root (quotes are for our own headers)'
    if not (root / name).is_file():
        return f'"{name}" does not exist'
    rules = rules_for(path)
    target = layer_of(name)
    if target not in rules.own and not (is_family(target) and "<family>" in rules.own):
        return f'{rules.name} must not include "{name}"'
    if serves_tests(name) and not serves_tests(path):
        return f'"{name}" is for tests only'
    own_header = path.removesuffix(".cc") + ".h"
    if target == layer_of(path) and name in algorithms and name != own_header and not is_test(path):
        return f'an algorithm must not include another one, "{name}"; compose through Associator'
    return None


def foreign_header_fault(path: str, name: str) -> str | None:
    """What is wrong with `path` including <name>, if anything is."""
    if name.split("/")[0] in OWN_FOLDERS:
        return f"<{name}> is our own header and belongs in quotes"
    rules = rules_for(path)
    library = library_of(name)
    if library == "standard library" or library in rules.libraries:
        return None
    return f"{rules.name} must not include <{name}> ({library})"


def violations(root: Path) -> list[str]:
    """Every broken rule below `root` as "file:line: rule", in the order of the files."""
    algorithms = algorithm_headers(root)
    found = []
    files = [f for folder in OWN_FOLDERS for f in (root / folder).rglob("*") if f.is_file()]
    for file in sorted(f for f in files if f.suffix in (".h", ".cc")):
        path = file.relative_to(root).as_posix()
        lines = file.read_text(encoding="utf-8").splitlines()
        if file.suffix == ".h" and "#pragma once" not in lines:
            found.append(f"{path}:1: a header needs #pragma once")
        for number, opening, name in includes(file):
            fault = (
                own_header_fault(root, path, name, algorithms)
                if opening == '"'
                else foreign_header_fault(path, name)
            )
            if fault:
                found.append(f"{path}:{number}: {fault}")
    return found


def main() -> int:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument(
        "--root",
        type=Path,
        default=Path(__file__).resolve().parent.parent,
        help="the tree to check (default: the one this script is in)",
    )
    root = parser.parse_args().root
    if not (root / "algorithms").is_dir():
        print(f"check_layers.py: there is no folder algorithms in {root}", file=sys.stderr)
        return 2
    found = violations(root)
    for line in found:
        print(line)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
