// The ranking as a table: that of rank.py for all rows, one formed here for a part of them.

import { element, shown } from "./dom.js";
import { swatch } from "./look.js";
import { csvButton, makeSortable } from "./table.js";

const HEADS = ["hardness", "place", "95 %", "algorithm", "refuted", "proven optimal [%]", "mean certified gap [nats]",
  "p95", "max", "CPU, shifted geo. mean [ms]", "PAR-2"];
const FIRST_NUMBER = 4;

export class RankingTable {
  constructor(host, shift) {
    this.shift = shift;
    this.whole = host.querySelector(".whole");
    this.part = element("div", { class: "card", hidden: true, id: "ranking-part" });
    host.prepend(this.part);
  }

  /** Shows the standings of a part, {contests, notes}, or for null the table that the page came with. */
  show(state) {
    const part = state?.contests ?? null;
    this.whole.hidden = part !== null;
    document.documentElement.classList.toggle("part", part !== null);
    this.part.hidden = part === null;
    if (part === null) return;
    const table = this.#table(part);
    makeSortable(table);
    const counts = part.map(({ contest }) => `${contest.hardness}: ${contest.windows.length} windows of ` +
      `${contest.unitGroups.length} scenes`);
    this.part.replaceChildren(
      element("header", {}, element("h3", {}, "Ranking of the chosen part"),
        element("div", { class: "tools" }, csvButton(table, "ranking_part"))),
      element("p", { class: "note" }, part.length ? `${counts.join("; ")}, the same for all algorithms.`
        : "Nothing to rank in this part."),
      element("div", { class: "scroll" }, table),
      ...state.notes.map((note) => element("p", { class: "note" }, note)),
      element("p", { class: "note" },
        `Columns and order as in the ranking of all rows; shift ${shown(this.shift)} ms. ` +
        "Brackets: 95 % of 1000 resamples of scenes."));
  }

  #table(part) {
    const lines = part.flatMap(({ contest, standings }) =>
      standings.map((line) => lineOf(contest.hardness, line)));
    return element("table", {}, element("thead", {}, element("tr", {}, ...HEADS.map((head, i) =>
      element("th", { scope: "col", class: i >= FIRST_NUMBER ? "number" : null }, head)))),
      element("tbody", {}, ...lines));
  }
}

function lineOf(hardness, line) {
  const spread = line.place && line.place.low !== null
    ? `${Math.round(line.place.low)}-${Math.round(line.place.high)}` : "—";
  return element("tr", {}, element("td", {}, hardness),
    element("td", { "data-value": line.place?.value }, line.place ? String(line.place.value) : "out"),
    element("td", {}, spread),
    element("td", { "data-algorithm": line.algorithm, "data-value": line.algorithm },
      swatch(line.algorithm), ` ${line.algorithm}`),
    number(line.refuted), estimate(line.proven, 1), estimate(line.certifiedGap, 3), number(line.gapP95, 2),
    number(line.gapMax, 2), estimate(line.time, 3), number(line.penalised));
}

const fixed = (value, places) =>
  (Number.isFinite(value) && places !== undefined ? value.toFixed(places) : shown(value));
const number = (value, places) =>
  element("td", { class: "number", "data-value": Number.isNaN(value) ? null : value }, fixed(value, places));

function estimate(e, places) {
  const interval = e.low === null ? null
    : element("span", { class: "interval" }, ` [${fixed(e.low, places)}, ${fixed(e.high, places)}]`);
  return element("td", { class: "number", "data-value": e.value }, fixed(e.value, places), interval);
}
