// What the reader has chosen: groups, K, scan periods, algorithms, hardness. Every chart, the
// ranking and the raw rows follow it.

import { element } from "./dom.js";
import { swatch } from "./look.js";

/** Kinds of choices: [key, heading, how a value is shown]. */
const KINDS = [
  ["scenario", "Group", (value) => value],
  ["window_k", "K", (value) => `K = ${value}`],
  ["scan_period_s", "Scan period", (value) => `${value} s`],
  ["algorithm", "Algorithm", (value) => value],
  ["hardness", "Hardness", (value) => HARDNESS[value] ?? value],
];
const HARDNESS = { easy: "easy: a bound closes the gap", hard: "hard: none does", open: "open: no bound or no answer",
  empty: "empty: no columns" };

export class Filter {
  /** `values`: by key the values there are. */
  constructor(values) {
    this.values = values;
    this.chosen = Object.fromEntries(KINDS.map(([key]) => [key, new Set(values[key])]));
    this.listeners = [];
  }

  onChange(listener) {
    this.listeners.push(listener);
  }

  tell() {
    this.listeners.forEach((listener) => listener());
  }

  isWhole() {
    return KINDS.every(([key]) => this.chosen[key].size === this.values[key].length);
  }

  /** Puts the controls into `form`; `told()`: a short line on what is selected. */
  show(form, told) {
    this.count = element("span", { class: "told", role: "status" });
    for (const kind of KINDS) {
      if (this.values[kind[0]].length > 1) form.append(this.#kind(...kind));
    }
    form.append(element("button", { type: "button", id: "reset", onclick: () => this.reset(form) },
      "Show all"), this.count);
    form.addEventListener("submit", (event) => event.preventDefault());
    document.addEventListener("click", (event) => closeOthers(form, event.target));
    document.addEventListener("keydown", (event) => {
      if (event.key === "Escape") closeOthers(form, null);
    });
    this.listeners.push(() => this.#tellCount(form, told));
    this.#tellCount(form, told);
    form.hidden = false;
  }

  reset(form) {
    for (const [key] of KINDS) this.chosen[key] = new Set(this.values[key]);
    form.querySelectorAll("input[type=checkbox]").forEach((box) => (box.checked = true));
    this.tell();
  }

  #tellCount(form, told) {
    this.count.textContent = told();
    form.querySelector("#reset").disabled = this.isWhole();
    for (const details of form.querySelectorAll("details[data-key]")) {
      const key = details.dataset.key;
      const all = this.values[key].length;
      const now = this.chosen[key].size;
      details.classList.toggle("set", now < all);
      details.querySelector("summary").textContent =
        `${details.dataset.heading}${now < all ? ` ${now}/${all}` : ""}`;
    }
  }

  #kind(key, heading, word) {
    const boxes = this.values[key].map((value) => {
      const box = element("input", { type: "checkbox", checked: true, value: String(value) });
      box.addEventListener("change", () => {
        this.chosen[key][box.checked ? "add" : "delete"](value);
        this.tell();
      });
      return [box, value];
    });
    const set = (on) => () => {
      for (const [box, value] of boxes) {
        box.checked = on;
        this.chosen[key][on ? "add" : "delete"](value);
      }
      this.tell();
    };
    return element("details", { "data-key": key, "data-heading": heading },
      element("summary", {}, heading),
      element("div", { class: "choices" },
        element("div", {}, element("button", { type: "button", onclick: set(true) }, "All"),
          element("button", { type: "button", onclick: set(false) }, "None")),
        ...boxes.map(([box, value]) => element("label", {}, box,
          key === "algorithm" ? swatch(value) : null, word(value)))));
  }
}

function closeOthers(form, target) {
  for (const open of form.querySelectorAll("details[open]")) {
    if (!open.contains(target)) open.open = false;
  }
}
