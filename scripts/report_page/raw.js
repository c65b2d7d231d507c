// Every row: filtered by the page's filter and by a search line, sorted, a page at a time, with the
// command that makes a row again.

import { csv, element, save, shown } from "./dom.js";
import { compare } from "./table.js";

const PAGE = 50;
const PAGER = [["«", -Infinity, "first page"], ["‹", -1, "page before"], ["›", 1, "next page"],
  ["»", Infinity, "last page"]];
const TEXTS = ["scenario", "algorithm", "status", "stop", "note", "fingerprint", "fate"];
const COLUMNS = ["scenario", "scan_period_s", "replicate", "window_k", "scan", "algorithm", "status",
  "cost_nats", "gap_nats", "certified_gap_nats", "integral", "columns", "cpu_ms", "wall_ms", "note"];

/** A test of a row from a search line; throws an Error that says which term is none. */
function searcher(rows, line) {
  const terms = line.trim().split(/\s+/).filter(Boolean).map((term) => {
    const found = /^([a-z_0-9]+)(<=|>=|<|>|=)(.*)$/.exec(term);
    return found ? comparison(rows, term, ...found.slice(1)) : word(rows, term.toLowerCase());
  });
  return (row) => terms.every((term) => term(row));
}

/** FIELD<NUMBER, FIELD>NUMBER, FIELD=VALUE; =null finds what has no value. */
function comparison(rows, term, field, sign, text) {
  if (!(rows.rows.has(field) || rows.windows.has(field))) throw new Error(`there is no field ${field}`);
  const number = Number(text);
  if (!text || (sign !== "=" && Number.isNaN(number))) throw new Error(`${term} needs a number`);
  const test = { "<": (v) => v < number, ">": (v) => v > number, "<=": (v) => v <= number,
    ">=": (v) => v >= number, "=": (v) => String(v) === text || (typeof v === "number" && v === number) }[sign];
  return (row) => {
    const value = rows.get(field, row);
    return value === null ? sign === "=" && text === "null" : test(value);
  };
}

/** A word that is a field's whole value anywhere means that value, others stand somewhere in one. */
function word(rows, wanted) {
  const text = (field, row) => String(rows.get(field, row) ?? "").toLowerCase();
  const isValue = (row) => TEXTS.some((field) => text(field, row) === wanted);
  for (let row = 0; row < rows.rows.count; ++row) if (isValue(row)) return isValue;
  return (row) => TEXTS.some((field) => text(field, row).includes(wanted));
}

/** The command that makes a row again, into a new directory. */
function commandOf(rows, runs, row) {
  const run = runs[rows.get("run", row)];
  const word = (text) => (/^[\w./@%+=:,-]+$/.test(text) ? text : `'${text.replaceAll("'", "'\\''")}'`);
  const get = (name) => String(rows.get(name, row));
  return ["build/release/mda-bench run", word(run.sweep), "--scenarios", word(get("scenario")),
    "--scan-periods", get("scan_period_s"), "--windows", get("window_k"), "--replicates",
    get("replicate"), "--seed", String(run.seed), "--algorithms", word(get("algorithm")),
    ...(run.time_limit_s ? ["--time-limit", String(run.time_limit_s)] : [])].join(" ");
}

export class RawRows {
  constructor(host, rows, runs) {
    Object.assign(this, { rows, runs, page: 0, sort: null, down: false, chosen: [], found: [] });
    this.search = element("input", { type: "search", size: 34, "aria-label": "Search rows",
      placeholder: "words, or gap_nats>1 columns>=200" });
    this.search.addEventListener("input", () => this.refilter());
    this.count = element("span", { role: "status" });
    this.pager = element("span", { class: "tools" }, ...PAGER.map(([sign, by, label]) =>
      element("button", { type: "button", "aria-label": label, onclick: () => this.turn(by) }, sign)));
    this.columns = COLUMNS.filter((name) => rows.rows.has(name) || rows.windows.has(name));
    this.body = element("tbody");
    this.heads = this.columns.map((name) => element("th", { scope: "col" },
      element("button", { type: "button", onclick: () => this.sortBy(name) }, name)));
    host.append(element("div", { class: "card" },
      element("div", { class: "controls" }, this.search, this.count, this.pager,
        element("button", { type: "button", onclick: () => this.saveAll() }, "CSV of these rows")),
      element("div", { class: "scroll" }, element("table", { class: "raw" },
        element("thead", {}, element("tr", {}, ...this.heads)), this.body)),
      element("p", { class: "note" }, "A click on a row shows all its fields and the command that makes it again.")));
  }

  update(chosen) {
    this.chosen = chosen;
    this.refilter();
  }

  refilter() {
    this.fault = "";
    try {
      this.found = this.chosen.filter(searcher(this.rows, this.search.value));
    } catch (error) {
      this.found = [];
      this.fault = error.message;
    }
    this.page = 0;
    this.order();
  }

  sortBy(name) {
    this.down = this.sort === name ? !this.down : true;
    this.sort = name;
    this.heads.forEach((head, i) => (this.columns[i] === name
      ? head.setAttribute("aria-sort", this.down ? "descending" : "ascending")
      : head.removeAttribute("aria-sort")));
    this.order();
  }

  order() {
    if (this.sort) {
      const value = (row) => this.rows.get(this.sort, row);
      this.found.sort((a, b) => compare(value(a), value(b), this.down) || a - b);
    }
    this.draw();
  }

  turn(by) {
    const last = Math.max(0, Math.ceil(this.found.length / PAGE) - 1);
    this.page = Math.min(last, Math.max(0, this.page + by));
    this.draw();
  }

  draw() {
    const first = this.page * PAGE;
    const shownRows = this.found.slice(first, first + PAGE);
    this.count.textContent = this.found.length
      ? `rows ${first + 1}–${first + shownRows.length} of ${this.found.length.toLocaleString("en")}` : this.fault || "no rows";
    this.body.replaceChildren(...shownRows.map((row) => this.line(row)));
  }

  line(row) {
    const cells = this.columns.map((name) => {
      const value = this.rows.get(name, row);
      const isNumber = typeof value === "number";
      return element("td", { class: isNumber ? "number" : null, title: value === null ? null : String(value) },
        isNumber && !Number.isInteger(value) ? shown(value, name.endsWith("nats") ? 6 : 4)
          : value === null ? "—" : String(value));
    });
    const line = element("tr", { tabindex: 0 }, ...cells);
    const open = () => this.toggle(line, row);
    line.addEventListener("click", open);
    line.addEventListener("keydown", (event) => event.key === "Enter" && open());
    return line;
  }

  toggle(line, row) {
    if (line.classList.toggle("open")) {
      const fields = this.names().map((name) => `${name} ${this.rows.get(name, row) ?? "null"}`).join(" · ");
      line.after(element("tr", { class: "detail" }, element("td", { class: "detail", colspan: this.columns.length },
        element("p", {}, element("code", {}, commandOf(this.rows, this.runs, row))),
        element("p", { class: "note" }, `Its row is the one of replicate ${this.rows.get("replicate", row)}, ` +
          `scan ${this.rows.get("scan", row)}. ${fields}`))));
    } else {
      line.nextSibling.remove();
    }
  }

  names() {
    return [...new Set([...this.rows.windows.names, ...this.rows.rows.names])]
      .filter((name) => name !== "window");
  }

  saveAll() {
    const names = this.names();
    save("rows.csv", csv([names, ...this.found.map((row) => names.map((n) => this.rows.get(n, row)))]), "text/csv");
  }
}
