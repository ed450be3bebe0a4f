"""The wheel is built without a network, holds the library, and works by itself; the types are right."""
import os
import shutil
import subprocess
import sys
import zipfile

import pytest
from conftest import CRANK, ROOT

pytest.importorskip("build.__main__")


def run(*words, **more):
    done = subprocess.run([sys.executable, *map(str, words)], capture_output=True, text=True, **more)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


@pytest.fixture(scope="module")
def wheel(tmp_path_factory):
    work = tmp_path_factory.mktemp("wheel")
    leave = shutil.ignore_patterns("*.so", "build", "*.egg-info", "dist")
    shutil.copytree(ROOT / "python", work / "python", ignore=leave)
    environment = {**os.environ, "YOKE_INCLUDE": str(ROOT / "include"), "YOKE_LIBRARY": os.environ["YOKE_ARCHIVE"],
                   "CFLAGS": "-O1", "PIP_NO_INDEX": "1", "no_proxy": "*"}
    environment.pop("PYTHONPATH")
    run("-m", "build", "--wheel", "--no-isolation", "--outdir", work, work / "python", env=environment)
    return next(work.glob("*.whl"))


def test_a_wheel_holds_the_package_with_its_types(wheel):
    assert wheel.name.startswith("yoke-") and "-cp39-abi3-linux" in wheel.name
    names = set(zipfile.ZipFile(wheel).namelist())
    modules = {f"yoke/{p.name}" for p in (ROOT / "python" / "yoke").iterdir() if p.suffix in (".py", ".pyi")}
    assert modules | {"yoke/py.typed", "yoke/_native.abi3.so"} <= names


def test_a_wheel_works_without_the_library_beside_it(wheel, tmp_path):
    run("-m", "pip", "install", "-q", "--no-index", "--no-deps", "--target", tmp_path / "site", wheel)
    environment = {k: v for k, v in os.environ.items() if not k.startswith(("PYTHONPATH", "LD_"))}
    program = f"import yoke; print(yoke.__file__, yoke.parse({CRANK!r}).solve(theta=1.0)['s'])"
    out = run("-c", program, env={**environment, "PYTHONPATH": str(tmp_path / "site")}, cwd=tmp_path)
    assert out.startswith(str(tmp_path)) and 0.19 < float(out.split()[1]) < 0.21


def test_mypy_finds_nothing(tmp_path):
    pytest.importorskip("mypy")
    user = tmp_path / "user.py"
    user.write_text("import yoke\nx: float = yoke.load('a').solve(theta='30 deg').coordinates['s'].position\n"
                    "b: bool = bool(yoke.load('a').check('a = b'))\n")
    run("-m", "mypy", "--strict", "--cache-dir", tmp_path, ROOT / "python" / "yoke", user,
        env={**os.environ, "MYPYPATH": str(ROOT / "python")})


def test_the_import_takes_no_more_modules_than_it_needs():
    heavy = {"matplotlib", "pandas", "tqdm", "IPython", "concurrent.futures.thread", "difflib", "cffi"}
    program = "import sys, numpy; old = set(sys.modules); import yoke; print(*sorted(set(sys.modules) - old))"
    loaded = run("-c", program)
    assert not heavy & set(loaded.split())
