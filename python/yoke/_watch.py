"""Long calls: Ctrl-C ends them, and a progress bar follows them."""
from __future__ import annotations

from _thread import get_ident
from types import TracebackType
from typing import Any, Callable, Optional, Union

from ._native import ffi, lib

Progress = Union[bool, Callable[[float], object], None]
_reports: dict[int, Callable[[float], object]] = {}  # by thread
_raised: dict[int, BaseException] = {}  # by thread: the exception of a callback, which ended the call


def keep(_kind: Any, error: BaseException, _trace: Any) -> None:
    """Keeps a callback's exception until the call that it ended has returned."""
    _raised[get_ident()] = error


@ffi.def_extern(error=False, onerror=keep)  # type: ignore[misc]
def yk_host_ask(part: float) -> bool:
    """Lets Python look at signals, and reports the progress."""
    report = _reports.get(get_ident())
    if report is not None:
        report(part)
    return True


def check() -> None:
    """Raises the exception that ended a long call of this thread, if there was one."""
    if _raised:
        error = _raised.pop(get_ident(), None)
        if error is not None:
            raise error


def _bar(title: str) -> tuple[Optional[Callable[[float], object]], Callable[[], object]]:
    try:
        from tqdm.auto import tqdm  # type: ignore[import]
    except ImportError:
        return None, lambda: None
    bar = tqdm(total=1.0, desc=title, bar_format="{l_bar}{bar}| {elapsed}<{remaining}")
    return (lambda part: bar.update(max(0.0, part - bar.n))), bar.close


class Watch:
    """Follows the long calls of a block: `progress` is True (tqdm, if it is installed), a function, or None."""

    __slots__ = ("progress", "title", "before", "close")

    def __init__(self, progress: Progress, title: str) -> None:
        self.progress, self.title = progress, title
        self.close: Callable[[], object] = lambda: None

    def __enter__(self) -> "Watch":
        me = get_ident()
        self.before = _reports.get(me)
        report: Optional[Callable[[float], object]] = None
        if callable(self.progress):
            report = self.progress
        elif self.progress is True:
            report, self.close = _bar(self.title)
        if report is not None:
            _reports[me] = report
        return self

    def __exit__(
        self, kind: Optional[type[BaseException]], error: Optional[BaseException], trace: Optional[TracebackType]
    ) -> None:
        me = get_ident()
        if self.before is None:
            _reports.pop(me, None)
        else:
            _reports[me] = self.before
        self.close()


progress_of_host = lib.yk_host_progress()
