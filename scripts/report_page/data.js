// Reads the page's data: columns, compressed. Strings are numbers into a list of words.

/** The object that report.py packed: base64 of gzip of JSON. */
export async function unpack(text) {
  const bytes = Uint8Array.from(atob(text.trim()), (letter) => letter.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
  return JSON.parse(await new Response(stream).text());
}

/** A table of columns: `count` rows, `get(name, row)` and `column(name)`. */
export class Columns {
  constructor(packed) {
    this.count = packed.count;
    this.names = Object.keys(packed.columns);
    this.packed = packed.columns;
    for (const column of Object.values(this.packed)) {
      if (column.infinite) for (const row of column.infinite) column.values[row] = Infinity;
    }
    this.unpacked = new Map();
  }

  has(name) {
    return name in this.packed;
  }

  /** Values of a column, null where there is none. */
  column(name) {
    if (!this.unpacked.has(name)) {
      const { values, words } = this.packed[name];
      this.unpacked.set(name, words ? values.map((code) => words[code]) : values);
    }
    return this.unpacked.get(name);
  }

  get(name, row) {
    const { values, words } = this.packed[name];
    return words ? words[values[row]] : values[row];
  }
}

/** The distinct values of a column, numbers in their order, words in that of the alphabet. */
export function distinct(values) {
  const order = (a, b) => (typeof a === "number" ? a - b : a < b ? -1 : a > b ? 1 : 0);
  return [...new Set(values)].filter((value) => value !== null).sort(order);
}
