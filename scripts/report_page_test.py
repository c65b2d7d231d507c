"""The page in a real browser. Skipped, with the reason, where scripts/setup.sh --report has not
been."""

import json
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

import report
from mda_results import known_testing, page_assets, page_testing, pool, rank_report, testing
from mda_results.browser_testing import PROGRAM, Browser
from mda_results.rank_report import Selection
from mda_results.ranking_testing import MANIFEST, study
from mda_results.render import Estimate

pytestmark = [
    pytest.mark.skipif(not (page_assets.ASSETS / "node_modules").is_dir(),
                       reason="no chart library: scripts/setup.sh --report fetches it"),
    pytest.mark.skipif(PROGRAM is None, reason="no chromium: scripts/setup.sh --report fetches it"),
]

# Not every algorithm was asked on every window.
ROWS = [r for i, r in enumerate(study(4, 4)) if r["algorithm"] != "quick" or i % 7]

_TOOLS = """
window.saved = [];
URL.createObjectURL = (blob) => (window.saved.push(blob), 'blob:none');
HTMLAnchorElement.prototype.click = () => {};
"""


@pytest.fixture(scope="module")
def run(tmp_path_factory: pytest.TempPathFactory) -> Path:
    directory = tmp_path_factory.mktemp("page") / "run"
    testing.write_run(directory, ROWS, MANIFEST)
    return page_testing.write_scenes(directory, [page_testing.scene(),
                                                 page_testing.scene(2, replicate=2)])


@pytest.fixture(scope="module")
def browser(run: Path) -> Iterator[Browser]:
    path = run.parent / "page.html"
    assert report.main([str(run), "--out", str(path)]) == 0
    with Browser(run.parent / "profile") as found:
        found.path = path
        yield found


@pytest.fixture
def page(browser: Browser) -> Browser:
    """The page as a reader first sees it, who then looks all through it."""
    browser.requests.clear()
    browser.complaints.clear()
    browser.resize(1280, 900)
    browser.prefer("light")
    browser.open(browser.path)
    _walk(browser)
    return browser


def _walk(page: Browser) -> None:
    page.run("""(async () => {
      for (const plot of document.querySelectorAll('.plot')) {
        plot.scrollIntoView();
        while (plot.dataset.stale) await new Promise((done) => setTimeout(done, 20));
      }
    })()""")


def _pixels(page: Browser, name: str) -> str:
    """What a chart shows, as text to compare."""
    return page.run(f"document.querySelector('#figure-{name} canvas').toDataURL()")


def _choose(page: Browser, key: str, value: str) -> None:
    box = f"[data-key={key}] input[value='{value}']"
    page.run(f'document.querySelector("#filters {box}").click()')


def _table(page: Browser, selector: str) -> list[list[str]]:
    return page.run(f"""[...document.querySelectorAll('{selector} tbody tr')].map((row) =>
      [...row.cells].map((cell) => cell.dataset.value ?? cell.textContent.trim()))""")


def test_it_asks_for_nothing_and_complains_of_nothing(page):
    page.prefer("dark")
    page.run("document.querySelector('#theme').click()")
    page.run("document.querySelectorAll('details').forEach((part) => (part.open = true))")
    _walk(page)
    assert page.requests == [page.path.as_uri()]
    assert page.complaints == []


def test_the_slider_moves_the_scene(page):
    before = _pixels(page, "scene")
    page.run("""(() => { const slider = document.querySelector('#scene input[type=range]');
      slider.value = 3; slider.dispatchEvent(new Event('input')); })()""")
    assert "scan 3" in page.run("document.querySelector('#figure-scene h3').textContent")
    assert _pixels(page, "scene") != before


def test_answers_are_judged_against_the_truth(page):
    def said(algorithm: str) -> list[int]:
        page.run(f"""(() => {{ const select = document.querySelector('#scene [aria-label=answer]');
          select.value = [...select.options].find((o) => o.textContent === '{algorithm}').value;
          select.dispatchEvent(new Event('change')); }})()""")
        text = page.run("document.querySelector('#scene [role=status]').textContent")
        return [int(number) for number in re.findall(r"\d+", text)]

    tracks, right, wrong, missed = said("exact")
    assert tracks == page_testing.TARGETS and right > 0 and (wrong, missed) == (0, 0)
    _, confused_right, confused_wrong, confused_missed = said("greedy")
    assert confused_wrong > 0 and confused_missed == 0
    assert confused_right + confused_wrong == right


