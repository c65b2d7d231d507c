"""What the page's script computes with: rows and windows as compressed columns."""

import base64
import gzip
import json
import math
from typing import Any

import numpy as np
import pandas as pd

from mda_results import facts
from mda_results.contest import measured
from mda_results.palette import on_dark, style_of

_DIGITS = {"nats": 12, "ms": 6}  # significant ones that are kept, by the unit in a name
_BOOLEANS = ("integral",)
WINDOW_FIELDS = ("scenario scan_period_s seed replicate window_k scan fingerprint rows columns "
                 "components largest_component_columns reference_cost_nats truth_cost_nats "
                 "best_nats bound_nats hardness targets").split()
ROW_FIELDS = ("run algorithm answer status stop note fate why cost_nats gap_nats "
              "gap_to_best_nats certified_gap_nats certified_bound_nats integral fractional "
              "paper_fractional in_time charged_ms spent_ms cpu_ms wall_ms views_ms lp_ms "
              "round_ms").split()


def columns_of(rows: pd.DataFrame) -> dict[str, Any]:
    """Tables `rows` and `windows` of facts.judged(); `window` is a row's place in the latter."""
    found = {name: values[:, 0] for name, values in measured(rows, (len(rows), 1)).items()}
    spent = np.where(np.isfinite(found["spent_ms"]), found["spent_ms"], np.nan)
    named = rows.assign(
        fate=np.array(facts.FATES)[rows["fate"]], best_nats=rows["best"], bound_nats=rows["bound"],
        gap_to_best_nats=found["gap"], certified_gap_nats=found["certified_gap"],
        charged_ms=found["time_ms"], spent_ms=spent,
        in_time=(rows["fate"] <= facts.FEASIBLE) & rows["time_ms"].notna())
    windows = named.drop_duplicates("window").sort_values("window")
    return {"rows": _table(named[["window", *ROW_FIELDS]]),
            "windows": _table(windows[WINDOW_FIELDS])}


def styles_of(algorithms: list[str]) -> dict[str, dict[str, str]]:
    """How the algorithms look, by name."""
    looks = {name: style_of(name) for name in algorithms}
    return {name: {"color": look.color, "dark": on_dark(look.color), "marker": look.marker,
                   "dash": look.dash} for name, look in looks.items()}


def packed(page: dict[str, Any]) -> str:
    """Base64 of gzip of JSON; the same for the same page."""
    text = json.dumps(page, separators=(",", ":"), allow_nan=False,
                      ensure_ascii=False)
    return base64.b64encode(gzip.compress(text.encode(), compresslevel=9, mtime=0)).decode()


def _table(frame: pd.DataFrame) -> dict[str, Any]:
    return {"count": len(frame), "columns": {name: _column(frame[name]) for name in frame.columns}}


def _column(values: pd.Series) -> dict[str, Any]:
    """Numbers as they are, with null for what is missing, and where they are infinite; words as
    numbers into their list."""
    if values.dtype == bool:
        return {"values": values.tolist()}
    if not pd.api.types.is_numeric_dtype(values):
        codes, words = pd.factorize(values.astype(str), sort=True)
        return {"values": codes.tolist(), "words": list(words)}
    numbers = values.to_numpy()
    if values.name in _BOOLEANS:
        return {"values": [None if math.isnan(x) else bool(x) for x in numbers.tolist()]}
    if numbers.dtype.kind == "i":
        return {"values": numbers.tolist()}
    digits = _DIGITS.get(str(values.name).rsplit("_", 1)[-1], 17)
    packed_values = {"values": [_short(x, digits) for x in numbers.astype(float).tolist()]}
    infinite = np.flatnonzero(np.isposinf(numbers.astype(float))).tolist()
    return {**packed_values, "infinite": infinite} if infinite else packed_values


def _short(value: float, digits: int) -> float | int | None:
    if not math.isfinite(value):
        return None
    if value == int(value) and abs(value) < 1e15:
        return int(value)
    return float(f"{value:.{digits}g}")
