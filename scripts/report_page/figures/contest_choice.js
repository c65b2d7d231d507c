// Easy, hard or open windows: they are never averaged together, so a chart shows one kind.

import { choice, element } from "../dom.js";

const MEANING = { easy: "easy windows", hard: "hard windows", open: "open windows" };

export class ContestChoice {
  /** `show(contest or null, rows, state)` after every change; `more`: further controls. */
  constructor(show, more = []) {
    this.show = show;
    this.more = more;
    this.wanted = null;
    this.controls = element("div", { class: "controls" });
  }

  update(state) {
    this.state = state;
    const kinds = state.contests.map(({ contest }) => contest.hardness);
    const most = [...state.contests].sort((a, b) => b.contest.windows.length - a.contest.windows.length)[0];
    const now = kinds.includes(this.wanted) ? this.wanted : most?.contest.hardness;
    this.controls.replaceChildren(...(kinds.length > 1
      ? [choice("of", kinds.map((kind) => [kind, MEANING[kind]]), (kind) => {
        this.wanted = kind;
        this.again();
      }, now)] : []), ...this.more);
    this.now = now;
    this.#tell();
  }

  again() {
    if (this.wanted) this.now = this.wanted;
    this.#tell();
  }

  #tell() {
    const found = this.state.contests.find(({ contest }) => contest.hardness === this.now) ?? null;
    this.show(found?.contest ?? null, this.state.rows, found);
  }
}