@pytest.mark.parametrize(("kept", "selection"), [
    ({"scenario": "A"}, Selection(scenarios=("A",))),
    ({"window_k": "5"}, Selection(windows=(5,))),
    ({"scenario": "B", "window_k": "3"}, Selection(scenarios=("B",), windows=(3,))),
    ({"algorithm": ("exact", "quick")}, Selection(algorithms=("exact", "quick"))),
])
def test_a_filter_ranks_anew_as_the_command_does(page, run, kept, selection):
    whole = _table(page, "[data-table=ranking]")
    _keep(page, kept)
    assert page.run("document.querySelector('#ranks .whole').hidden")
    found = _table(page, "#ranking-part")
    assert found != whole
    ranked = rank_report.rank(pool.load([run]), selection)
    expected = next(t for t in ranked.report.tables if t.name == "ranking").rows
    assert [line[0] + line[3] for line in found] == [line[0] + line[3] for line in expected]
    for ours, theirs in zip(found, expected):
        assert ours[1] == theirs[1]
        for cell, value in zip(ours[4:], theirs[4:]):
            number = value.value if isinstance(value, Estimate) else value
            assert float(cell) == pytest.approx(number, rel=1e-4, abs=1e-6)
    mark = "getComputedStyle(document.querySelector('[data-table=fates] h3'), '::after').content"
    assert "all rows" in page.run(mark)
    page.run("document.querySelector('#reset').click()")
    assert not page.run("document.querySelector('#ranks .whole').hidden")
    assert page.run(mark) == "none"


def _keep(page: Browser, kept: dict[str, Any]) -> None:
    for key, values in kept.items():
        page.run(f"document.querySelectorAll('#filters [data-key={key}] button')[1].click()")
        for value in [values] if isinstance(values, str) else values:
            _choose(page, key, value)


def test_intervals_hold_their_value(page):
    _choose(page, "scenario", "A")
    cells = page.run("""[...document.querySelectorAll('#ranking-part td.number')]
      .map((cell) => cell.textContent)""")
    intervals = [list(map(float, re.findall(r"-?[\d.]+(?:e-?\d+)?", cell)))
                 for cell in cells if "[" in cell]
    assert intervals and all(low <= value <= high for value, low, high in intervals)
    assert any(low < high for _, low, high in intervals)


def test_charts_follow_the_filter(page):
    names = ("pareto", "profile", "time-to-gap", "scaling", "heat-integrality")
    before = {name: _pixels(page, name) for name in names}
    _choose(page, "scenario", "A")
    _walk(page)
    assert all(_pixels(page, name) != before[name] for name in names)


def _search(page: Browser, words: str) -> str:
    """What is said of the rows that are found."""
    page.run(f"""(() => {{ const line = document.querySelector('#raw input[type=search]');
      line.value = {json.dumps(words)}; line.dispatchEvent(new Event('input')); }})()""")
    return page.run("document.querySelector('#raw [role=status]').textContent")


def test_a_word_that_is_a_value_finds_that_value_alone(page):
    for words, wanted in (("A", [r for r in ROWS if r["scenario"] == "A"]),
                          ("b exact", [r for r in ROWS if r["scenario"] == "B"
                                       and r["algorithm"] == "exact"]),
                          ("integral=null", [r for r in ROWS if r["integral"] is None])):
        assert wanted and _search(page, words).endswith(f"of {len(wanted):,}")


@pytest.mark.parametrize(("words", "said"), [
    ("gap_nat>1", "there is no field gap_nat"), ("gap_nats>=abc", "gap_nats>=abc needs a number"),
    ("gap_nats=", "gap_nats= needs a number")])
def test_a_search_that_means_nothing_says_why(page, words, said):
    assert _search(page, words) == said


def test_rows_can_be_searched_sorted_and_made_again(page):
    wanted = [r for r in ROWS if r["algorithm"] == "quick" and r["gap_nats"] > 0.5]
    assert wanted and _search(page, "quick gap_nats>0.5").endswith(f"of {len(wanted)}")
    page.run("""[...document.querySelectorAll('#raw th button')]
      .find((button) => button.textContent === 'gap_nats').click()""")
    first = page.run("document.querySelector('#raw tbody tr td:nth-child(9)').title")
    assert float(first) == pytest.approx(max(r["gap_nats"] for r in wanted), rel=1e-9)
    page.run("document.querySelector('#raw tbody tr').click()")
    command = page.run("document.querySelector('#raw .detail code').textContent")
    best = max(wanted, key=lambda r: r["gap_nats"])
    assert command.startswith("build/release/mda-bench run small ")
    for option, field in (("--scenarios", "scenario"), ("--windows", "window_k"),
                          ("--replicates", "replicate"), ("--algorithms", "algorithm")):
        assert f"{option} {best[field]}" in command


