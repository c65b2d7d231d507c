// Wires the page: data, filter, ranking, charts, viewer, rows.

import { Columns, distinct, unpack } from "./data.js";
import { Filter } from "./filter.js";
import { setStyles } from "./look.js";
import { Rows } from "./selection.js";
import { contests } from "./contest.js";
import { standings } from "./ranking.js";
import { RankingTable } from "./ranking_table.js";
import { RawRows } from "./raw.js";
import { SceneViewer } from "./scene.js";
import { enhanceTables } from "./table.js";
import { onTheme, startTheme } from "./theme.js";
import { courseFigure } from "./figures/course.js";
import { profileFigure, timeToGapFigure } from "./figures/curves.js";
import { heatFigure } from "./figures/heat.js";
import { paretoFigure } from "./figures/points.js";
import { scalingFigure } from "./figures/scaling.js";

async function start() {
  document.querySelectorAll(".needs-js").forEach((part) => (part.hidden = false));
  startTheme(document.querySelector("#theme"));
  const page = await unpack(document.querySelector("#data").textContent);
  setStyles(page.styles);
  enhanceTables(page.styles);
  if (page.scenes.length) new SceneViewer(document.querySelector("#scene"), page.scenes);
  const filter = page.rows.count ? startRows(page) : null;
  if (page.courses.length) startCourses(page.courses, filter);
  performance.mark("ready");
  document.documentElement.dataset.ready = "yes";
}

function startRows(page) {
  const rows = new Rows(new Columns(page.windows), new Columns(page.rows));
  const values = Object.fromEntries(["scenario", "window_k", "scan_period_s", "hardness"]
    .map((name) => [name, distinct(rows.windows.column(name))]));
  const filter = new Filter({ ...values, algorithm: distinct(rows.algorithm) });
  const figures = placeFigures(page);
  const ranking = new RankingTable(document.querySelector("#ranks"), page.shift_ms);
  const raw = new RawRows(document.querySelector("#raw"), rows, page.runs);
  let state = null;
  const update = () => {
    state = stateOf(rows, filter, page.shift_ms);
    ranking.show(filter.isWhole() ? null : state);
    figures.forEach((figure) => figure.update(state));
    raw.update(state.chosen);
  };
  filter.onChange(update);
  update();
  filter.show(document.querySelector("#filters"), () =>
    `${state.chosen.length.toLocaleString("en")} of ${rows.rows.count.toLocaleString("en")} rows`);
  onTheme(() => figures.forEach((figure) => figure.redrawLegend?.()));
  return filter;
}

/** An algorithm without rows cannot be chosen, and is shown. */
function startCourses(courses, filter) {
  const isChosen = (name) => !filter?.values.algorithm.includes(name) || filter.chosen.algorithm.has(name);
  const figure = courseFigure(courses, isChosen);
  document.querySelector("#courses").append(figure.card);
  filter?.onChange(figure.update);
  onTheme(figure.redrawLegend);
}

/** Everything that charts take: the chosen rows, by algorithm, and the contests with standings. */
function stateOf(rows, filter, shift) {
  const chosen = rows.select(filter);
  const { contests: open, notes } = contests(rows, chosen);
  const found = open.map((contest) => {
    let made = null; // resampling takes time that the first sight of the page has not got
    return { contest, get standings() {
      return (made ??= standings(rows, contest, shift));
    } };
  });
  return { rows, chosen, all: rows.byAlgorithm(chosen), contests: found, notes };
}

function placeFigures(page) {
  const place = (id, ...figures) => {
    document.querySelector(id).append(...figures.map((figure) => figure.card));
    return figures;
  };
  return [
    ...place("#trade", paretoFigure()),
    ...place("#heat", heatFigure("integrality", "integral", page.lp_algorithm),
      heatFigure("gap", "gap", page.gap_algorithm)),
    ...place("#curves", profileFigure(), timeToGapFigure()),
    ...place("#growth", scalingFigure()),
  ];
}

start();
