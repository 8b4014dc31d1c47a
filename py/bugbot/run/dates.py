"""`datetime` and `date` of Python's own `datetime` module on simulated time.

May import: the standard library, `bugbot.own_clock`.

The two types are C's and can't be changed, so during a run the module has subclasses of
them in their place. The zone of the place is UTC, whatever the machine's is.
"""

from __future__ import annotations

from collections.abc import Callable
from datetime import date, datetime, timedelta, timezone, tzinfo
from typing import Any

from bugbot.own_clock import EPOCH_S

__all__ = ["simulated_dates"]

_UTC = timezone.utc  # noqa: UP017  `datetime.UTC` is that of the module, which a run changes


def simulated_dates(now: Callable[[], float]) -> dict[str, type]:
    """What the module `datetime` has during a run whose clock is `now` [s]."""

    def moment(tz: tzinfo | None) -> datetime:
        start = datetime.fromtimestamp(EPOCH_S, _UTC)
        at = start + timedelta(seconds=now())
        return at.replace(tzinfo=None) if tz is None else at.astimezone(tz)

    class SimulatedDate(date, metaclass=_StandIn):
        @classmethod
        def today(cls) -> Any:
            at = moment(None)
            return cls(at.year, at.month, at.day)

        @classmethod
        def fromtimestamp(cls, timestamp: float, /) -> Any:
            at = datetime.fromtimestamp(timestamp, _UTC)
            return cls(at.year, at.month, at.day)

        def __repr__(self) -> str:
            return f"datetime.{date.__repr__(self).removeprefix('datetime.')}"

    class SimulatedDatetime(datetime, metaclass=_StandIn):
        @classmethod
        def now(cls, tz: tzinfo | None = None) -> Any:
            return _as(cls, moment(tz))

        @classmethod
        def utcnow(cls) -> Any:
            return _as(cls, moment(None))

        @classmethod
        def today(cls) -> Any:
            return _as(cls, moment(None))

        @classmethod
        def fromtimestamp(cls, timestamp: float, tz: tzinfo | None = None) -> Any:
            at = datetime.fromtimestamp(timestamp, tz or _UTC)
            return _as(cls, at.replace(tzinfo=tz))

        def timestamp(self) -> float:
            aware = self if self.tzinfo else self.replace(tzinfo=_UTC)
            return datetime.timestamp(aware)

        def astimezone(self, tz: tzinfo | None = None) -> Any:
            aware = self if self.tzinfo else self.replace(tzinfo=_UTC)
            return datetime.astimezone(aware, tz or _UTC)

        def __repr__(self) -> str:
            return f"datetime.{datetime.__repr__(self).removeprefix('datetime.')}"

    for stand_in, real in ((SimulatedDate, date), (SimulatedDatetime, datetime)):
        stand_in.__name__ = stand_in.__qualname__ = real.__name__
        stand_in.__module__ = "datetime"
        stand_in.stands_in_for = real
    return {"date": SimulatedDate, "datetime": SimulatedDatetime}


class _StandIn(type):
    """A type that takes the instances of the one whose place it has for its own."""

    stands_in_for: type

    def __instancecheck__(cls, thing: object) -> bool:
        real = vars(cls).get("stands_in_for")  # a subclass of the program's has none
        return isinstance(thing, real) if real else super().__instancecheck__(thing)

    def __subclasscheck__(cls, other: type) -> bool:
        real = vars(cls).get("stands_in_for")
        return issubclass(other, real) if real else super().__subclasscheck__(other)


def _as(cls: type[datetime], at: datetime) -> datetime:
    """The same moment as an instance of this type."""
    return cls(
        at.year,
        at.month,
        at.day,
        at.hour,
        at.minute,
        at.second,
        at.microsecond,
        at.tzinfo,
        fold=at.fold,
    )
