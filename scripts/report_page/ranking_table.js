// The ranking as a table: that of rank.py for all rows, one formed here for a part of them.

import { element, shown } from "./dom.js";
import { swatch } from "./look.js";
import { csvButton, makeSortable } from "./table.js";

const HEADS = ["", "algorithm", "refuted", "no answer", "proven optimal [%]", "mean gap [nats]", "p95 gap", "max gap",
  "CPU time [ms]"];

export class RankingTable {
  constructor(host, shift) {
    this.shift = shift;
    this.whole = host.querySelector("[data-table]");
    this.part = element("div", { class: "card", hidden: true, id: "ranking-part" });
    host.append(this.part);
    for (const cell of this.whole?.querySelectorAll("td[data-algorithm]") ?? []) {
      cell.prepend(swatch(cell.dataset.algorithm), " ");
    }
  }

  /** Shows a ranking() of a part, or for null the one that the page came with. */
  show(ranking) {
    if (this.whole) this.whole.hidden = ranking !== null;
    this.part.hidden = ranking === null;
    if (ranking === null) return;
    const table = this.#table(ranking);
    makeSortable(table);
    const skipped = ranking.skipped.length ? ` Not ranked, for they give no selections: ${ranking.skipped.join(", ")}.` : "";
    this.part.replaceChildren(
      element("header", {}, element("h3", {}, `Ranking of the chosen part: ${ranking.shared} windows of ` +
        `${ranking.units} scenarios`), element("div", { class: "tools" }, csvButton(table, "ranking_part"))),
      element("div", { class: "scroll" }, table),
      element("p", { class: "note" }, "Over the windows that all of these algorithms were asked. Time: shifted geometric " +
        `mean, shift ${shown(this.shift)} ms. Intervals: 95 %, resampling scenarios within their groups.${skipped}`));
  }

  #table(ranking) {
    const line = (l, place) => element("tr", {},
      element("td", { class: "number" }, l.refuted ? "–" : String(place + 1)),
      element("td", { "data-algorithm": l.algorithm, "data-value": l.algorithm }, swatch(l.algorithm), ` ${l.algorithm}`),
      number(l.refuted), number(l.unanswered), estimate(l.proven), estimate(l.gap), number(l.gapP95), number(l.gapMax),
      estimate(l.time));
    return element("table", {}, element("thead", {}, element("tr", {}, ...HEADS.map((head, i) =>
      element("th", { scope: "col", class: i > 1 ? "number" : null }, head)))),
      element("tbody", {}, ...ranking.lines.map(line)));
  }
}

const number = (value) => element("td", { class: "number", "data-value": value }, shown(value));

function estimate(e) {
  if (!e) return element("td", { class: "number" }, "—");
  const interval = e.low === null ? null
    : element("span", { class: "interval" }, ` [${shown(e.low)}, ${shown(e.high)}]`);
  return element("td", { class: "number", "data-value": e.value }, shown(e.value), interval);
}
