"""The command's front: verbs, options, help, explanations, where answers go. Run: YOKE=path/of/yoke python3 test_cli.py"""
import os
import resource
import re
import stat
import subprocess
import unittest

from harness import Case, FOUR_BAR, ROOT, YOKE, Run

VERBS = ["check", "solve", "sweep", "simulate", "rest", "draw", "gears", "cam", "derive", "report", "code", "new", "explain", "synthesize", "map", "cognates", "balance"]


class Front(Case):
    def test_alone_it_shows_what_to_do_next(self):
        run = self.good()
        for word in VERBS + ["yoke check machine.yaml"]:
            self.assertIn(word, run.out)
        self.assertEqual(run.err, "")

    def test_the_tour_can_be_walked(self):
        steps = re.findall(r"(?m)^  yoke (.*?)(?:  .*)?$", self.good().out.split("Verbs:")[0])
        self.assertEqual([step.split()[0] for step in steps], ["new", "check", "solve", "sweep", "draw", "derive"])
        for step in steps:
            words, _, target = step.partition(" > ")
            run = self.good(*words.split(), cwd=self.folder)
            if target:
                self.write(target, run.out)
        self.assertTrue(os.path.exists(self.path("machine.svg")))

    def test_every_verb_has_help_with_an_example(self):
        for verb in VERBS:
            for words in ([verb, "--help"], [verb, "-h"], ["help", verb]):
                run = self.good(*words)
                self.assertIn("yoke " + verb, run.out)
                self.assertIn("Example:", run.out)

    def test_help_lists_only_what_the_verb_takes(self):
        self.assertIn("--over", self.good("sweep", "--help").out)
        self.assertNotIn("--over", self.good("solve", "--help").out)
        self.assertNotIn("--trace", self.good("check", "--help").out)

    def test_version_is_one_line_and_another_for_the_plugin(self):
        self.assertRegex(self.good("--version").out, r"\Ayoke (\d+\.\d+\.\d+)\n(yoke-mpi \1, .+\n)?\Z")


class Mistakes(Case):
    def test_an_unknown_verb_gets_the_nearest(self):
        self.assertIn("did you mean `solve`?", self.wrong(801, "sovle", self.four_bar).err)
        self.assertIn("hint:", self.wrong(801, "xyzzy").err)

    def test_an_unknown_option_gets_the_nearest(self):
        self.assertIn("did you mean `--format`?", self.wrong(802, "solve", self.four_bar, "--fromat", "json").err)
        self.wrong(802, "solve", self.four_bar, "-z")

    def test_only_options_of_the_verb_are_proposed(self):
        self.assertNotIn("did you mean", self.wrong(802, "solve", self.four_bar, "--frob").err)  # nor `--from`
        self.assertIn("did you mean `--from`?", self.wrong(802, "simulate", self.four_bar, "--frob").err)

    def test_the_value_of_an_unknown_option_is_not_a_second_file(self):
        for words in ([self.four_bar, "--fromat", "json"], ["--fromat", "json", self.four_bar]):
            self.assertNotIn("[E0809]", self.wrong(802, "solve", *words).err)
        self.assertIn("[E0809]", self.wrong(809, "solve", self.four_bar, self.four_bar).err)

    def test_an_option_of_another_verb_is_refused(self):
        self.assertIn("--over", self.wrong(803, "solve", self.four_bar, "--over", "theta1=0:1").err)

    def test_values_are_demanded_and_switches_take_none(self):
        self.wrong(804, "solve", self.four_bar, "--at")
        self.wrong(804, "solve", self.four_bar, "--at=")
        self.wrong(805, "solve", self.four_bar, "--all=yes")

    def test_formats_are_three(self):
        self.wrong(806, "solve", self.four_bar, "--format", "xml")

    def test_pairs_have_a_name_and_a_value(self):
        for word in ("theta1", "=1", "theta1="):
            self.wrong(807, "solve", self.four_bar, "--at", word)

    def test_one_file_is_needed_and_no_more(self):
        for verb in ("check", "solve", "sweep", "simulate", "rest", "draw"):
            self.wrong(808, verb)
        self.wrong(809, "solve", self.four_bar, self.rocker)

    def test_two_meanings_of_one_option_are_refused(self):
        self.wrong(817, "solve", self.four_bar, "--time", "1s", "--time", "2s")
        self.good("solve", self.four_bar, "--time", "1s", "--time", "1s")

    def test_efforts_along_nothing_are_refused(self):
        self.wrong(814, "solve", self.four_bar, "--effort", "theta9=3")

    def test_all_mistakes_come_in_one_run(self):
        run = self.wrong(802, "solve", self.four_bar, "--fromat", "json", "--at", "x", "--format", "xml")
        for code in ("[E0802]", "[E0807]", "[E0806]"):
            self.assertIn(code, run.err)

    def test_a_missing_file_is_told(self):
        run = Run("solve", self.path("none.yaml"))
        self.assertEqual(run.code, 2)
        self.assertIn("none.yaml", run.err)
        self.assertRegex(run.err, r"\[E01\d\d\]")

    def test_mistakes_in_the_file_are_quoted_with_their_place(self):
        path = self.write("bad.yaml", FOUR_BAR.replace("pin: [crank, coupler]", "pin: [crank, couplr]"))
        run = Run("check", path)
        self.assertEqual(run.code, 2)
        self.assertRegex(run.err, r"bad\.yaml:11:\d+: error: .*couplr")
        self.assertIn("did you mean `coupler`?", run.err)
        self.assertIn("^", run.err)

    def test_a_drive_without_a_value_is_quoted_from_the_file(self):
        path = self.write("drive.yaml", "bodies: {ground: {points: {A: [0, 0]}}, arm: {points: {A: [0, 0]}}}\n"
                          "joints: {A: {pin: [ground, arm], angle: theta}}\ndrives: {theta: 1 rad * sqrt(1 - t/(2 s))}\n")
        for words in (["solve", path, "--time", "3s"], ["draw", path, "--time", "3s"],
                      ["sweep", path, "--over", "t=0:3s", "--steps", "3"]):
            run = Run(*words)
            self.assertEqual(run.code, 2, words)
            self.assertRegex(run.err, r"drive\.yaml:3:25: error: .*square root", words)
            self.assertIn("\n    drives: {theta: 1 rad * sqrt(1 - t/(2 s))}\n" + " " * 28 + "^", run.err)
        self.assertIn("yoke: error: bad-model: t goes no further than 2 s: beyond, a drive has no value", run.err)

    def test_words_with_control_characters_come_out_escaped(self):
        run = Run("solve", self.four_bar, "--at", "th\x1b[31m=3")
        self.assertEqual(run.code, 2)
        self.assertNotIn("\x1b", run.err)


