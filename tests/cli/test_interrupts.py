"""Ctrl-C in long verbs: a clean end, one line, nothing left behind. Run: YOKE=path/of/yoke python3 tests/cli/test_interrupts.py"""

import os
import pty
import signal
import subprocess
import sys
import time
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from harness import ROOT, YOKE, Case

HANG = 120  # s: nothing here takes so long, on any machine; it only keeps a hanging test from hanging for ever


def ladder(loops):
    """A ladder of four-bars on one bank of pins."""
    lines = ["bodies:", "  ground: {points: {%s}}" % ", ".join(f"O{k}: [{0.3 * k:g}, 0]" for k in range(loops + 1))]
    for k in range(loops + 1):
        lines.append(f"  r{k}: {{points: {{O{k}: [0, 0], A{k}: [0.1, 0], B{k}: [0.1, 0.0{k % 3}]}}, mass: 1 kg, center: [0.05, 0]}}")
    for k in range(loops):
        lines.append(f"  c{k}: {{points: {{A{k}: [0, 0], B{k + 1}: [0.3, 0]}}, mass: 1 kg, center: [0.15, 0]}}")
    lines.append("joints:")
    lines += [f"  O{k}: {{pin: [ground, r{k}], angle: t{k}}}" for k in range(loops + 1)]
    for k in range(loops):
        lines += [f"  A{k}: {{pin: [r{k}, c{k}], angle: u{k}}}", f"  B{k + 1}: {{pin: [c{k}, r{k + 1}]}}"]
    lines.append("gravity: [0, -9.81]")
    lines.append("drives: {t0: 60 deg + 1 rad/s * t}")
    lines.append("start: {%s}" % ", ".join(f"u{k}: -60 deg, t{k + 1}: 60 deg" for k in range(loops)))
    return "\n".join(lines) + "\n"


def chain(rods):
    """A hanging chain: many freedoms."""
    lines = ["bodies:", "  ground: {points: {J0: [0, 0]}}"]
    lines += [f"  b{k}: {{points: {{J{k}: [0, 0], J{k + 1}: [0.1, 0]}}, mass: 1 kg, center: [0.05, 0], inertia: 0.001}}" for k in range(rods)]
    lines.append("joints:")
    lines += [f"  J{k}: {{pin: [{f'b{k - 1}' if k else 'ground'}, b{k}], angle: t{k}}}" for k in range(rods)]
    lines.append("gravity: [0, -9.81]")
    lines.append("start: {%s}" % ", ".join(f"t{k}: 10 deg" for k in range(rods)))
    return "\n".join(lines) + "\n"


def catches(pid, number):
    """Says whether a process has a handler for a signal; where the system does not tell, that it has."""
    try:
        with open(f"/proc/{pid}/status") as file:
            caught = next(line for line in file if line.startswith("SigCgt"))
    except (OSError, StopIteration):
        return True
    return bool(int(caught.split()[1], 16) >> (number - 1) & 1)


