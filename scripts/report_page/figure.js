// A chart in a card, with what a reader can take away of it: SVG, PNG, CSV.

import { init, use } from "echarts/core";
import { BarChart, CustomChart, HeatmapChart, LineChart, ScatterChart } from "echarts/charts";
import {
  DataZoomInsideComponent, GridComponent, LegendComponent, MarkLineComponent, TitleComponent,
  TooltipComponent, VisualMapComponent,
} from "echarts/components";
import { CanvasRenderer, SVGRenderer } from "echarts/renderers";

import { csv, element, save } from "./dom.js";
import { cssColor, onTheme } from "./theme.js";

use([BarChart, CustomChart, HeatmapChart, LineChart, ScatterChart, DataZoomInsideComponent,
  GridComponent, LegendComponent, MarkLineComponent, TitleComponent, TooltipComponent,
  VisualMapComponent, CanvasRenderer, SVGRenderer]);

const FONT = "system-ui, 'Segoe UI', Roboto, 'Helvetica Neue', Arial, sans-serif";
const charts = [];

const watcher = new IntersectionObserver((entries) => {
  for (const { target, isIntersecting } of entries) {
    const chart = charts.find((own) => own.plot === target);
    chart.seen = isIntersecting;
    if (isIntersecting) chart.draw();
  }
}, { rootMargin: "300px" });

onTheme(() => charts.forEach((chart) => chart.refresh()));
window.addEventListener("resize", () => charts.forEach((chart) => chart.refresh()));

/** Ink and ground of the present theme. */
export function colors() {
  return { ink: cssColor("ink"), muted: cssColor("muted"), line: cssColor("line"),
    card: cssColor("card"), warn: cssColor("warn"), accent: cssColor("accent") };
}

/** An axis in the page's manner; `more` as in ECharts. */
export function axis(name, more = {}) {
  const { ink, muted, line } = colors();
  return {
    name, nameLocation: "middle", nameGap: 28, nameTextStyle: { color: ink, fontSize: 12 },
    axisLabel: { color: muted, fontSize: 11, hideOverlap: true },
    axisLine: { lineStyle: { color: muted } }, splitLine: { lineStyle: { color: line } }, ...more,
  };
}

/**
 * A card with a chart. `name`: of its files; `draw(width)`: the options of ECharts, drawn anew when
 * the theme, the size or the data change; `lines()`: the rows of the CSV file, headings first;
 * `height(width)`: pixels.
 */
export class Figure {
  constructor({ name, title, draw, lines, height = () => 340, controls = null, note = "" }) {
    Object.assign(this, { name, options: draw, lines, height, seen: false });
    this.plot = element("div", { class: "plot", role: "img", "data-stale": "yes", "aria-label": title });
    this.title = element("h3", {}, title);
    this.below = element("div");
    const tool = (label, act) => element("button", { type: "button", onclick: act,
      "aria-label": `${label} of ${title}` }, label);
    this.card = element("figure", { class: "card", id: `figure-${name}` },
      element("header", {}, this.title, element("div", { class: "tools" },
        tool("SVG", () => this.saveSvg()), tool("PNG", () => this.savePng()),
        tool("CSV", () => save(`${name}.csv`, csv(this.lines()), "text/csv")))),
      controls, this.plot, this.below, note ? element("p", { class: "note" }, note) : null);
    charts.push(this);
    watcher.observe(this.plot);
    this.plot.style.height = `${height(600)}px`;
  }

  /** Draws anew, now or when the reader comes by. */
  refresh() {
    this.plot.dataset.stale = "yes";
    if (this.seen) this.draw();
  }

  draw() {
    if (!this.plot.dataset.stale) return;
    delete this.plot.dataset.stale;
    const width = this.plot.clientWidth;
    this.plot.style.height = `${this.height(width)}px`;
    this.chart ??= init(this.plot, null, { renderer: "canvas" });
    this.chart.resize();
    this.chart.setOption(this.complete(width), { notMerge: true });
  }

  complete(width) {
    const { ink, card, line } = colors();
    const given = this.options(width);
    return {
      animation: false, textStyle: { fontFamily: FONT, color: ink }, backgroundColor: "transparent",
      ...given,
      tooltip: { backgroundColor: card, borderColor: line, textStyle: { color: ink, fontSize: 12 },
        confine: true, ...given.tooltip },
    };
  }

  saveSvg() {
    const width = Math.max(this.plot.clientWidth, 480);
    const picture = init(null, null, { renderer: "svg", ssr: true, width, height: this.height(width) });
    picture.setOption({ ...this.complete(width), backgroundColor: colors().card });
    save(`${this.name}.svg`, picture.renderToSVGString(), "image/svg+xml");
    picture.dispose();
  }

  savePng() {
    this.draw();
    const data = this.chart.getDataURL({ type: "png", pixelRatio: 2, backgroundColor: colors().card });
    const bytes = Uint8Array.from(atob(data.split(",")[1]), (letter) => letter.charCodeAt(0));
    save(`${this.name}.png`, new Blob([bytes], { type: "image/png" }));
  }
}
