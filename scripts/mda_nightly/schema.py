"""What the fields of a file must be, as tables; one sentence about what is not."""

import json
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from datetime import datetime
from typing import Any

from mda_results.rows import RunError

_MOST = 2.0**53  # of whole numbers: beyond it, not every one is a float
_LARGEST = 1e300
_SHOWN = 40  # characters of a value in a sentence


@dataclass(frozen=True)
class Kind:
    """A predicate on what JSON or SQL gave, and what it asks for in words."""

    words: str
    holds: Callable[[Any], bool]
    needed: bool = True


Fields = Mapping[str, Kind]


def may_be_absent(kind: Kind) -> Kind:
    return replace(kind, needed=False)


def or_null(kind: Kind) -> Kind:
    return Kind(f"{kind.words} or null", lambda value: value is None or kind.holds(value))


def one_of(*allowed: Any) -> Kind:
    """Equal in type, too: neither True nor 1.0 is 1."""
    return Kind(" or ".join(map(json.dumps, allowed)),
                lambda value: any(type(value) is type(a) and value == a for a in allowed))


def list_of(kind: Kind) -> Kind:
    return Kind(f"a list, each {kind.words}",
                lambda value: isinstance(value, list) and all(map(kind.holds, value)))


def object_of(kind: Kind) -> Kind:
    return Kind(f"an object, each value {kind.words}",
                lambda value: isinstance(value, dict) and all(map(kind.holds, value.values())))


def _is_number(value: Any) -> bool:
    # bool is a kind of int, NaN is in no order, and 10**400 is no float.
    return type(value) in (int, float) and -_LARGEST <= value <= _LARGEST


def _is_time(value: Any) -> bool:
    try:
        return datetime.fromisoformat(value.replace("Z", "+00:00")).tzinfo is not None
    except (AttributeError, TypeError, ValueError):
        return False


TEXT = Kind("a text", lambda value: isinstance(value, str))
NAME = Kind("a name", lambda value: isinstance(value, str) and value.strip() != "")
TIME = Kind("a time such as 2026-01-01T02:00:00Z", _is_time)
NUMBER = Kind("a number", _is_number)
NOT_NEGATIVE = Kind("a number of 0 or more", lambda value: _is_number(value) and value >= 0)
POSITIVE = Kind("a positive number", lambda value: _is_number(value) and value > 0)
WHOLE = Kind("a whole number of 0 or more",
             lambda value: type(value) is int and 0 <= value <= _MOST)
COUNT = Kind("a whole number of 1 or more",
             lambda value: type(value) is int and 1 <= value <= _MOST)
OBJECT = Kind("an object", lambda value: isinstance(value, dict))
OBJECTS = Kind("a non-empty object of objects",
               lambda value: bool(value) and object_of(OBJECT).holds(value))


def check(found: Mapping[str, Any], fields: Fields, where: object, inside: str = "") -> None:
    """Raises RunError about the first field that is absent or of another kind. `where` is a file or
    a line of it; `inside` what encloses the fields there, such as "machine."."""
    for name, kind in fields.items():
        if name not in found:
            if kind.needed:
                raise RunError(f"{where} has no field '{inside}{name}'")
        elif not kind.holds(found[name]):
            raise RunError(f"{where}: {inside}{name} is {shown(found[name])}, not {kind.words}")


def shown(value: Any) -> str:
    """On one line, and not all of it if it is long."""
    text = json.dumps(value, default=str)
    return text if len(text) <= _SHOWN else f"{text[:_SHOWN]}…"