class Interrupts(Case):
    def setUp(self):
        super().setUp()
        self.four_bar = os.path.join(ROOT, "examples", "four-bar.yaml")

    def machine(self, name, text):
        path = self.path(name)
        with open(path, "w") as file:
            file.write(text)
        return path

    def start(self, *words, **more):
        return subprocess.Popen([YOKE, *words], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, cwd=self.folder, **more)

    def stop(self, *words, after=0.4, number=signal.SIGINT):
        """Starts a verb that would take minutes, sends the signal; returns what it wrote."""
        before = set(os.listdir(self.folder))
        process = self.start(*words)
        while process.poll() is None and not catches(process.pid, number):
            time.sleep(0.005)  # a busy machine starts programs late
        time.sleep(after)
        self.assertIsNone(process.poll(), "it ended before it was stopped: " + " ".join(words))
        process.send_signal(number)
        out, err = process.communicate(timeout=HANG)
        self.assertEqual(process.returncode, 128 + number, err)
        self.assertRegex(err.splitlines()[-1], "^yoke: stopped by (Ctrl-C|a signal)$")
        self.assertEqual(len([line for line in err.splitlines() if "stopped" in line]), 1, err)
        self.assertNotIn("E0100", err)
        self.assertEqual(set(os.listdir(self.folder)), before)
        return out, err

    def test_long_verbs_end_with_130_and_leave_nothing(self):
        small, chained = self.machine("ladder.yaml", ladder(300)), self.machine("chain.yaml", chain(30))
        for words in (
            ("sweep", self.four_bar, "--over", "theta2=0:360deg", "--steps", "9000000", "--of", "theta4", "-o", "out.csv"),
            ("sweep", small, "--over", "t0=60:61deg", "--steps", "5000000", "--of", "t9", "-o", "out.csv", "--format", "csv"),
            ("rest", chained, "--starts", "100000", "-o", "out.txt"),
            ("report", self.machine("larger.yaml", ladder(1000)), "-o", "out.html"),
        ):
            with self.subTest(words[0]):
                out, err = self.stop(*words)
                self.assertEqual(out, "")
                self.assertEqual(len(err.splitlines()), 1, err)

    def test_long_derivations_printed_code_and_loading_end_too(self):
        large = self.machine("large.yaml", ladder(20000))
        for words, after in ((("check", large), 0.1), (("derive", large, "--what", "all", "-o", "out.txt"), 2), (("code", large, "-o", "out.c"), 2)):
            with self.subTest(words[0]):
                out, err = self.stop(*words, after=after)
                self.assertEqual((out, len(err.splitlines())), ("", 1), err)

    def test_an_old_output_file_stays_as_it_was(self):
        with open(self.path("out.csv"), "w") as file:
            file.write("old\n")
        self.stop("sweep", self.four_bar, "--over", "theta2=0:360deg", "--steps", "9000000", "--of", "theta4", "-o", "out.csv")
        with open(self.path("out.csv")) as file:
            self.assertEqual(file.read(), "old\n")

    def test_all_configurations_come_out_as_far_as_they_were_found(self):
        ground = ", ".join("A%d: [%d, 0], B%d: [%d, 0]" % (k, 3 * k, k, 3 * k + 1) for k in range(30))
        text = "bodies:\n  ground: {points: {%s}}\n" % ground + "".join(
            "  a%d: {points: {A%d: [0, 0], C: [0.9, 0]}}\n  b%d: {points: {B%d: [0, 0], C: [0.8, 0]}}\n" % (k, k, k, k) for k in range(30))
        text += "joints:\n" + "".join(
            "  A%d: {pin: [ground, a%d]}\n  B%d: {pin: [ground, b%d]}\n  C%d: {pin: [a%d, b%d], at: C}\n" % (k, k, k, k, k, k, k) for k in range(30))
        file = self.machine("side.yaml", text)
        for after in (0.1, 0.3, 1, 3):  # all takes less than a second, but a busy machine has found none by then
            out, err = self.stop("solve", file, "--all", "--of", "a0.angle", after=after)
            if out:
                break
        self.assertRegex(out.splitlines()[-1], r"^\d+ configurations; .*there may be others: not all combinations")

    def test_sigterm_ends_it_as_well(self):
        self.stop("sweep", self.four_bar, "--over", "theta2=0:360deg", "--steps", "9000000", "--of", "theta4", number=signal.SIGTERM)

    def test_standard_input_that_never_comes_can_be_stopped(self):
        process = self.start("check", "-", stdin=subprocess.PIPE)
        time.sleep(0.5)
        process.send_signal(signal.SIGINT)
        process.wait(timeout=HANG)
        _, err = process.communicate()
        self.assertEqual((process.returncode, err), (130, "yoke: stopped by Ctrl-C\n"))

    def test_a_study_says_how_far_it_came(self):
        process = self.start("study", self.four_bar, "--vary", "b=110mm:130mm:3000000", "--over", "theta2=0:360deg", "--of", "theta4")
        time.sleep(1)
        self.assertIsNone(process.poll())
        process.send_signal(signal.SIGINT)
        out, err = process.communicate(timeout=HANG)
        self.assertEqual((process.returncode, out), (1, ""), err)
        self.assertRegex(err, r"interrupted after \d+ of 3000000 designs")

    def test_without_a_terminal_there_is_no_progress(self):
        _, err = self.stop("sweep", self.four_bar, "--over", "theta2=0:360deg", "--steps", "9000000", "--of", "theta4", after=1.6)
        self.assertNotIn("\r", err)

    def on_terminal(self, *more):
        """Standard error is a terminal; returns what was seen on it."""
        main, other = pty.openpty()
        words = ("sweep", self.four_bar, "--over", "theta2=0:360deg", "--steps", "9000000", "--of", "theta4", *more)
        process = subprocess.Popen([YOKE, *words], stdout=subprocess.DEVNULL, stderr=other, cwd=self.folder, env={**os.environ, "TERM": "xterm"})
        os.close(other)
        time.sleep(2.5)
        process.send_signal(signal.SIGINT)
        seen = b""
        while True:
            try:
                block = os.read(main, 65536)
            except OSError:  # the other end is closed
                break
            if not block:
                break
            seen += block
        process.wait(timeout=HANG)
        os.close(main)
        self.assertEqual(process.returncode, 130)
        return seen.decode()

    def test_on_a_terminal_one_line_of_progress_is_shown_and_erased(self):
        seen = self.on_terminal()
        self.assertRegex(seen, r"\rsweep: \d+ %, \d+ s \x1b\[K")
        before, last = seen.rsplit("\r\x1b[K", 1)
        self.assertNotIn("\n", before)
        self.assertRegex(last, "^yoke: stopped by Ctrl-C\r?\n$")

    def test_quiet_shows_no_progress(self):
        self.assertRegex(self.on_terminal("--quiet"), "^yoke: stopped by Ctrl-C\r?\n$")


if __name__ == "__main__":
    unittest.main()
