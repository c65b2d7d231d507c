"""The windows of one hardness on which every algorithm of one kind was asked, as matrices."""

from dataclasses import dataclass, replace

import numpy as np
import pandas as pd

from mda_results import bootstrap, facts

_MATRICES = ("fate", "time_ms", "spent_ms", "disturbed", "gap", "certified_gap")
_FEWEST = 0.5  # of the windows: an algorithm that took on fewer is named, not ranked


@dataclass(frozen=True)
class Contest:
    """Matrices are (windows, algorithms); windows are in the order of pool.KEY."""

    hardness: str
    algorithms: list[str]
    refuted: np.ndarray  # per algorithm, its refuted rows in the selection, of any hardness
    windows: pd.DataFrame  # scenario, replicate, ..., bound, best, idle: one line each
    fate: np.ndarray  # numbers of facts.FATES
    time_ms: np.ndarray  # CPU time; the penalty where there is no result in time (PAR-2)
    spent_ms: np.ndarray  # CPU time of an answer that stands, late ones too; else infinite
    disturbed: np.ndarray  # wall clock over 1.2 times CPU time: something else was running
    gap: np.ndarray  # nats above the best known cost; doing nothing where there is no answer
    certified_gap: np.ndarray  # the same above the best certified bound; NaN without one
    unit: np.ndarray  # number of each window's scene
    unit_groups: np.ndarray  # the scenario of every scene

    @property
    def in_time(self) -> np.ndarray:
        return self.fate <= facts.FEASIBLE

    @property
    def answered(self) -> np.ndarray:
        return np.isfinite(self.spent_ms)

    @property
    def reached(self) -> np.ndarray:
        """In time, and at the best known cost."""
        return self.in_time & (self.gap <= 0)

    def weights(self) -> np.ndarray | None:
        """How often every scene is in every resample."""
        return bootstrap.weights(self.unit_groups)

    def by_scene(self, values: np.ndarray) -> np.ndarray:
        """Sums over the windows of every scene, (scenes, algorithms)."""
        sums = np.zeros((len(self.unit_groups), values.shape[1]))
        np.add.at(sums, self.unit, values)
        return sums

    def of(self, names: list[str]) -> "Contest":
        """These algorithms, in this order, on the same windows."""
        chosen = [self.algorithms.index(name) for name in names]
        parts = {name: getattr(self, name)[:, chosen] for name in _MATRICES}
        return replace(self, algorithms=names, refuted=self.refuted[chosen], **parts)

    def among(self, chosen: np.ndarray) -> "Contest":
        """Only the windows where `chosen` is true."""
        parts = {name: getattr(self, name)[chosen] for name in _MATRICES}
        scenes, unit = np.unique(self.unit[chosen], return_inverse=True)
        return replace(self, windows=self.windows[chosen].reset_index(drop=True), unit=unit,
                       unit_groups=self.unit_groups[scenes], **parts)


def contests(rows: pd.DataFrame, told: list[str], answer: str = "selection") -> list[Contest]:
    """One per hardness, of rows as facts.judged() gives them, selected as wanted; those without
    windows or algorithms are left out. Algorithms are in alphabetical order. Who is not ranked, and
    which windows are left out, is added to `told`."""
    own = rows[rows["answer"] == answer]
    refuted = (own["fate"] == facts.REFUTED).groupby(own["algorithm"]).sum()
    parts = [(h, own[own["hardness"] == h]) for h in facts.HARDNESSES]
    found = [_contest(part, h, refuted, told) for h, part in parts if len(part)]
    return [c for c in found if c is not None]


def _contest(rows: pd.DataFrame, hardness: str, refuted: pd.Series,
             told: list[str]) -> Contest | None:
    windows = rows.drop_duplicates("window").sort_values("window").set_index("window")
    asked = rows.groupby("algorithm").size()
    tried = rows[rows["fate"] != facts.DECLINED].groupby("algorithm").size()
    tried = tried.reindex(asked.index, fill_value=0)
    algorithms = sorted(tried.index[tried >= _FEWEST * len(windows)])
    left_out = tried.drop(algorithms)
    told += [f"{hardness}: not ranked, as asked on {a} of {len(windows)} windows and declining "
             f"{a - n}: {', '.join(own.index)}."
             for (a, n), own in left_out.groupby([asked[left_out.index], left_out])]
    rows = rows[rows["algorithm"].isin(algorithms)]
    counts = rows.groupby("window").size()
    shared = counts.index[counts == len(algorithms)]
    if algorithms and len(shared) < len(windows):
        told.append(f"{hardness}: {len(windows) - len(shared)} of {len(windows)} windows are left "
                    "out, as not every algorithm of the ranking was asked on them.")
    if not algorithms or len(shared) == 0:
        return None
    rows = rows[rows["window"].isin(shared)].sort_values(["window", "algorithm"])
    facts_of = windows.loc[shared].reset_index()
    keys = pd.MultiIndex.from_arrays([facts_of["scenario"], facts_of["seed"],
                                      facts_of["replicate"]])
    unit, units = pd.factorize(keys, sort=True)
    shape = (len(shared), len(algorithms))
    return Contest(
        hardness, algorithms, refuted.reindex(algorithms, fill_value=0).to_numpy(), facts_of,
        rows["fate"].to_numpy().reshape(shape), **measured(rows, shape), unit=unit,
        unit_groups=units.get_level_values(0).to_numpy().astype(str))


def measured(rows: pd.DataFrame, shape: tuple[int, int]) -> dict[str, np.ndarray]:
    """The matrices of Contest that are measured, in another shape. Differences within the
    referee's tolerance count as none, so that ties are ties."""
    fate, cost = rows["fate"].to_numpy(), rows["cost_nats"].to_numpy()
    stands = facts.answered(fate, cost)
    best, bound = rows["best"].to_numpy(), rows["bound"].to_numpy()
    within = facts.tolerance(rows["best"]).to_numpy()
    cost = np.where(stands, cost, rows["idle"].to_numpy())
    cost = np.where(np.abs(cost - best) <= within, best, cost)
    certified = cost - bound
    certified = np.where(np.abs(certified) <= within, 0.0, certified)
    time = rows["time_ms"].to_numpy()
    in_time = (fate <= facts.FEASIBLE) & ~np.isnan(time)
    parts = {"time_ms": np.where(in_time, time, rows["penalty_ms"].to_numpy()),
             "spent_ms": np.where(stands & ~np.isnan(time), time, np.inf),
             "disturbed": (rows["wall_ms"] > 1.2 * rows["cpu_ms"]).to_numpy(),
             "gap": np.where(np.isinf(cost), np.inf, cost - best), "certified_gap": certified}
    return {name: values.reshape(shape) for name, values in parts.items()}


def compared(contest: Contest) -> str:
    """What is compared, in one sentence."""
    scenarios = sorted(set(contest.windows["scenario"]))
    return (f"{contest.hardness}: n = {len(contest.windows)} windows of "
            f"{len(contest.unit_groups)} scenes ({', '.join(scenarios)}), the same for all "
            f"{len(contest.algorithms)} algorithms.")
