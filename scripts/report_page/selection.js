// The rows that the filter leaves.

/** Joins rows with their windows. */
export class Rows {
  constructor(windows, rows) {
    this.windows = windows;
    this.rows = rows;
    this.window = rows.column("window");
    this.algorithm = rows.column("algorithm");
  }

  /** A field of a row, of its own or of its window. */
  get(name, row) {
    return this.rows.has(name) ? this.rows.get(name, row)
      : this.windows.get(name, this.window[row]);
  }

  /** The numbers of the rows that `filter` leaves. */
  select(filter) {
    const keep = this.#windows(filter);
    const { algorithm } = filter.chosen;
    const chosen = [];
    for (let row = 0; row < this.rows.count; ++row) {
      if (keep[this.window[row]] && algorithm.has(this.algorithm[row])) chosen.push(row);
    }
    return chosen;
  }

  #windows(filter) {
    const [scenario, k, period, hardness] =
      ["scenario", "window_k", "scan_period_s", "hardness"].map((name) => this.windows.column(name));
    const { chosen } = filter;
    return Array.from({ length: this.windows.count }, (_, w) =>
      chosen.scenario.has(scenario[w]) && chosen.window_k.has(k[w]) &&
      chosen.scan_period_s.has(period[w]) &&
      chosen.hardness.has(hardness[w]));
  }

  /** Row numbers by algorithm, in the order of the alphabet. */
  byAlgorithm(chosen) {
    const found = new Map();
    for (const row of chosen) {
      const name = this.algorithm[row];
      if (!found.has(name)) found.set(name, []);
      found.get(name).push(row);
    }
    return new Map([...found].sort(([a], [b]) => (a < b ? -1 : 1)));
  }
}
