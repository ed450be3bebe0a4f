#!/usr/bin/env python3
"""Every verb answers every example with the bytes of which golden.txt has a hash: with any compiler, optimisation and C library.

Usage: tests/bits/golden.py YOKE              says which answers differ; ends with 1 where one does
       tests/bits/golden.py YOKE --update     writes golden.txt again, after a change that is meant to change answers; say why in the
                                              commit
       tests/bits/golden.py YOKE --show WORD  prints the answers whose line has this word, to compare two builds

       tests/bits/golden.py YOKE --sample N   tries one line of N, all of them with YOKE_FULL=1

A line is the first 16 digits of the SHA-256 of exit code, standard output and standard error, then the command. With YOKE_FEW=1 one
line of eight is tried. The script of the report's page is left out: other tools make it.
"""
import concurrent.futures
import glob
import hashlib
import os
import re
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
GOLDEN = os.path.join(os.path.dirname(os.path.abspath(__file__)), "golden.txt")
BUNDLE = re.compile(rb"<script>.*?</script>", re.S)

# Of every example.
VERBS = ["check", "check --format json", "solve", "solve --format json --all", "solve --format json --time 0.3 --method newton-euler",
         "sweep --over t=0:1s --steps 12 --format json", "simulate --to 0.2s --steps 4 --format json", "rest --modes --starts 4 --format json",
         "draw", "gears --format json", "cam --format json", "derive", "derive --numbers --format json", "derive --format latex",
         "derive --format mathml", "derive --format c", "code", "code --single", "report"]
# What asks for names.
ALONE = ["new", "new four-bar", "explain E0300", "gears examples/gearbox-8hp70.yaml --in input --out output", "gears examples/epicyclic.yaml",
         "cam examples/cep-cam.yaml --compare cycloidal,modified-sine,3-4-5,4-5-6-7", "cam examples/valve-cam.yaml",
         "cam examples/cep-cam.yaml --limits pressure=30deg,curvature=5mm",
         "study examples/four-bar.yaml --vary b=110mm:130mm:5 --over theta2=0:360deg --of theta4,coupler.P.y --format json",
         "study examples/four-bar.yaml --vary b=110mm:130mm:3 --sensitivities --of theta4,coupler.P.y --format json",
         "sweep examples/quick-return.yaml --over theta1=0:180deg --of d5,d5.rate,d5.accel,A.force.x --format csv",
         "draw examples/quick-return.yaml --over theta1=0:180deg --poses 9 --trace ram.C",
         "map examples/four-bar.yaml --over theta4", "map examples/jansen.yaml --format json", "map examples/stephenson-awkward.yaml --format json",
         "map examples/parallelogram.yaml --format json", "map examples/non-grashof.yaml --over theta4 --reach theta4=100deg --format json",
         "simulate examples/double-pendulum.yaml --to 2s --every 0.5s --of theta1,theta2,energy --format json",
         "simulate examples/andrews.yaml --to 0.01s --steps 5 --method sdirk4 --format json",
         "derive examples/quick-return.yaml --check 'l1*cos(theta1) - d3*cos(theta2) = 0'"]


def commands():
    examples = sorted(glob.glob(os.path.join(ROOT, "examples", "*.yaml")))
    lines = ["%s %s" % (verb, os.path.relpath(path, ROOT)) for path in examples for verb in VERBS]
    return ALONE + lines


def answer(yoke, command):
    words = [word.strip("'") for word in re.findall(r"'[^']*'|\S+", command)]
    done = subprocess.run([yoke, *words], cwd=ROOT, stdin=subprocess.DEVNULL, capture_output=True, check=False,
                          env={**os.environ, "NO_COLOR": "1", "LC_ALL": "C"})
    if command.startswith("report") and b"<script>" not in done.stdout:
        return None  # built without the page's script: other pages
    out = BUNDLE.sub(b"", done.stdout) if command.startswith("report") else done.stdout
    return b"%d\n%s\n%s" % (done.returncode, out, done.stderr)


def hashed(yoke, lines):
    with concurrent.futures.ThreadPoolExecutor(int(os.environ.get("YOKE_JOBS", os.cpu_count() or 2))) as pool:
        answers = pool.map(lambda line: answer(yoke, line), lines)
        return {line: hashlib.sha256(said).hexdigest()[:16] for line, said in zip(lines, answers) if said is not None}


def main():
    yoke, lines = os.path.abspath(sys.argv[1]), commands()
    if "--show" in sys.argv:
        for line in lines:
            if sys.argv[-1] in line:
                print("== %s\n%s" % (line, answer(yoke, line).decode()))
        return 0
    if "--update" in sys.argv:
        with open(GOLDEN, "w", encoding="utf-8") as file:
            file.writelines("%s %s\n" % (value, line) for line, value in hashed(yoke, lines).items())
        return 0
    with open(GOLDEN, encoding="utf-8") as file:
        golden = dict(reversed(line.rstrip("\n").split(" ", 1)) for line in file)
    wrong = sorted(set(golden) ^ set(lines))
    every = int(sys.argv[sys.argv.index("--sample") + 1]) if "--sample" in sys.argv else 1
    if os.environ.get("YOKE_FEW"):
        every = 8
    lines = lines[::1 if os.environ.get("YOKE_FULL") else every]
    wrong += [line for line, value in hashed(yoke, lines).items() if golden.get(line, value) != value]
    for line in wrong:
        print("differs: yoke %s" % line)
    print("%d answers tried, %d differ" % (len(lines), len(wrong)))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
