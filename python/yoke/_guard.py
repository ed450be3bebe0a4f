"""Objects that belong to one thread at a time: their locks, and what a close or a fork does to them."""
from __future__ import annotations

import os
from threading import RLock
from weakref import WeakSet

from ._problems import ClosedError


class Guarded:
    """An object with a lock. A second thread waits for the first; after `close` every use is refused."""

    __slots__ = ("_lock", "_gone", "__weakref__")

    def __init__(self) -> None:
        self._lock = RLock()
        self._gone = ""  # why it can no longer be used
        _all.add(self)

    def _give_up(self, why: str) -> None:
        """Ends the object without touching what it holds."""
        self._lock, self._gone = RLock(), why

    def _refuse(self) -> None:
        raise ClosedError(f"this {type(self).__name__.lower()} {self._gone}")


_all: "WeakSet[Guarded]" = WeakSet()


def _after_fork() -> None:
    """Gives up, in the child, objects that another thread was using at the fork: they may be half changed."""
    for one in list(_all):
        if one._lock.acquire(blocking=False):
            one._lock.release()
        else:
            one._give_up("was in use by another thread when the process forked")


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_after_fork)

