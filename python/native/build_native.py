"""Makes the extension module `yoke._native` (cffi, API mode) from the public headers and from host.c.

    python3 build_native.py OUTPUT.c     writes its C source, for CMake
    setup.py takes `ffibuilder`          for wheels

The declarations come from include/yoke, so the module has every public function; the C compiler compares each of
them with the header again.
"""
from __future__ import annotations

import os
import re
import sys
from pathlib import Path

import cffi

HERE = Path(__file__).resolve().parent
INCLUDE = Path(os.environ.get("YOKE_INCLUDE", HERE.parent.parent / "include"))
if not (INCLUDE / "yoke" / "yoke.h").exists():  # a wheel made beside an installed library
    INCLUDE = Path("/usr/include")


def headers() -> list[Path]:
    """Returns the public headers in the order in which yoke.h includes them."""
    names = re.findall(r"#include <yoke/(\w+\.h)>", (INCLUDE / "yoke" / "yoke.h").read_text())
    return [INCLUDE / "yoke" / name for name in names]


def declarations(header: Path) -> str:
    """Returns the part of a header that cffi can read: no comments, preprocessor lines or inline functions."""
    text = re.sub(r"//[^\n]*", "", header.read_text())
    text = re.sub(r"^\s*#[^\n]*(\\\n[^\n]*)*", "", text, flags=re.M)
    text = re.sub(r'extern "C" \{(.*)\}', r"\1", text, flags=re.S)
    text = re.sub(r"static inline [^{;]*\{[^}]*\}", "", text)
    return text.replace("YK_API ", "")


def included(header: Path) -> list[Path]:
    """Returns a header and those that it includes, itself last."""
    found: list[Path] = []
    for name in re.findall(r"#include <yoke/(\w+\.h)>", header.read_text()):
        found += [h for h in included(INCLUDE / "yoke" / name) if h not in found]
    return [*found, header]


def in_order() -> list[Path]:
    """Returns all headers, each after those that it includes."""
    found: list[Path] = []
    for header in headers():
        found += [h for h in included(header) if h not in found]
    return found


ffibuilder = cffi.FFI()
ffibuilder.cdef("#define YK_NOT_FOUND ...\nstatic char *const YOKE_VERSION_STRING;\n")
for one in in_order():
    ffibuilder.cdef(declarations(one))
ffibuilder.cdef(declarations(HERE / "host.h"))
ffibuilder.cdef('extern "Python+C" bool yk_host_ask(double part);')
ffibuilder.cdef('extern "Python+C" bool yk_host_visit(void *context, YkState *state);')
ffibuilder.cdef('extern "Python+C" bool yk_host_control(void *context, YkSimulation *simulation, double time);')


def libraries() -> dict[str, list[str]]:
    """Returns the link options: YOKE_LIBRARY names libyoke.a (all inside the wheel) or libyoke.so; otherwise -lyoke."""
    library = os.environ.get("YOKE_LIBRARY", "")
    if library.endswith(".a"):
        return {
            "extra_objects": [library],
            "libraries": ["yaml", "m", "pthread"],
            "extra_link_args": ["-Wl,--exclude-libs,ALL"],
        }
    if library:
        folder = str(Path(library).resolve().parent)
        return {"libraries": ["yoke"], "library_dirs": [folder], "runtime_library_dirs": [folder]}
    return {"libraries": ["yoke"]}


ffibuilder.set_source(
    "yoke._native",
    (HERE / "host.h").read_text() + (HERE / "host.c").read_text().replace('#include "host.h"\n', ""),
    include_dirs=[str(INCLUDE)],
    define_macros=[("_POSIX_C_SOURCE", "200809L"), ("Py_LIMITED_API", "0x03070000")],
    py_limited_api=True,
    **libraries(),
)

if __name__ == "__main__":
    ffibuilder.emit_c_code(sys.argv[1])
