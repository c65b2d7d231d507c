"""The claims of Lee & Jeong (1998), each judged by a rule that is printed."""

from collections.abc import Iterator

import pandas as pd

from mda_results import lee_judges
from mda_results.lee_judges import Part
from mda_results.position_targets import EITHER, LAWS, finished, tracks_of
from mda_results.render import Cell, Column, Table
from mda_results.verdicts import Claim

_Judged = tuple[str, str, Claim]  # clutter and update of the part; what comes of it


def tables(outings: pd.DataFrame) -> list[Table]:
    """The claims with their rules, and what comes of each per clutter law and update. Of outings
    without echoes."""
    parts = list(_parts(finished(outings)))
    rules: list[list[Cell]] = []
    verdicts: list[list[Cell]] = []
    for number, judge in enumerate(lee_judges.JUDGES, start=1):
        across = judge in lee_judges.ACROSS_LAWS
        claims = _judged(judge, [p for p in parts if (p.law == lee_judges.BOTH) == across],
                         Part("", "", outings.iloc[:0], tracks_of(outings.iloc[:0])))
        rules.append([str(number), claims[0][2].said, claims[0][2].rule])
        verdicts += [[str(number), law, update, c.ours, c.verdict] for law, update, c in claims]
    for n, claim in enumerate(lee_judges.NOT_FROM_RUNS, start=len(rules) + 1):
        rules.append([str(n), claim.said, claim.rule])
        verdicts.append([str(n), "", "", claim.ours, claim.verdict])
    notes = ["Brackets: 95 % bootstrap interval over runs; algorithms are compared on the same "
             "runs. A rule met in some places only: holds partly. Kept: within 0.45 km in the last "
             "5 scans, if not said otherwise. Many comparisons are made: one in forty intervals "
             "lies above 0 by chance."]
    return [Table("claims_rules", "Claims of the paper, and when they count as true",
                  [Column("no."), Column("the paper"), Column("rule")], rules),
            Table("claims", "Verdicts",
                  [Column("no.", once=True), Column("clutter"), Column("update"), Column("ours"),
                   Column("verdict")], verdicts, notes)]


def _parts(outings: pd.DataFrame) -> Iterator[Part]:
    """Per update the outings under each clutter law, and then under both together."""
    updates = sorted(set(outings["update"]) - {EITHER}) or sorted(set(outings["update"]))
    for update in updates:
        own = outings[outings["update"].isin([update, EITHER])]
        present = [law for law in LAWS if (own["law"] == law).any()]
        for law in present:
            under = own[own["law"] == law]
            yield Part(law, update, under, tracks_of(under))
        if len(present) > 1:
            yield Part(lee_judges.BOTH, update, own, tracks_of(own))


def _judged(judge: lee_judges.Judge, parts: list[Part], empty: Part) -> list[_Judged]:
    """What a judge says of every part that it has data of; without any, that there is none;
    what is the same under every update once."""
    found: dict[tuple[str, Claim], list[str]] = {}
    for part in parts:
        for claim in judge(part):
            if claim.ours != lee_judges.NO_DATA:
                found.setdefault((part.law, claim), []).append(part.update)
    known = [(law, updates[0] if len(updates) == 1 else EITHER, claim)
             for (law, claim), updates in found.items()]
    order = [*LAWS, lee_judges.BOTH]
    known.sort(key=lambda line: order.index(line[0]))
    return known or [("", "", next(judge(empty)))]
