"""The layer check finds what is planted, and nothing in what is allowed or in the real tree."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

import check_layers

ROOT = Path(__file__).resolve().parent.parent

# A small tree in which every layer uses all that it may.
LEGAL = {
    "algorithms/api/problem.h": "#pragma once\n#include <vector>\n",
    "algorithms/api/problem.cc": '#include "algorithms/api/problem.h"\n#include <cmath>\n',
    "algorithms/api/problem_test.cc": (
        '#include "algorithms/api/problem.h"\n#include "algorithms/testing/contract.h"\n'
        "#include <gtest/gtest.h>\n#include <rapidcheck.h>\n"
    ),
    "algorithms/backends/clp.h": '#pragma once\n#include "algorithms/api/problem.h"\n',
    "algorithms/backends/clp.cc": (
        '#include "algorithms/backends/clp.h"\n#include <ClpSimplex.hpp>\n'
    ),
    "algorithms/backends/flow.cc": "#include <lemon/network_simplex.h>\n",
    "algorithms/backends/flow_test.cc": '#include "algorithms/catalog.h"\n',
    "algorithms/relaxation/rounding.h": "#pragma once\n",
    "algorithms/relaxation/lp.h": "#pragma once\n",
    "algorithms/relaxation/lp_grp.h": "#pragma once\n",
    "algorithms/relaxation/lp_grp.cc": (
        '#include "algorithms/relaxation/lp_grp.h"\n#include "algorithms/relaxation/rounding.h"\n'
        '#include "algorithms/backends/clp.h"\n#include "algorithms/api/problem.h"\n'
    ),
    "algorithms/relaxation/lp_grp_test.cc": (
        '#include "algorithms/relaxation/lp_grp.h"\n#include "algorithms/relaxation/lp.h"\n'
        "#include <sys/wait.h>\n"
    ),
    "algorithms/catalog.h": '#pragma once\n#include "algorithms/api/problem.h"\n',
    "algorithms/catalog.cc": (
        '#include "algorithms/catalog.h"\n#include "algorithms/relaxation/lp.h"\n'
        '#include "algorithms/relaxation/lp_grp.h"\n'
    ),
    "algorithms/testing/contract.h": (
        '#pragma once\n#include "algorithms/catalog.h"\n#include <gtest/gtest.h>\n'
    ),
    "scenarios/filter/ekf.h": (
        '#pragma once\n#include <Eigen/Core>\n#include <boost/random.hpp>\n'
        '#include "algorithms/api/problem.h"\n'
    ),
    "scenarios/filter/ekf_bench.cc": (
        '#include "scenarios/filter/ekf.h"\n#include "scenarios/testing/reference.h"\n'
        "#include <benchmark/benchmark.h>\n"
    ),
    "scenarios/testing/reference.h": (
        '#pragma once\n#include "scenarios/filter/ekf.h"\n#include <gtest/gtest.h>\n'
    ),
    "scenarios/testing/reference.cc": '#include "scenarios/testing/reference.h"\n',
    "harness/main.cc": (
        '#include "algorithms/catalog.h"\n#include "scenarios/filter/ekf.h"\n#include <omp.h>\n'
        "#include <CLI/CLI.hpp>\n#include <fmt/core.h>\n#include <nlohmann/json.hpp>\n"
        "#include <toml++/toml.h>\n#include <unistd.h>\n"
    ),
}


@pytest.fixture
def tree(tmp_path: Path) -> Path:
    for path, text in LEGAL.items():
        file = tmp_path / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")
    return tmp_path


def test_what_every_layer_may_do_passes(tree: Path) -> None:
    assert check_layers.violations(tree) == []


def test_the_real_tree_passes() -> None:
    assert check_layers.violations(ROOT) == []


PLANTED = [
    # Third-party libraries outside their layer.
    ("algorithms/api/problem.cc", "<Eigen/Core>"),
    ("algorithms/api/problem.cc", "<unistd.h>"),
    ("algorithms/api/problem.h", "<fmt/core.h>"),
    ("algorithms/relaxation/lp_grp.cc", "<ClpSimplex.hpp>"),
    ("algorithms/relaxation/lp_grp.cc", "<lemon/smart_graph.h>"),
    ("algorithms/relaxation/lp_grp_test.cc", "<coin/CbcModel.hpp>"),
    ("algorithms/relaxation/lp_grp.cc", "<gtest/gtest.h>"),
    ("algorithms/catalog.cc", "<nlohmann/json.hpp>"),
    ("algorithms/testing/contract.h", "<OsiClpSolverInterface.hpp>"),
    ("scenarios/filter/ekf.h", "<CoinPackedMatrix.hpp>"),
    ("scenarios/filter/ekf.h", "<omp.h>"),
    ("harness/main.cc", "<Eigen/Core>"),
    ("harness/main.cc", "<CbcModel.hpp>"),
    ("harness/main.cc", "<gtest/gtest.h>"),
    ("harness/main.cc", "<spdlog/spdlog.h>"),
    # Own layers in the wrong direction.
    ("algorithms/api/problem.cc", '"algorithms/backends/clp.h"'),
    ("algorithms/api/problem_test.cc", '"algorithms/relaxation/lp.h"'),
    ("algorithms/backends/clp.cc", '"algorithms/relaxation/rounding.h"'),
    ("algorithms/relaxation/lp_grp.cc", '"scenarios/filter/ekf.h"'),
    ("algorithms/relaxation/lp_grp.cc", '"algorithms/catalog.h"'),
    ("algorithms/relaxation/lp_grp.cc", '"algorithms/testing/contract.h"'),
    ("algorithms/exact/cbc.cc", '"algorithms/relaxation/rounding.h"'),
    ("algorithms/catalog.cc", '"algorithms/backends/clp.h"'),
    ("scenarios/filter/ekf.h", '"algorithms/catalog.h"'),
    ("scenarios/filter/ekf.h", '"algorithms/backends/clp.h"'),
    ("scenarios/filter/ekf_bench.cc", '"algorithms/relaxation/lp.h"'),
    ("scenarios/filter/ekf_bench.cc", '"algorithms/catalog.h"'),
    ("harness/main.cc", '"algorithms/relaxation/lp_grp.h"'),
    ("harness/main.cc", '"algorithms/backends/clp.h"'),
    ("harness/main.cc", '"algorithms/testing/contract.h"'),
    # What is for tests only, elsewhere.
    ("scenarios/filter/ekf.h", '"scenarios/testing/reference.h"'),
    ("harness/main.cc", '"scenarios/testing/reference.h"'),
    ("scenarios/testing/reference.h", '"algorithms/backends/clp.h"'),
    # One algorithm in another.
    ("algorithms/relaxation/lp_grp.cc", '"algorithms/relaxation/lp.h"'),
    # Names that are not from the root, or of nothing.
    ("algorithms/relaxation/lp_grp.cc", '"rounding.h"'),
    ("algorithms/relaxation/lp_grp.cc", '"../api/problem.h"'),
    ("algorithms/relaxation/lp_grp.cc", '"algorithms/relaxation/../api/problem.h"'),
    ("algorithms/relaxation/lp_grp.cc", '"algorithms/api/absent.h"'),
    ("algorithms/relaxation/lp_grp.cc", "<algorithms/api/problem.h>"),
    ("algorithms/relaxation/lp_grp.cc", '"fmt/core.h"'),
]


@pytest.mark.parametrize(("path", "header"), PLANTED)
def test_a_planted_include_is_found_at_its_line(tree: Path, path: str, header: str) -> None:
    file = tree / path
    file.parent.mkdir(exist_ok=True)
    before = LEGAL.get(path, "")
    file.write_text(f"{before}  #  include {header}  // planted\n", encoding="utf-8")
    line = before.count("\n") + 1
    found = check_layers.violations(tree)
    assert len(found) == 1
    assert found[0].startswith(f"{path}:{line}: ")
    assert header.strip('"<>') in found[0]


def test_a_header_without_pragma_once_is_found(tree: Path) -> None:
    (tree / "scenarios/spec.h").write_text("struct Spec;\n", encoding="utf-8")
    assert check_layers.violations(tree) == ["scenarios/spec.h:1: a header needs #pragma once"]


def test_includes_in_comments_are_no_includes(tree: Path) -> None:
    (tree / "harness/cli.cc").write_text("// #include <CbcModel.hpp>\n", encoding="utf-8")
    assert check_layers.violations(tree) == []


def run_script(root: Path) -> subprocess.CompletedProcess[str]:
    script = ROOT / "scripts" / "check_layers.py"
    command = [sys.executable, str(script), "--root", str(root)]
    return subprocess.run(command, capture_output=True, text=True, check=False)


@pytest.mark.parametrize(("planted", "exit_code"), [("", 0), ("#include <Eigen/Core>\n", 1)])
def test_the_exit_code_tells(tree: Path, planted: str, exit_code: int) -> None:
    (tree / "algorithms/api/ids.h").write_text(f"#pragma once\n{planted}", encoding="utf-8")
    run = run_script(tree)
    assert run.returncode == exit_code
    assert len(run.stdout.splitlines()) == exit_code


def test_a_root_without_the_project_is_refused(tmp_path: Path) -> None:
    run = run_script(tmp_path)
    assert run.returncode == 2
    assert run.stdout == ""
    assert len(run.stderr.splitlines()) == 1
