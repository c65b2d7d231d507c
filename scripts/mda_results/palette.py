"""How an algorithm looks in every figure: colour, marker and dash, safe for the colour blind.

Colours are from Okabe and Ito's and Tol's muted scheme; a hue belongs to a family, whose members
differ in lightness, marker or filling, and dash, so that no pair rests on colour alone."""

from dataclasses import dataclass, replace
from typing import Any


@dataclass(frozen=True)
class Style:
    color: str
    marker: str = "o"
    dash: str = "-"
    hollow: bool = False

    def line(self) -> dict[str, Any]:
        """Keyword arguments of a line with markers."""
        return {**self.point(), "linestyle": self.dash, "markersize": 5, "linewidth": 1.6}

    def point(self) -> dict[str, Any]:
        """Keyword arguments of a marker."""
        return {"color": self.color, "marker": self.marker,
                "markerfacecolor": "white" if self.hollow else self.color}


_BLACK, _BLUE, _SKY, _GREEN = "#000000", "#0072B2", "#56B4E9", "#117733"
_VERMILION, _ORANGE, _PINK, _GREY = "#D55E00", "#E69F00", "#CC79A7", "#777777"
_INDIGO, _WINE, _OLIVE, _TEAL, _SAND = "#332288", "#882255", "#999933", "#44AA99", "#B59B47"
_PURPLE = "#AA4499"
_BY_SCAN = "-by-scan"

REFERENCES = {"ideal": Style("#000000", "", ":"), "oracle": Style("#777777", "", "--")}

_STYLES = {
    "sd-exact": Style(_BLACK, "o"), "exact": Style(_BLACK, "s", "--"),
    "cbc": Style(_BLACK, "D", ":"), "brute-force": Style(_BLACK, "x", "-."),
    "lp": Style(_OLIVE, "o", "--"), "lp-grp": Style(_OLIVE, "s"),
    "pdhg": Style(_OLIVE, "^", "-.", True),
    "tree-exact": Style(_PINK, "o"), "cg-lp": Style(_PINK, "D", "--"),
    "dual-ascent": Style(_PINK, "^", "-."),
    "scf": Style(_SKY, "s", "--"), "scf-tie": Style(_BLUE, "o"), "scf-lp": Style(_SKY, "D", ":"),
    "scf-networksimplex": Style(_SKY, "v", "-."), "scf-capacityscaling": Style(_SKY, "^", "-."),
    "scf-costscaling": Style(_SKY, "<", "-."), "scf-assignment": Style(_SKY, ">", "-."),
    "mcf": Style(_VERMILION, "^"), "mcf-lp": Style(_VERMILION, "v", "--"),
    "lagrangian-sd": Style(_INDIGO, "P"), "viterbi-sequential": Style(_PINK, "v"),
    "gnn": Style(_GREEN, "s"), "nn": Style(_TEAL, "X", ":"),
    "greedy": Style(_ORANGE, "X"), "mht": Style(_WINE, "p"), "mht-ahead": Style(_WINE, "d", "--"),
    "murty-k": Style(_PURPLE, "h", "-.", True), "scf-pairs": Style(_SAND, "d"),
    "mapada": Style(_BLUE, "s", "-", True), "mapada-literal": Style(_SKY, "p", ":", True),
    "mapada-weighted": Style(_BLUE, "D", "--", True), "mapada-miss": Style(_SKY, "*", "-."),
    "mapada-window": Style(_BLUE, "P", ":"),
    "hnpda": Style(_VERMILION, "D", "-", True), "hnpda-raw": Style(_ORANGE, "^", "--", True),
    "jpda": Style(_WINE, "o"), "jpda-enumerate": Style(_WINE, "x", ":"),
    "jpda-cheap": Style(_PURPLE, "D", "--"), "lbp": Style(_INDIGO, "*", "-."),
    "pda": Style(_PINK, "s", ":", True),
    "bojilov": Style(_TEAL, "o"), "bojilov-calibrated": Style(_TEAL, "s", "--"),
    "bojilov-worst-ties": Style(_TEAL, "v", "-."), "bojilov-untreated": Style(_TEAL, "x", ":"),
    "bojilov-a3": Style(_TEAL, "d", ":"), "bojilov-loss-0.0001": Style(_TEAL, "^", ":", True),
    "bojilov-loss-0.001": Style(_TEAL, "<", ":", True),
    "bojilov-loss-0.005": Style(_TEAL, "D", ":", True),
    "bojilov-loss-0.025": Style(_TEAL, "p", ":", True),
    "bojilov-loss-0.05": Style(_TEAL, "h", ":", True),
    "bojilov-loss-0.1": Style(_TEAL, "P", ":", True),
    "bojilov-loss-0.2": Style(_TEAL, ">", ":", True),
    "lpsolve-bb": Style(_GREY, "s", "--"), "lpsolve-lp-grp": Style(_GREY, "D", ":"),
    "glpk-bb": Style(_GREY, "v", "--"), "cbc-main": Style(_GREY, "X", "--"),
}


def style_of(algorithm: str) -> Style:
    """The look of an algorithm; grey for one without a colour. One that goes scan by scan has that
    of its single-scan method, but hollow, and chain-dotted or, where that is so itself, dashed."""
    style = _STYLES.get(algorithm.removesuffix(_BY_SCAN), Style(_GREY, "."))
    if not algorithm.endswith(_BY_SCAN):
        return style
    return replace(style, hollow=True, dash="-." if style.dash != "-." else "--")


# The same hues where the ground is dark and the darker ones would drown.
_ON_DARK = {_BLACK: "#F4F4F4", _BLUE: "#4C9BE8", _SKY: "#8FD3FF", _GREEN: "#4CC36B",
            _VERMILION: "#FF7A33", _ORANGE: "#F0B429", _PINK: "#E39CC5", _GREY: "#9AA0A6",
            _INDIGO: "#9A8CFF", _WINE: "#D9609F", _OLIVE: "#C9C94A", _TEAL: "#6FD3C4",
            _SAND: "#D8C07A", _PURPLE: "#CF86E0"}


def on_dark(color: str) -> str:
    """What a colour of the palette becomes on a dark ground; others stay."""
    return _ON_DARK.get(color, color)


# Of resolutions in figure 9: dark is coarse.
FACTOR_COLORS = ("#E69F00", "#56B4E9", "#0072B2", "#000000")
FACTOR_MARKERS = ("o", "s", "^", "D")