def test_every_figure_can_be_taken_away(page):
    page.run(_TOOLS)
    page.run("""document.querySelectorAll('figure .tools button').forEach((b) => b.click())""")
    heads = page.run("""Promise.all(window.saved.map(async (blob) =>
      [blob.type, String.fromCharCode(...new Uint8Array(await blob.slice(0, 8).arrayBuffer())),
       (await blob.text()).length]))""")
    figures = page.run("document.querySelectorAll('figure').length")
    kinds = [kind for kind, _, _ in heads]
    assert [kinds.count(k) for k in ("image/svg+xml", "image/png", "text/csv")] == [figures] * 3
    begins = {"image/svg+xml": "<svg", "image/png": "\x89PNG", "text/csv": ""}
    for kind, head, size in heads:
        assert size > 100 and head.startswith(begins[kind])


def test_it_fits_a_phone_in_both_grounds(page):
    page.resize(390, 800, phone=True)
    grounds = []
    for scheme in ("light", "dark"):
        page.prefer(scheme)
        page.open(page.path)
        _walk(page)
        assert page.run("document.documentElement.scrollWidth") <= 390
        grounds.append(page.run("getComputedStyle(document.body).backgroundColor"))
    page.run("document.querySelector('#theme').click()")
    grounds.append(page.run("getComputedStyle(document.body).backgroundColor"))
    assert grounds[0] == grounds[2] != grounds[1]


def test_one_algorithm_has_the_layout_of_many(run, browser, tmp_path):
    own = [r for r in ROWS if r["algorithm"] == "exact"]
    lonely = testing.write_run(tmp_path / "one", own, MANIFEST)
    page_testing.write_scenes(lonely, [page_testing.scene()])
    path = tmp_path / "one.html"
    assert report.main([str(lonely), "--out", str(path)]) == 0
    parts = "[...document.querySelectorAll('main > section, figure')].map((part) => part.id)"
    browser.open(browser.path)
    many = browser.run(parts)
    browser.open(path)
    _walk(browser)
    assert browser.run(parts) == many


def test_known_targets_have_paths_and_courses(browser, tmp_path):
    scenarios = ["battistelli-1", "battistelli-2"]
    known = known_testing.write_known(
        tmp_path / "known", known_testing.study_rows(2, 1, scenarios),
        known_testing.study_outings(2, scenarios))
    paths = known_testing.trajectories(scenarios)
    (known / "trajectories.json").write_text(json.dumps(paths))
    path = tmp_path / "known.html"
    assert report.main([str(known), "--out", str(path)]) == 0
    browser.complaints.clear()
    browser.open(path)
    _walk(browser)
    before = _pixels(browser, "course")
    _choose(browser, "algorithm", "scf")
    _walk(browser)
    assert _pixels(browser, "course") != before and browser.complaints == []
    names = browser.run("""[...document.querySelectorAll('#scene [aria-label=scene] option')]
      .map((option) => option.textContent.split(',')[0])""")
    assert names == list(paths)


def test_a_scene_of_two_runs_bears_the_name_of_each(browser, tmp_path):
    runs = [testing.write_run(tmp_path / name, [r for r in ROWS if r["algorithm"] == own], MANIFEST)
            for name, own in (("first", "exact"), ("second", "quick"))]
    for run in runs:
        page_testing.write_scenes(run, [page_testing.scene()])
    path = tmp_path / "two.html"
    assert report.main([*map(str, runs), "--out", str(path)]) == 0
    browser.open(path)
    names = browser.run("""[...document.querySelectorAll('#scene [aria-label=scene] option')]
      .map((option) => option.textContent)""")
    assert names == [f"A, 8 s, replicate 1 of {name}" for name in ("first", "second")]


def test_colours_are_those_of_the_palette(page):
    styles = {name: page.run(f"""document.querySelector('td[data-algorithm="{name}"] line')
      .getAttribute('stroke')""") for name in ("exact", "lp")}
    assert json.dumps(styles) == json.dumps({"exact": "#000000", "lp": "#999933"})
