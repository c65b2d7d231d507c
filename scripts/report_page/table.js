// Tables that stand in the page already: sorting by a click on a heading, and CSV.

import { csv, element, save } from "./dom.js";
import { swatch } from "./look.js";

/** Makes the headings of a table sort it. Cells may carry data-value: what they are sorted by. */
export function makeSortable(table) {
  const heads = [...(table.tHead?.rows[table.tHead.rows.length - 1]?.cells ?? [])];
  heads.forEach((head, column) => {
    const button = element("button", { type: "button" }, ...head.childNodes);
    head.replaceChildren(button);
    button.addEventListener("click", () => {
      const down = head.getAttribute("aria-sort") !== "descending";
      heads.forEach((other) => other.removeAttribute("aria-sort"));
      head.setAttribute("aria-sort", down ? "descending" : "ascending");
      const body = table.tBodies[0];
      body.append(...[...body.rows].sort((a, b) =>
        compare(valueOf(a.cells[column]), valueOf(b.cells[column]), down)));
    });
  });
}

function valueOf(cell) {
  const text = cell?.dataset.value ?? cell?.textContent ?? "";
  if (text === "" || text === "—") return null;
  const number = Number(text);
  return Number.isNaN(number) ? text : number;
}

/** Order of two values, descending if `down`; what is not known comes last. */
export function compare(a, b, down) {
  if (a === null || b === null) return (a === null) - (b === null);
  const order = typeof a === "number" && typeof b === "number" ? a - b
    : String(a).localeCompare(String(b), "en", { numeric: true });
  return down ? -order : order;
}

/** A button that saves the table as it stands. */
export function csvButton(table, name) {
  const lines = () => [...table.rows]
    .filter((row) => !row.classList.contains("blocks"))
    .map((row) => [...row.cells].map((cell) => cell.dataset.value ?? cell.textContent.trim()));
  return element("button", { type: "button", onclick: () =>
    save(`${name}.csv`, csv(lines()), "text/csv") }, "CSV");
}

/** Every table of the page; names of algorithms that have a style get its picture. */
export function enhanceTables(styles) {
  for (const cell of document.querySelectorAll("td[data-algorithm]")) {
    cell.dataset.value = cell.dataset.algorithm;
    if (cell.dataset.algorithm in styles) cell.prepend(swatch(cell.dataset.algorithm), " ");
  }
  for (const card of document.querySelectorAll("[data-table]")) {
    const table = card.querySelector("table");
    if (!table) continue;
    makeSortable(table);
    card.querySelector(".tools")?.append(csvButton(table, card.dataset.table));
  }
}
