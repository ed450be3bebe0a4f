"""yoke study, synthesize and map on several ranks of the real mpirun, oversubscribed. Run: YOKE=path/of/yoke python3 tests/cli/test_ranks.py
With YOKE_FULL=1 ranks are killed a hundred times. Without Open MPI or the plugin: skipped, exit code 77."""
import json
import os
import random
import resource
import shutil
import signal
import struct
import subprocess
import sys
import time
import unittest

from harness import Case, ROOT, YOKE

FOUR_BAR = os.path.join(ROOT, "examples", "four-bar.yaml")
PLUGIN = os.path.join(os.path.dirname(YOKE), "yoke-mpi.so")
MPIRUN = shutil.which("mpirun")
ENVIRONMENT = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1", OMPI_MCA_rmaps_base_oversubscribe="1",
                   OMPI_MCA_hwloc_base_binding_policy="none", OMPI_MCA_btl="self,vader", OMPI_MCA_orte_abort_print_stack="0")
# A study of a second or two: long enough to be killed in the middle.
LONG = ["--vary", "a=39mm:41mm:40000", "--over", "theta2=0:360deg", "--steps", "720", "--of", "gamma,theta4"]
SHORT = ["--vary", "a=20mm:60mm:1500", "--vary", "b=118mm:122mm:3", "--over", "theta2=0:360deg", "--steps", "36", "--of",
         "theta4,coupler.P.x"]


# A platform on three legs, two of which cranks move: a tile of its map takes long.
LEGS = """
bodies:
  ground: {points: {A: [0, 0], B: [2, 0], C: [1, 1.7]}}
  crank1: {points: {A: [0, 0], G: [0.3, 0]}}
  crank2: {points: {B: [0, 0], H: [0.35, 0]}}
  leg1: {points: {G: [0, 0], D: [0.8, 0]}}
  leg2: {points: {H: [0, 0], E: [0.75, 0]}}
  leg3: {points: {C: [0, 0], F: [0.9, 0]}}
  plate: {points: {D: [0, 0], E: [0.6, 0], F: [0.35, 0.5]}}
joints:
  A: {pin: [ground, crank1], angle: u}
  B: {pin: [ground, crank2], angle: v}
  C: {pin: [ground, leg3]}
  G: {pin: [crank1, leg1]}
  H: {pin: [crank2, leg2]}
  D: {pin: [leg1, plate]}
  E: {pin: [leg2, plate]}
  F: {pin: [leg3, plate]}
drives: {u: 1, v: 2}
"""