class Words(Case):
    def test_options_stand_before_or_behind_and_with_equals(self):
        plain = self.good("solve", self.four_bar, "--at", "theta1=50", "--format", "csv").out
        for words in (["--at=theta1=50", "solve", "--format=csv", self.four_bar], ["solve", "--format", "csv", "--at", "theta1=50", "--", self.four_bar]):
            self.assertEqual(self.good(*words).out, plain)

    def test_a_dash_reads_standard_input(self):
        from_file = self.good("solve", self.four_bar, "--format", "csv").out
        self.assertEqual(self.good("solve", "-", "--format", "csv", stdin=FOUR_BAR).out, from_file)

    def test_no_colours_where_nobody_looks(self):
        for env in ({}, {"NO_COLOR": "1"}, {"TERM": "dumb"}):
            self.assertNotIn("\x1b", Run("solve", "none.yaml", env=env).err)

    def test_quiet_keeps_errors(self):
        self.assertIn("[E0801]", Run("--quiet", "sovle").err)
        run = self.good("--quiet", "solve", self.four_bar)
        self.assertEqual(run.err, "")


class New(Case):
    def test_every_machine_of_the_gallery_is_there_byte_for_byte(self):
        listed = re.findall(r"(?m)^  ([\w-]+)  .*: ", self.good("new").out)
        folder = os.path.join(ROOT, "examples")
        files = sorted(name[:-5] for name in os.listdir(folder) if name.endswith(".yaml"))
        self.assertEqual(sorted(listed), files)
        for name in files:
            with open(os.path.join(folder, name + ".yaml"), encoding="utf-8") as file:
                self.assertEqual(self.good("new", name).out, file.read())

    def test_another_name_is_refused_with_the_nearest(self):
        self.assertIn("four-bar", self.wrong(823, "new", "fourbar").err)


class Explain(Case):
    def test_every_listed_code_is_explained(self):
        lines = self.good("explain").out.splitlines()
        self.assertGreater(len(lines), 40)
        codes = [line.split()[0] for line in lines]
        self.assertEqual(codes, sorted(codes, key=lambda code: code[1:]))
        with open(os.path.join(ROOT, "docs", "codes.md"), encoding="utf-8") as page: # each with the letter of its severity
            self.assertEqual(codes, re.findall(r"^\| ([EWN]\d{4}) \|", page.read(), re.M))
        self.assertEqual(len(codes), len(set(codes)))
        for code in codes:
            run = self.good("explain", code)
            self.assertTrue(run.out.startswith(code + "\n"))
            self.assertGreater(len(run.out), 30)
            self.assertLessEqual(max(map(len, run.out.splitlines())), 100)

    def test_codes_are_read_kindly(self):
        full = self.good("explain", "E0801").out
        for word in ("e801", "801", "W0801", "0801"):
            self.assertEqual(self.good("explain", word).out, full)

    def test_what_is_no_code_is_refused(self):
        for word in ("E9999", "hello", "E", "-1x", "E08011111111111111111"):
            if word.startswith("-"):
                continue
            self.wrong(816, "explain", word)


