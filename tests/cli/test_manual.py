"""Help is the truth; man pages and completions must know every verb and option that it lists."""
import os
import re
import shutil
import subprocess
import unittest

from harness import Case, ROOT

VERBS = ["check", "solve", "sweep", "study", "simulate", "rest", "draw", "gears", "cam", "derive", "report", "new", "explain", "synthesize", "map", "cognates", "balance"]


def read(*path):
    with open(os.path.join(ROOT, *path), encoding="utf-8") as file:
        return file.read()


class Manual(Case):
    def options(self, verb):
        found = re.findall(r"(?m)^  (?:-\w, )?(--[\w-]+)", self.good(verb, "--help").out)
        self.assertIn("--help", found)
        return found

    def test_every_option_stands_in_its_man_page(self):
        for verb in VERBS:
            page = read("man", "yoke-%s.1.scd" % verb)
            for option in self.options(verb):
                self.assertIn("*%s*" % option, page, verb)

    def test_man_pages_name_no_option_that_is_not_there(self):
        for verb in VERBS:
            known = set(self.options(verb))
            self.assertEqual(set(re.findall(r"(?m)^\*(--[\w-]+)\*", read("man", "yoke-%s.1.scd" % verb))) - known, set())

    def test_every_verb_stands_in_the_main_page(self):
        page = read("man", "yoke.1.scd")
        for verb in VERBS:
            self.assertIn("*%s*" % verb, page)

    @unittest.skipUnless(shutil.which("scdoc"), "needs scdoc")
    def test_all_man_pages_compile(self):
        pages = [name for name in os.listdir(os.path.join(ROOT, "man")) if name.endswith(".scd")]
        self.assertGreaterEqual(len(pages), 6)
        for name in pages:
            done = subprocess.run(["scdoc"], input=read("man", name), capture_output=True, encoding="utf-8", check=False)
            self.assertEqual(done.returncode, 0, name + ": " + done.stderr)

    def test_completions_ask_the_command(self):
        for name in ("yoke.bash", "_yoke", "yoke.fish"):
            self.assertIn("--help", read("completions", name))

    @unittest.skipUnless(shutil.which("bash"), "needs bash")
    def test_bash_completes_verbs_and_their_options(self):
        script = 'source "$1"; COMP_WORDS=(yoke "${@:2}"); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _yoke; echo "${COMPREPLY[@]}"'
        file = os.path.join(ROOT, "completions", "yoke.bash")

        def complete(*words):
            path = os.path.dirname(os.environ["YOKE"]) + os.pathsep + os.environ["PATH"]
            done = subprocess.run(["bash", "-c", script, "bash", file, *words], capture_output=True, encoding="utf-8", check=True,
                                  env=dict(os.environ, PATH=path))
            return done.stdout.split()

        self.assertEqual(complete("sw"), ["sweep"])
        self.assertEqual(complete("sweep", "--st"), ["--steps"])
        self.assertEqual(complete("solve", "--st"), [])
        self.assertEqual(complete("solve", "x.yaml", "--format", "j"), ["json"])
        for verb in VERBS:
            self.assertEqual(set(complete(verb, "--")), set(self.options(verb)))


if __name__ == "__main__":
    unittest.main()
