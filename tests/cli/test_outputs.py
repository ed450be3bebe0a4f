"""What the command writes does not depend on the compiler that built it: the same bytes from every build of these sources.

Each build leaves the hashes of its answers in outputs.txt of its folder (YOKE_BUILD) and compares them with those that other
builds of the same sources left beside it. The first to run has nothing to compare with; in `tools/test` clang's is compared
with gcc's, whichever comes first."""
import glob
import hashlib
import os
import unittest

from harness import ROOT, Run

BUILD = os.environ["YOKE_BUILD"]
VERBS = ["check", "solve --format json", "code", "code --single", "derive", "derive --numbers --format json",
         "derive --format latex", "derive --format mathml", "derive --format c", "report", "draw", "gears",
         "gears --format json", "cam", "cam --format json"]
SOURCES = ["CMakeLists.txt", "cmake", "include", "src", "apps", "web/report/src", "examples", "tests/cli/test_outputs.py"]


def files(path):
    if os.path.isfile(path):
        return [path]
    return sorted(os.path.join(folder, name) for folder, _, names in os.walk(path) for name in names)


def sources():
    """Of all that decides what the command writes."""
    whole = hashlib.sha256()
    for path in SOURCES:
        for name in files(os.path.join(ROOT, path)):
            with open(name, "rb") as file:
                whole.update(b"%s %s" % (os.path.relpath(name, ROOT).encode(), hashlib.sha256(file.read()).digest()))
    return whole.hexdigest()


def answers():
    """Of every verb on every example, by what was asked: the hash of all that it said, and its exit code."""
    found = {}
    for path in sorted(glob.glob(os.path.join(ROOT, "examples", "*.yaml"))):
        example = os.path.relpath(path, ROOT)
        for verb in VERBS:
            run = Run(*verb.split(), example, cwd=ROOT)
            found["%s %s" % (verb, example)] = hashlib.sha256(("%d\n%s\n%s" % (run.code, run.out, run.err)).encode()).hexdigest()
    return found


def write(path, key, found):
    with open(path, "w", encoding="utf-8") as file:
        file.write("sources %s\n" % key)
        file.writelines("%s %s\n" % (value, name) for name, value in found.items())


def read(path, key):
    """None where another state of the sources was built."""
    with open(path, encoding="utf-8") as file:
        head, *lines = file.read().splitlines()
    return {line.split(" ", 1)[1]: line.split(" ", 1)[0] for line in lines} if head == "sources " + key else None


def differences(own, other):
    return sorted(name for name in own.keys() | other.keys() if own.get(name) != other.get(name))


class Outputs(unittest.TestCase):
    def test_every_build_of_these_sources_writes_the_same(self):
        key, found, beside = sources(), answers(), os.path.join(BUILD, "..", "*", "outputs.txt")
        own = os.path.abspath(os.path.join(BUILD, "outputs.txt"))
        write(own, key, found)
        compared = 0
        for path in sorted(glob.glob(beside)):
            other = None if os.path.abspath(path) == own else read(path, key)
            if other is None:
                continue
            compared += 1
            self.assertEqual(differences(found, other), [], "the build of %s writes others" % os.path.dirname(path))
        print("compared with %d other build%s" % (compared, "" if compared == 1 else "s"))

    def test_a_difference_is_seen(self):
        self.assertEqual(differences({"a": "1", "b": "2"}, {"a": "1", "b": "2"}), [])
        self.assertEqual(differences({"a": "1", "b": "2"}, {"a": "1", "b": "3", "c": "4"}), ["b", "c"])
        path = os.path.join(BUILD, "outputs-test.txt")
        write(path, "key", {"code examples/a.yaml": "12"})
        self.assertEqual(read(path, "key"), {"code examples/a.yaml": "12"})
        self.assertIsNone(read(path, "another"))
        os.remove(path)


if __name__ == "__main__":
    unittest.main()