class Output(Case):
    def test_o_writes_the_answer_into_a_file(self):
        shown = self.good("solve", self.four_bar, "--format", "json").out
        run = self.good("solve", self.four_bar, "--format", "json", "-o", self.path("out.json"))
        self.assertEqual(run.out, "")
        self.assertEqual(self.read("out.json").decode(), shown)

    def test_nothing_is_left_beside_the_output(self):
        before = set(os.listdir(self.folder))
        self.good("solve", self.four_bar, "-o", self.path("out.txt"))
        self.assertEqual(set(os.listdir(self.folder)), before | {"out.txt"})

    def test_a_missing_folder_is_told(self):
        self.wrong(701, "solve", self.four_bar, "-o", self.path("no/such/out.txt"))
        self.wrong(701, "draw", self.four_bar, "-o", self.path("no/such/out.svg"))

    def test_a_folder_is_no_output(self):
        self.wrong(703, "solve", self.four_bar, "-o", self.folder)

    @unittest.skipIf(os.geteuid() == 0, "root may write everywhere")
    def test_a_forbidden_folder_is_told(self):
        locked = self.path("locked")
        os.mkdir(locked)
        os.chmod(locked, stat.S_IRUSR | stat.S_IXUSR)
        self.addCleanup(os.chmod, locked, stat.S_IRWXU)
        self.wrong(702, "solve", self.four_bar, "-o", os.path.join(locked, "out.txt"))

    @unittest.skipUnless(os.path.exists("/dev/full"), "needs /dev/full")
    def test_a_full_disk_is_told(self):
        self.wrong(704, "solve", self.four_bar, "-o", "/dev/full")

    @unittest.skipUnless(os.path.exists("/dev/full"), "needs /dev/full")
    def test_a_full_standard_output_is_told(self):
        with open("/dev/full", "w", encoding="utf-8") as full:
            done = subprocess.run([YOKE, "check", self.four_bar], stdout=full, stderr=subprocess.PIPE, encoding="utf-8", check=False)
        self.assertEqual(done.returncode, 2)
        self.assertIn("[E0704]", done.stderr)

    def test_a_limit_of_the_file_size_is_told_and_leaves_nothing(self):
        """Every kind of output, cut off at 4096 bytes: the old file stands, nothing lies beside it."""
        calls = {"code.c": ["code", self.four_bar], "table.csv": ["sweep", self.four_bar, "--over", "theta1=0:360deg", "--steps", "400", "--format", "csv"],
                 "times.csv": ["simulate", os.path.join(ROOT, "examples", "double-pendulum.yaml"), "--to", "9s", "--steps", "900", "--format", "csv"],
                 "report.html": ["report", self.four_bar], "study.csv": ["study", self.four_bar, "--vary", "a=39mm:41mm:500", "--of", "theta3", "--format", "csv"]}
        for name, words in calls.items():
            with self.subTest(name):
                folder = self.path("limit-" + words[0])
                os.mkdir(folder)
                target = os.path.join(folder, name)
                self.good(*words, "-o", target)
                self.assertGreater(os.path.getsize(target), 4096)
                with open(target, "rb") as file:
                    before = file.read()
                done = subprocess.run([YOKE, *words, "-o", target], stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=False,
                                      preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (4096, 4096)))
                self.assertEqual(done.returncode, 2, done.stderr)
                self.assertIn(b"[E0704]", done.stderr)
                self.assertIn(b"larger than a file may be", done.stderr)
                self.assertEqual(set(os.listdir(folder)) - {"study.csv.partial"}, {name})  # which the study goes on from
                with open(target, "rb") as file:
                    after = file.read()
                if words[0] == "simulate":  # its lines stay, as many as there is room for
                    self.assertTrue(before.startswith(after) and after.endswith(b"\n") and len(after) > 4000)
                else:
                    self.assertEqual(after, before)

    def test_programs_that_hit_the_limit_are_told(self):
        """gnuplot and rsvg-convert end by the signal, which says so: a picture that is cut off is none."""
        for words in (["sweep", self.four_bar, "--over", "theta1=0:360deg", "--plot"], ["draw", self.four_bar, "-o"]):
            target = self.path(words[0] + ".pdf")
            if Run(*words, target).code != 0:  # not installed
                continue
            os.remove(target)
            done = subprocess.run([YOKE, *words, target], stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=False,
                                  preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (2048, 2048)))
            self.assertEqual(done.returncode, 2)
            self.assertRegex(done.stderr, b"E07(05|11)")
            self.assertFalse(os.path.exists(target))

    def test_a_failed_run_leaves_the_old_output_alone(self):
        self.write("out.txt", "what stood before")
        self.wrong(802, "solve", self.four_bar, "-o", self.path("out.txt"), "--nonsense")
        self.assertEqual(self.read("out.txt"), b"what stood before")


if __name__ == "__main__":
    unittest.main()
