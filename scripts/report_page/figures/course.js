// Closed loops scan by scan: how far the tracks are from the truth, and how often they are right.

import { Figure, axis } from "../figure.js";
import { choice, element, shown } from "../dom.js";
import { distinct } from "../data.js";
import { legend, lookOf } from "../look.js";

const NAMES = { position_error_series_m: "distance to the truth [m]",
  ideal_series_m: "the same of the ideal filter [m]", oracle_series_m: "the same of the oracle [m]",
  right_series: "right decisions, share" };
const named = (name) => NAMES[name] ?? name.replaceAll("_", " ");
const sceneOf = (course) => `${course.scenario}, ${course.scan_period_s} s`;

/** `courses`: of page_courses.py; `isChosen(algorithm)`: whether the reader wants to see it. */
export function courseFigure(courses, isChosen) {
  const scenes = distinct(courses.map(sceneOf));
  const measures = distinct(courses.flatMap((course) => Object.keys(course.series)));
  const view = { scene: scenes[0], k: null,
    measure: measures.includes("position_error_series_m") ? "position_error_series_m" : measures[0] };
  let lines = [];
  const controls = element("div", { class: "controls" });
  const figure = new Figure({
    name: "course", title: "Scan by scan", controls, height: (width) => (width < 500 ? 320 : 400),
    note: "Means over the scenes that finished. It follows the choice of algorithms; the other filters are of " +
      "windows in open loop.",
    draw: () => options(lines, view.measure),
    lines: () => [["algorithm", "scan", "time_s", view.measure], ...lines.flatMap((course) =>
      course.series[view.measure].map((value, i) => [course.algorithm, i + 1, (i + 1) * course.scan_period_s, value]))],
  });
  const show = () => {
    const here = courses.filter((course) => sceneOf(course) === view.scene && view.measure in course.series);
    const ks = distinct(here.map((course) => course.window_k));
    if (!ks.includes(view.k)) view.k = ks.includes(3) ? 3 : ks[0];
    lines = here.filter((course) => course.window_k === view.k && isChosen(course.algorithm));
    const pick = (key, parse = (text) => text) => (value) => {
      view[key] = parse(value);
      show();
    };
    controls.replaceChildren(
      choice("scene", scenes.map((name) => [name, name]), pick("scene"), view.scene),
      choice("K", ks.map((k) => [String(k), String(k)]), pick("k", Number), String(view.k)),
      choice("measure", measures.map((name) => [name, named(name)]), pick("measure"), view.measure));
    figure.title.textContent = `${view.scene}, K = ${view.k}: ${named(view.measure)} ` +
      `(${Math.max(0, ...lines.map((course) => course.scenes))} scenes)`;
    figure.redrawLegend();
    figure.refresh();
  };
  figure.redrawLegend = () => figure.below.replaceChildren(legend(lines.map((course) => course.algorithm)));
  figure.update = show;
  show();
  return figure;
}

function options(lines, measure) {
  return {
    grid: { left: 60, right: 16, top: 12, bottom: 46 },
    xAxis: axis("scan", { type: "value", min: 1, max: "dataMax", minInterval: 1 }),
    yAxis: axis(named(measure), { type: "value", nameGap: 42, scale: true }),
    tooltip: { trigger: "axis", order: "valueDesc", valueFormatter: (value) => shown(value) },
    series: lines.map((course) => {
      const { color, dash } = lookOf(course.algorithm);
      return { name: course.algorithm, type: "line", showSymbol: false, color,
        lineStyle: { color, type: dash, width: 2 }, data: course.series[measure].map((value, i) => [i + 1, value]) };
    }),
  };
}
