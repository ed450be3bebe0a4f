"""A vectorised environment for control and learning: many machines at once, with `reset`, `step` and seeds."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, Callable, Mapping, Optional, Sequence

import numpy as np

from ._arrays import dimensions
from ._problems import RequestError, refusal
from ._values import TIME, Value, si

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from ._machine import Machine

Reward = Callable[["NDArray[np.float64]", "NDArray[np.float64]"], Any]


class Environment:
    """`count` copies of a machine, controlled together.

    machine   its free coordinates move, and efforts along those of `act` are the actions
    act       efforts along coordinates, in the order of the actions' columns
    observe   channels, in the order of the observations' columns
    span      time of a step
    start     ranges in SI from which start values are drawn: {"theta": (-0.05, 0.05), "theta.rate": (-0.05, 0.05)}
    reward    function of observations and actions; 1 for each step by default
    ended     function of the observations that returns which copies have ended
    most      steps after which a copy is cut off

    A copy that has ended is restarted by the next `step`, which returns its first observation. The random numbers of
    copy k depend on the seed and k alone, not on the number of copies or threads.
    """

    def __init__(self, machine: "Machine", count: int, *, act: Sequence[str], observe: Sequence[str], span: Value,
                 start: Optional[Mapping[str, tuple[float, float]]] = None, reward: Optional[Reward] = None,
                 ended: Optional[Callable[["NDArray[np.float64]"], Any]] = None, most: int = 500,
                 method: str = "rk4", step: Optional[Value] = None, threads: Optional[int] = None) -> None:
        self.machine, self.count, self.act, self.observe = machine, count, tuple(act), tuple(observe)
        self._ranges = {name: (float(low), float(high)) for name, (low, high) in (start or {}).items()}
        self._reward, self._ended, self.most = reward, ended, most
        with machine._lock:
            self.span = si(machine._ready().model, span, TIME, "span")
        at = {n: np.zeros(count) for n in self._ranges if not n.endswith(".rate")}
        rate = {n[:-5]: np.zeros(count) for n in self._ranges if n.endswith(".rate")}
        self.simulations = machine.simulations(count, of=self.observe, effort=self.act, at=at, rate=rate, method=method,
                                               step=span if method == "rk4" and step is None else step,
                                               threads=threads)
        self.steps = np.zeros(count, np.int64)
        self._over = np.zeros(count, bool)
        self._random: list[np.random.Generator] = []
        self.reset(seed=0)

    def reset(self, seed: Optional[int] = None) -> tuple["NDArray[np.float64]", dict[str, Any]]:
        """Restarts all copies and, with a seed, the random numbers. Returns observations [copy, channel] and {}."""
        if seed is not None or not self._random:
            root = np.random.SeedSequence(seed)
            self._random = [np.random.default_rng(np.random.SeedSequence(root.entropy, spawn_key=(k,)))
                            for k in range(self.count)]
        self._restart(np.arange(self.count))
        return self.simulations.values.copy(), {}

    def _restart(self, which: "NDArray[np.int64]") -> None:
        drawn = np.array([self._random[k].random(len(self._ranges)) for k in which]).reshape(len(which), -1)
        at, rate = {}, {}
        for column, (name, (low, high)) in enumerate(self._ranges.items()):
            values = low + (high - low) * drawn[:, column]
            if name.endswith(".rate"):
                rate[name[:-5]] = values
            else:
                at[name] = values
        self.simulations.restart(which, at=at, rate=rate)
        self.steps[which], self._over[which] = 0, False

    def step(self, actions: Any) -> tuple[Any, Any, Any, Any, dict[str, Any]]:
        """Acts on all copies for one span: actions [copy, effort], or [copy] with one effort.

        Returns observations, rewards, which copies ended, which were cut off, and {"status": ...} of the simulations.
        Rewards of copies that were restarted are 0.
        """
        restarted = np.flatnonzero(self._over)
        values = self.simulations.step(self.span, actions)
        self.steps += 1
        if restarted.size:
            self._restart(restarted)
        failed = self.simulations.status < 0
        ended = failed if self._ended is None else failed | self._answer("ended", self._ended(values), bool)
        reward = np.ones(self.count)
        if self._reward is not None:
            reward = self._answer("reward", self._reward(values, actions), float)
        reward[restarted] = 0.0
        cut = (self.steps >= self.most) & ~ended
        self._over = ended | cut
        return values.copy(), reward, ended, cut, {"status": self.simulations.status.copy()}

    def _answer(self, name: str, value: Any, kind: type) -> "NDArray[Any]":
        """Copies the result of a caller's function, one value for each copy."""
        if dimensions(value, name) != 1 or len(value) != self.count:
            raise refusal(RequestError, "E0806", f"`{name}` returns an array of shape {(self.count,)}, not {np.shape(value)}")
        return np.array(value, kind)

    def close(self) -> None:
        """Frees the simulations."""
        self.simulations.close()

    def __repr__(self) -> str:
        return f"<yoke.Environment: {self.count} of {self.machine.name!r}, act {self.act}, observe {self.observe}>"
