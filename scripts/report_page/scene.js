// The scenario viewer: a slider over the scans of a recorded scene.

import { Figure } from "./figure.js";
import { choice, element } from "./dom.js";
import { picture, verdictOf } from "./scene_picture.js";

const TRAILS = [["window", "the window"], ["10", "the last 10 scans"], ["all", "all scans so far"]];
const PLAY_MS = 450;

const counted = (count, word) => `${count} ${word}${count === 1 ? "" : "s"}`;
const hasPlots = (scene) => scene.plots.some((scan) => scan.length);

export class SceneViewer {
  constructor(host, scenes) {
    Object.assign(this, { scenes, scene: scenes[0], trail: "all", timer: null });
    this.controls = element("div", { class: "controls" });
    this.slider = element("input", { type: "range", min: 1, step: 1, "aria-label": "Scan" });
    this.slider.addEventListener("input", () => this.show());
    this.told = element("output", {});
    this.play = element("button", { type: "button", "aria-label": "Play the scans",
      onclick: () => (this.timer ? this.stop() : this.start()) }, "▶");
    const step = (sign, by) => element("button", { type: "button",
      "aria-label": by < 0 ? "one scan back" : "one scan on", onclick: () => this.step(by) }, sign);
    this.verdict = element("p", { class: "note", role: "status" });
    this.figure = new Figure({
      name: "scene", title: "Scenario", height: (width) => Math.min(Math.round(width * 0.95), 560),
      controls: element("div", {}, this.controls, element("div", { class: "controls" }, this.play, step("‹", -1),
        this.slider, step("›", 1), this.told)),
      draw: (width) => picture(this.scene, this.view(), width, this.figure.height(width)),
      lines: () => this.lines(),
      note: "● plot of a target · × false alarm · ○ grey: true position, with its path · lines: tracks " +
        "of the answer; ringed: plots that they take from another source than most of their plots, and plots of " +
        "targets that no track takes. Shift and wheel zoom, dragging moves.",
    });
    this.figure.plot.before(this.verdict);
    host.append(this.figure.card);
    this.choose(scenes[0]);
  }

  choose(scene) {
    this.stop();
    this.scene = scene;
    const ks = [...new Set(scene.answers.map((answer) => answer.window_k))].sort((a, b) => a - b);
    if (!ks.includes(this.k)) this.k = ks[0];
    const at = Number(this.slider.value);
    this.slider.max = scene.plots.length;
    this.slider.value = this.shown ? Math.min(at, scene.plots.length) : Math.ceil(0.6 * scene.plots.length);
    this.shown = true;
    this.chooseK(this.k);
  }

  chooseK(k) {
    this.k = k;
    const own = this.scene.answers.filter((answer) => answer.window_k === k);
    if (!own.includes(this.answer)) {
      const same = own.find((answer) =>
        answer.algorithm === this.answer?.algorithm && answer.loop === this.answer?.loop);
      this.answer = same ?? own[0] ?? null;
    }
    this.#fill(own);
    this.show();
  }

  #fill(own) {
    const { scenes, scene } = this;
    const ks = [...new Set(scene.answers.map((answer) => answer.window_k))].sort((a, b) => a - b);
    const several = new Set(scenes.map((s) => s.run)).size > 1;
    const name = (s) => `${s.scenario}, ${s.scan_period_s} s, replicate ${s.replicate}${several ? ` of ${s.run}` : ""}`;
    const word = (a) => `${a.algorithm}${a.loop === "closed" ? " (closed loop)" : ""}`;
    this.controls.replaceChildren(
      choice("scene", scenes.map((s, i) => [String(i), name(s)]), (i) => this.choose(scenes[Number(i)]),
        String(scenes.indexOf(scene))),
      ...(ks.length ? [
        choice("K", ks.map((k) => [String(k), String(k)]), (k) => this.chooseK(Number(k)), String(this.k)),
        choice("answer", [["", "truth only"], ...own.map((a, i) => [String(i), word(a)])], (i) => {
          this.answer = i === "" ? null : own[Number(i)];
          this.show();
        }, String(own.indexOf(this.answer)))] : []),
      ...(hasPlots(scene) ? [choice("plots of", TRAILS, (trail) => {
        this.trail = trail;
        this.show();
      }, this.trail)] : []));
  }

  /** What is shown at the slider's scan. */
  view() {
    const scan = Number(this.slider.value);
    const depth = { window: this.k ?? 1, 10: 10, all: scan }[this.trail];
    const at = this.answer?.scans.filter((entry) => this.answer.loop === "closed" || entry.scan === scan) ?? [];
    const tracks = at.length ? at[0].tracks : null;
    const window = Math.max(1, scan - (this.k ?? 1) + 1);
    return { scan, from: Math.max(1, scan - depth + 1), tracks, algorithm: this.answer?.algorithm,
      judgedFrom: this.answer?.loop === "closed" ? 1 : window };
  }

  show() {
    const view = this.view();
    this.told.textContent = `scan ${view.scan} of ${this.scene.plots.length}, ` +
      `${(view.scan * this.scene.scan_period_s).toFixed(0)} s`;
    this.figure.title.textContent = `Scenario ${this.scene.scenario}, replicate ${this.scene.replicate}, ` +
      `scan ${view.scan}${this.answer ? `: ${this.answer.algorithm}, K = ${this.k}` : ""}`;
    this.verdict.textContent = this.#verdict(view);
    this.figure.refresh();
  }

  #verdict(view) {
    if (!hasPlots(this.scene)) return "This run records true paths but no plots.";
    if (!this.answer) return "No answer chosen: plots and truth only.";
    if (!view.tracks) return `No answer of ${this.answer.algorithm} at this scan.`;
    const { judged, right, wrong, missed } = verdictOf(this.scene, view.tracks, view.judgedFrom, view.scan);
    const scope = view.judgedFrom === 1 ? "so far" : "in the window";
    return `${counted(judged.length, "track")} ${scope}: ${counted(right, "plot")} taken rightly, ` +
      `${wrong.length} from another source, ${counted(missed.length, "plot")} of targets taken by none.`;
  }

  step(by) {
    this.stop();
    this.slider.value = Number(this.slider.value) + by;
    this.show();
  }

  start() {
    this.play.textContent = "❚❚";
    if (Number(this.slider.value) >= this.scene.plots.length) this.slider.value = 1;
    this.timer = setInterval(() => {
      if (Number(this.slider.value) >= this.scene.plots.length) return this.stop();
      this.slider.value = Number(this.slider.value) + 1;
      this.show();
    }, PLAY_MS);
  }

  stop() {
    clearInterval(this.timer);
    this.timer = null;
    this.play.textContent = "▶";
  }

  lines() {
    const view = this.view();
    const taken = new Map();
    (view.tracks ?? []).forEach(([first, ...plots], track) =>
      plots.forEach((plot, i) => plot >= 0 && taken.set(`${first + i} ${plot}`, track)));
    const lines = [["scan", "plot", "x_km", "y_km", "source", "track"]];
    this.scene.plots.slice(0, view.scan).forEach((plots, i) => plots.forEach(([x, y, source], plot) =>
      lines.push([i + 1, plot, x, y, source, taken.get(`${i + 1} ${plot}`) ?? null])));
    return lines;
  }
}