class Ranks(Case):
    whole = None

    def words(self, ranks, *words, yoke=YOKE):
        return [MPIRUN, "-n", str(ranks), yoke, *words]

    def mpirun(self, ranks, *words, **options):
        return subprocess.run(self.words(ranks, *words), env=ENVIRONMENT, capture_output=True, encoding="utf-8", timeout=300,
                              check=False, **options)

    def path(self, name):
        return os.path.join(self.folder, name)

    def read(self, path):
        with open(path, "rb") as file:
            return file.read()

    def alone(self, name, *words):
        self.good("study", FOUR_BAR, *words, "-o", self.path(name))
        return self.read(self.path(name))

    def long(self):
        """The bytes of the long study by one process, computed once."""
        if Ranks.whole is None:
            Ranks.whole = self.alone("alone.csv", *LONG)
        return Ranks.whole

    def test_the_bytes_are_those_of_one_process(self):
        for ending in "csv", "npy", "jsonl", "json", "txt":
            whole = self.alone("alone." + ending, *SHORT)
            for ranks, threads in ((1, 2), (2, 1), (7, 1), (2, 3)) if ending == "csv" else ((3, 1),):
                out = self.path(f"out-{ranks}-{threads}.{ending}")
                done = self.mpirun(ranks, "study", FOUR_BAR, *SHORT, "--threads", str(threads), "-o", out)
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertEqual(self.read(out), whole, (ending, ranks, threads))
                self.assertFalse(os.path.exists(out + ".partial"))

    def test_a_sample_and_sensitivities_and_the_standard_output(self):
        tolerances = self.write("tolerance.yaml", "seed: 7\ndesigns: 900\nparameters:\n  a: {normal: [40 mm, 0.1 mm]}\n")
        words = ["study", FOUR_BAR, "--sample", tolerances, "--of", "theta4", "--sensitivities"]
        whole = self.good(*words)
        done = self.mpirun(3, *words)
        self.assertEqual((done.returncode, done.stdout), (0, whole.out), done.stderr)

    def test_lines_of_json_are_the_rows_of_csv(self):
        lines = [json.loads(line) for line in self.alone("rows.jsonl", *SHORT).decode().splitlines()]
        rows = [line.split(",") for line in self.alone("rows.csv", *SHORT).decode().splitlines()]
        self.assertEqual(len(lines), 4500)
        self.assertEqual(list(lines[0]), rows[0])
        for line, row in zip(lines, rows[1:]):
            for value, text in zip(line.values(), row):
                self.assertEqual("" if value is None else str(value) if isinstance(value, str) else float(value),
                                 text if isinstance(value, str) or text == "" else float(text))

    def test_a_search_finds_the_same_machines(self):
        tasks = os.path.join(ROOT, "examples", "tasks")
        # paths of two kinds of bars, a machine's parameters, and a task that has no pieces
        for name, ranks in (("straight-line", 3), ("straight-line-machine", 2), ("four-positions", 2)):
            words = ["synthesize", os.path.join(tasks, name + ".yaml"), "--seed", "5"]
            alone, shared = self.path(name), self.path(name + "-shared")
            whole = self.good(*words, "-o", alone)
            done = self.mpirun(ranks, *words, "-o", shared)
            self.assertEqual((done.returncode, done.stdout), (0, whole.out), done.stderr)
            self.assertEqual(sorted(os.listdir(alone)), sorted(os.listdir(shared)))
            for file in os.listdir(alone):
                self.assertEqual(self.read(os.path.join(shared, file)), self.read(os.path.join(alone, file)), file)

    def test_a_search_is_refused_once(self):
        task = os.path.join(ROOT, "examples", "tasks", "oval.yaml")
        for words, code in (([self.path("no.yaml")], "[E0130]"), ([task, "-o", ROOT], "[E0846]")):
            done = self.mpirun(3, "synthesize", *words)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertEqual(done.stderr.count("error: "), 1, done.stderr)
            self.assertIn(code, done.stderr)

    def test_ranks_with_different_tasks_are_refused(self):
        script = self.write("task-of-rank", "#!/bin/sh\nexec " + YOKE + " synthesize " + self.path("task-$OMPI_COMM_WORLD_RANK.yaml") + "\n")
        os.chmod(script, 0o755)
        for k in 0, 1:
            self.write(f"task-{k}.yaml", f"synthesis: path\npoints:\n- [0, 0]\n- [1, {k}]\n- [2, 0.5]\n")
        done = subprocess.run([MPIRUN, "-n", "2", script], env=ENVIRONMENT, capture_output=True, encoding="utf-8", timeout=300, check=False)
        self.assertEqual((done.returncode, done.stdout), (2, ""), done.stderr)
        self.assertIn("has another task, model file or command line than rank 0 [E0853]", done.stderr)

    def test_a_search_without_time_ends_on_all_ranks(self):
        words = ["synthesize", os.path.join(ROOT, "examples", "tasks", "straight-line.yaml"), "--within", "1e-9s", "--format", "json"]
        done = self.mpirun(3, *words)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertEqual(json.loads(done.stdout)["status"], "time")

    def test_a_map_is_the_same(self):
        legs = self.write("legs.yaml", LEGS)
        five = os.path.join(ROOT, "examples", "five-bar.yaml")
        for words, ranks in (([five, "--format", "json"], (1, 2, 7)), ([five, "--over", "reachL.P.x,reachL.P.y"], (2,)),
                             ([legs, "--tol", "0.1", "--format", "json", "--plot", self.path("map.svg")], (3,))):
            whole = self.good("map", *words)
            drawn = self.read(self.path("map.svg")) if "--plot" in words else None
            for count in ranks:
                done = self.mpirun(count, "map", *words)
                self.assertEqual((done.returncode, done.stdout), (0, whole.out), done.stderr)
            if drawn:
                self.assertEqual(self.read(self.path("map.svg")), drawn)

    def test_a_map_is_refused_once(self):
        five = os.path.join(ROOT, "examples", "five-bar.yaml")
        for words, code in (([self.path("no.yaml")], "E0130"), ([five, "--over", "theta1,no"], "E0"), ([five, "--tol", "2"], "E0806"),
                            ([FOUR_BAR], "E0851"), ([five, "--at", "theta1=1"], "E0851")):
            done = self.mpirun(3, "map", *words)
            self.assertEqual((done.returncode, done.stdout), (2, ""), done.stderr)
            self.assertEqual(done.stderr.count("error: "), 1, done.stderr)
            self.assertIn("[" + code, done.stderr)
        changed = self.write("changed.yaml", self.read(five).decode() + "\n# another file\n")
        done = self.apart([YOKE, "map", five], [YOKE, "map", changed])
        self.assertEqual((done.returncode, done.stdout), (2, ""), done.stderr)
        self.assertIn("has another model file or command line than rank 0 [E0853]", done.stderr)

    def test_a_rank_that_dies_ends_a_map(self):
        out = self.path("map.json")
        child = subprocess.Popen(self.words(3, "map", self.write("legs.yaml", LEGS), "--tol", "0.0005", "--format", "json", "-o", out),
                                 env=ENVIRONMENT, stderr=subprocess.PIPE, stdout=subprocess.DEVNULL)
        # Not before it computes: mpirun itself may wait for ever for one that dies while it starts (a deadlock of Open MPI 4.1).
        deadline = time.monotonic() + 120
        while child.poll() is None and time.monotonic() < deadline:
            ranks = self.ranks_of(child.pid)
            if len(ranks) == 3 and self.seconds_of(max(ranks)) > 0.5:
                os.kill(max(ranks), signal.SIGKILL)
                break
            time.sleep(0.02)
        said = child.communicate(timeout=120)[1].decode()
        self.assertNotEqual(child.returncode, 0, said)
        self.assertFalse(os.path.exists(out))

    def seconds_of(self, pid):
        """The processor's time that a process has taken."""
        with open(f"/proc/{pid}/stat", encoding="utf-8") as file:
            return sum(int(ticks) for ticks in file.read().rsplit(")", 1)[1].split()[11:13]) / os.sysconf("SC_CLK_TCK")

    def test_other_verbs_are_refused_once(self):
        done = self.mpirun(3, "solve", FOUR_BAR)
        self.assertEqual(done.returncode, 2)
        self.assertEqual(done.stderr.count("[E0851]"), 1, done.stderr)
        done = self.mpirun(3, "--version")
        self.assertEqual((done.returncode, done.stdout.count("yoke-mpi")), (0, 1), done.stderr)
        self.assertIn("Open MPI", done.stdout)
        self.assertEqual(self.mpirun(1, "solve", FOUR_BAR).stdout, self.good("solve", FOUR_BAR).out)

    def test_what_is_wrong_is_told_once(self):
        for words, code in ((["nowhere.yaml", *SHORT], "E0130"), ([FOUR_BAR, *SHORT[:-1], "theta9"], "E"),
                            ([FOUR_BAR, "--vary", "a=1:2"], "E08"), ([FOUR_BAR, *SHORT, "--fast"], "E0802")):
            done = self.mpirun(3, "study", *words)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertEqual(done.stderr.count("error: "), 1, done.stderr)
            self.assertIn("[" + code, done.stderr)

    def apart(self, first, second):
        """Two ranks with command lines of their own."""
        command = self.words(1, *first[1:], yoke=first[0]) + [":", "-n", "1", *second]
        return subprocess.run(command, env=ENVIRONMENT, capture_output=True, encoding="utf-8", timeout=120, check=False)

    def test_unequal_ranks_are_refused(self):
        out, other = self.path("out.csv"), self.path("yoke")
        words = ["study", FOUR_BAR, *SHORT, "-o", out]
        version = self.good("--version").out.split()[1].encode()
        made = self.read(YOKE).replace(version + b"\0", b"9" + version[1:] + b"\0")
        with open(other, "wb") as file:
            file.write(made)
        os.chmod(other, 0o755)
        plugin = self.read(PLUGIN).replace(version + b"\0", b"9" + version[1:] + b"\0")
        with open(self.path("yoke-mpi.so"), "wb") as file:
            file.write(plugin)
        done = self.apart([YOKE, *words], [other, *words])
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertRegex(done.stderr, r"rank 1 on \S+ is yoke 9\.[0-9.]+, and rank 0 is yoke .*\[E0853\]")
        with open(self.path("yoke-mpi.so"), "wb") as file: # a plugin that does not belong to its yoke
            file.write(self.read(PLUGIN))
        done = subprocess.run(self.words(2, *words, yoke=other), env=ENVIRONMENT, capture_output=True, encoding="utf-8", timeout=120,
                              check=False)
        self.assertEqual((done.returncode, done.stderr.count("[E0852]")), (2, 1), done.stderr)
        os.remove(self.path("yoke-mpi.so")) # none at all
        done = subprocess.run(self.words(2, *words, yoke=other), env=ENVIRONMENT, capture_output=True, encoding="utf-8", timeout=120,
                              check=False)
        self.assertEqual((done.returncode, done.stderr.count("[E0852]")), (2, 1), done.stderr)
        changed = self.write("changed.yaml", self.read(FOUR_BAR).decode() + "\n# another file\n")
        done = self.apart([YOKE, *words], [YOKE, "study", changed, *words[2:]])
        self.assertEqual(done.returncode, 2)
        self.assertIn("[E0853]", done.stderr)
        done = self.apart([YOKE, *words], [YOKE, "study", self.path("missing.yaml"), *words[2:]])
        self.assertEqual(done.returncode, 2)
        self.assertRegex(done.stderr, r"rank 1 on \S+ could not read the study.*\[E0854\]")
        self.assertIn("E0130", done.stderr)
        self.assertFalse(os.path.exists(out))

    def ranks_of(self, mpirun):
        """The processes of yoke below an mpirun."""
        found = subprocess.run(["ps", "-o", "pid=,comm=", "--ppid", str(mpirun)], capture_output=True, encoding="utf-8", check=False)
        return [int(line.split()[0]) for line in found.stdout.splitlines() if line.split()[1] == "yoke"]

    def start_long(self, out, ranks, least):
        """Starts the long study, and waits until its partial file has grown by so many bytes."""
        begun = os.path.getsize(out + ".partial") if os.path.exists(out + ".partial") else 0
        child = subprocess.Popen(self.words(ranks, "study", FOUR_BAR, *LONG, "-o", out), env=ENVIRONMENT, stderr=subprocess.PIPE,
                                 stdout=subprocess.DEVNULL)
        deadline = time.monotonic() + 120
        while time.monotonic() < deadline and child.poll() is None:
            if os.path.exists(out + ".partial") and os.path.getsize(out + ".partial") > begun + least:
                break
            time.sleep(0.002)
        return child

    def whole_rows(self, path):
        """How many rows the whole blocks of a partial file have."""
        data, at, rows, width = self.read(path), 64, 0, 8 * (3 + 2 * 4)
        while at + 16 <= len(data):
            count = struct.unpack_from("<Q", data, at)[0]
            at += 16 + count * width
            rows += count if at <= len(data) else 0
        return rows

    def test_killed_ranks_lose_no_whole_block(self):
        whole, out = self.long(), self.path("out.csv")
        numbers = random.Random(3)
        kills = 100 if os.environ.get("YOKE_FULL") else 3
        rows = killed = 0
        while killed < kills:
            child = self.start_long(out, 3, numbers.randrange(1, 60000))
            pids = self.ranks_of(child.pid)
            if child.poll() is None and pids:
                try:
                    os.kill(numbers.choice(pids), numbers.choice([signal.SIGKILL, signal.SIGSEGV, signal.SIGTERM]))
                except ProcessLookupError:
                    pass
            said = child.communicate(timeout=120)[1].decode()
            if child.returncode == 0: # it was faster: begin again
                self.assertEqual(self.read(out), whole)
                os.remove(out)
                rows = 0
                killed += 1
                continue
            killed += 1
            if os.path.exists(out): # killed after the output took its name, before it ended
                self.assertEqual(self.read(out), whole, said)
                os.remove(out)
                rows = 0
                continue
            kept = self.whole_rows(out + ".partial")
            self.assertGreaterEqual(kept, rows)
            rows = kept
        done = self.mpirun(2, "study", FOUR_BAR, *LONG, "-o", out)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertNotIn("W0828", done.stderr)
        self.assertEqual(self.read(out), whole)

    def test_one_process_goes_on_where_ranks_stopped(self):
        whole, out = self.long(), self.path("out.csv")
        child = self.start_long(out, 2, 20000)
        child.send_signal(signal.SIGTERM) # mpirun passes it on
        child.communicate(timeout=60)
        self.assertNotEqual(child.returncode, 0)
        self.assertGreater(self.whole_rows(out + ".partial"), 0)
        self.assertEqual(self.alone("out.csv", *LONG), whole)

    def test_a_full_disk_is_told_and_the_study_goes_on(self):
        whole, out = self.long(), self.path("out.csv")
        child = self.start_long(out, 3, 1000)
        size = os.path.getsize(out + ".partial") + 100000
        for pid in self.ranks_of(child.pid): # only now: Open MPI has files of its own
            resource.prlimit(pid, resource.RLIMIT_FSIZE, (size, size))
        said = child.communicate(timeout=120)[1].decode()
        self.assertEqual((child.returncode, said.count("[E0704]")), (2, 1), said)
        self.assertIn("continues from there", said)
        self.assertGreater(self.whole_rows(out + ".partial"), 0)
        done = self.mpirun(3, "study", FOUR_BAR, *LONG, "-o", out)
        self.assertEqual((done.returncode, self.read(out)), (0, whole), done.stderr)

    def test_two_runs_on_one_output(self):
        whole, out = self.long(), self.path("out.csv")
        child = self.start_long(out, 2, 1000)
        pids = self.ranks_of(child.pid)
        self.assertEqual(len(pids), 2)
        for pid in pids: # it holds the file for as long as the others try
            os.kill(pid, signal.SIGSTOP)
        for ranks in 1, 2:
            done = self.mpirun(ranks, "study", FOUR_BAR, *LONG, "-o", out)
            self.assertEqual((done.returncode, done.stderr.count("[E0856]")), (2, 1), done.stderr)
        for pid in pids:
            os.kill(pid, signal.SIGCONT)
        said = child.communicate(timeout=300)[1].decode()
        self.assertEqual((child.returncode, self.read(out)), (0, whole), said)

    def test_a_folder_that_vanishes(self):
        folder = self.path("gone")
        os.mkdir(folder)
        child = self.start_long(os.path.join(folder, "out.csv"), 2, 1000)
        self.assertIsNone(child.poll())
        shutil.rmtree(folder)
        said = child.communicate(timeout=120)[1].decode()
        self.assertEqual(child.returncode, 2, said)
        self.assertEqual(said.count("[E0705]"), 1, said)
        self.assertFalse(os.path.exists(folder))


if __name__ == "__main__":
    if not MPIRUN or not os.path.exists(PLUGIN):
        print("skipped: no mpirun, or the plugin yoke-mpi is not built (tools/install-deps mpi)")
        sys.exit(77)
    unittest.main()
