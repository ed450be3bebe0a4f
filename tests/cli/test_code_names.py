"""yoke code: names of a model that mean something else in C, in C++, in their headers or in the printed file itself."""
import os
import re
import shutil
import subprocess
import unittest

from test_code import CC, WARNINGS, Printed

# ISO/IEC 9899:2011 and 9899:2024, 6.4.1; ISO/IEC 14882:2023, [lex.key] and [lex.digraph]; and GNU's.
KEYWORDS = """auto break case char const continue default do double else enum extern float for goto if inline int long register
restrict return short signed sizeof static struct switch typedef union unsigned void volatile while _Alignas _Alignof _Atomic
_Bool _Complex _Generic _Imaginary _Noreturn _Static_assert _Thread_local alignas alignof bool constexpr false nullptr
static_assert thread_local true typeof typeof_unqual _BitInt _Decimal128 _Decimal32 _Decimal64 asm catch char8_t char16_t
char32_t class concept consteval constinit const_cast co_await co_return co_yield decltype delete dynamic_cast explicit export
friend mutable namespace new noexcept operator private protected public reinterpret_cast requires static_cast template this
throw try typeid typename using virtual wchar_t and and_eq bitand bitor compl not not_eq or or_eq xor xor_eq""".split()
# What the issue names, functions that the printed file calls, names that are reserved, types; odd underscores.
OTHERS = """NULL NAN INFINITY HUGE_VAL linux unix M_PI pow fabs fmin fmax fmod sqrtf sinf powf copysign memcpy printf size_t uint64_t
_Exit __LINE__ __func__ a__b c_ d__ _e __ machine p m c in out i k n x q x_B known status margin witness finite system miss
residual jacobian name_NULL name_linux none kinetic potential""".split()
REFUSED = {"t", "pi", "sin", "cos", "tan", "asin", "acos", "atan", "atan2", "sinh", "cosh", "tanh", "sqrt", "exp", "log", "abs",
           "sign", "min", "max"} # yoke's own, E0406
HEADERS = "#include <stddef.h>\n#include <math.h>\n#include <stdint.h>\n#include <string.h>\n#include <stdio.h>\n"


def available(*commands):
    return [command for command in commands if shutil.which(command.split()[0])]


def macros():
    """What compilers and the headers of the printed file define, but for the names that begin with an underscore."""
    found = set()
    for command in available(CC + " -std=c11", CC + " -std=gnu17", "gcc -std=gnu17", "clang -std=gnu17", "g++ -std=gnu++17 -x c++"):
        done = subprocess.run([*command.split(), "-dM", "-E", *(["-x", "c"] if "c++" not in command else []), "-"],
                              input=HEADERS, capture_output=True, encoding="utf-8", check=True)
        found |= set(re.findall(r"(?m)^#define ([A-Za-z]\w*)", done.stdout))
    return found


def words(body):
    """All of them, and what a printed file defines for itself."""
    own = set(re.findall(r"\bm_\w+", body))
    return [word for word in sorted(set(KEYWORDS) | set(OTHERS) | macros() | own) if word not in REFUSED]


# Parameters that stand alone, and others that follow from them; each is used.
def parameters(names, follows):
    return "\n".join(["parameters:", *(["  base_length: 1.5 m"] if follows else []),
                      *["  %s: %s" % (name, "base_length + %d mm" % k if follows else "%d mm" % (1000 + k))
                        for k, name in enumerate(names)],
                      "bodies:", "  ground: {points: {O: [0, 0]}}", "  arm: {points: {O: [0, 0], %s}}" % ", ".join(
                          "P%d: [%s, 0]" % (k, " + ".join(names[k:k + 20])) for k in range(0, len(names), 20)),
                      "joints: {O: {pin: [ground, arm], angle: theta}}", "start: {theta: 0.5}", ""])


# A pin for each word: of its angle, and of its joint, body and point.
def coordinates(names):
    return "\n".join(["bodies:", "  ground: {points: {O: [0, 0]}}",
                      *["  b%d: {points: {O: [0, 0]}}" % k for k in range(len(names))], "joints:",
                      *["  J%d: {pin: [ground, b%d], at: O, angle: %s}" % (k, k, name) for k, name in enumerate(names)],
                      "start: {%s}" % ", ".join("%s: %d mrad" % (name, 10 * k) for k, name in enumerate(names)), ""])


def bodies(names):
    return "\n".join(["bodies:", "  ground: {points: {O: [0, 0]}}",
                      *["  %s: {points: {O: [0, 0], %s: [0.1, %d mm]}}" % (name, name, k) for k, name in enumerate(names)],
                      "joints:", *["  %s: {pin: [ground, %s], at: O, angle: q%d}" % (name, name, k) for k, name in enumerate(names)],
                      "start: {%s}" % ", ".join("q%d: %d mrad" % (k, 10 * k) for k in range(len(names))), ""])


# A four-bar of which all names are words: labels of blocks, angles and bodies that come out near to a place, laws.
FOUR_BAR = """\
gravity: [0, -9.81]
parameters: {%(a)s: 0.4, %(b)s: 2 * %(a)s}
bodies:
  ground: {points: {O: [0, 0], C: [1, 0]}}
  %(a)s: {points: {O: [0, 0], %(c)s: [%(a)s, 0]}, mass: 1, inertia: 0.1}
  %(b)s: {points: {%(c)s: [0, 0], %(d)s: [1.2, 0]}, mass: 2, inertia: 0.3}
  %(c)s: {points: {C: [0, 0], %(d)s: [%(b)s, 0]}, mass: 1, inertia: 0.2}
joints:
  %(a)s: {pin: [ground, %(a)s], at: O, angle: %(c)s}
  %(b)s: {pin: [%(a)s, %(b)s], at: %(c)s, angle: %(d)s}
  %(c)s: {pin: [ground, %(c)s], at: C, angle: %(e)s}
  %(d)s: {pin: [%(b)s, %(c)s]}
laws:
  %(e)s: {period: 2*pi, segments: [{rise: {to: 3 rad, by: 0.3 rad, law: 3-4-5}}, {fall: {to: 2*pi, by: 0.3 rad, law: cycloidal}}]}
drives: {%(c)s: {law: %(e)s, of: 1 rad/s * t}}
start: {%(d)s: -0.3, %(e)s: 1.5}
"""

# Members that would have one name: rates of one coordinate and another of that name, points, places that angles are near to.
TWICE = """\
gravity: [0, -9.81]
bodies:
  ground: {points: {O: [0, 0], C: [1, 0], D: [0, 3]}}
  a: {points: {O: [0, 0], b_c: [0.4, 0]}, mass: 1, inertia: 0.1}
  a_b: {points: {b_c: [0, 0], c: [1.2, 0]}, mass: 2, inertia: 0.3}
  rocker: {points: {C: [0, 0], c: [0.8, 0]}, mass: 1, inertia: 0.2}
  u: {points: {D: [0, 0], P: [1, 0]}, mass: 1, inertia: 0.1}
  v-w: {points: {P: [0, 0], Q: [1, 0]}, mass: 1, inertia: 0.1}
  v_w: {points: {Q: [0, 0], R: [1, 0]}, mass: 1, inertia: 0.1}
  wheel: {points: {R: [0, 0]}, mass: 1, inertia: 0.1}
joints:
  near_c: {pin: [ground, a], at: O, angle: q}
  a_force_x: {pin: [a, a_b], at: b_c, angle: c}
  near-c: {pin: [ground, rocker], at: C, angle: c_rate}
  a: {pin: [a_b, rocker], at: c}
  D: {pin: [ground, u], angle: q_rate}
  P: {pin: [u, v-w], angle: q_rate_rate}
  Q: {pin: [v-w, v_w], angle: q_effort}
  R: {pin: [v_w, wheel], angle: q_accel}
start: {q: 0.7, c: -0.3, c_rate: 1.5, q.rate: 1, q_rate.rate: 2, q_rate: 0.3, q_rate_rate: 0.2, q_effort: 0.5, q_accel: 0.4}
"""


class Names(Printed):
    def look_at(self, code, name):
        """By every compiler, in the standard's dialect and GNU's; the declarations in C++."""
        source = self.write(name + ".c", code)
        user = self.write(name + ".cc", '#define m_DECLARATIONS_ONLY\n#include "%s.c"\nint main() { return m_OK; }\n' % name)
        tries = [[CC, *WARNINGS, "-Dm_TEST", "-fsyntax-only", source]]
        tries += [[*command.split(), "-w", "-Dm_TEST", "-fsyntax-only", source]
                  for command in available("gcc -std=gnu17", "clang -std=gnu17", "clang -std=c2x")]
        tries += [[*command.split(), "-Wall", "-Wextra", "-Werror", "-fsyntax-only", user]
                  for command in available("g++ -std=gnu++17", "clang++ -std=gnu++20")]
        for words_of_it in tries:
            done = subprocess.run(words_of_it, capture_output=True, encoding="utf-8", cwd=self.folder, check=False)
            self.assertEqual(done.returncode, 0, "%s\n%s" % (" ".join(words_of_it), done.stderr[:3000]))

    def check(self, name, model, *options):
        code = self.print(self.write(name + ".yaml", model), *options)
        self.look_at(code, name)
        self.assertEqual(self.run_test(code, "1e-11", name=name).stdout, "m: well\n", name)

    def look(self, name, model):
        self.look_at(self.print(self.write(name + ".yaml", model), "--kinematics"), name)

    def test_words_of_c_are_names(self):
        names = words(self.print(self.write("m.yaml", FOUR_BAR % dict(zip("abcde", "ABCDE")))))
        self.assertGreater(len(names), 300)
        self.look("own", parameters(names, False))
        self.look("follows", parameters(names, True))
        many = re.compile(r"_(PI|2|4|SQRT\w+|E|LN\w+|LOG\w+)[fl]\w*$|(LEAST|FAST)\d|(F|f)(32|64|128)") # of a kind with others
        names = [name for name in names if not many.search(name)]
        self.look("coordinates", coordinates(names))
        self.look("bodies", bodies([name for name in names if name != "ground"]))

    def test_loops_of_such_names(self):
        for names in (["NULL", "linux", "pow", "_Bool", "M_PI"], ["name_x", "x_", "_x", "x__", "name_x_2"],
                      ["m_TEST", "m_root", "p", "machine", "m_law_x"]):
            self.check("loop", FOUR_BAR % dict(zip("abcde", names)))

    def test_no_two_members_have_one_name(self):
        self.check("twice", TWICE)

    def test_ordinary_names_stay(self):
        code = self.print(self.write("m.yaml", parameters(["L_1", "A", "I", "sun", "M_1", "F_max", "E", "BC_C"], False)))
        for name in ("L_1", "A", "I", "M_1", "F_max", "E", "BC_C"):
            self.assertIn("double %s;" % name, code)
        code = self.print(self.write("m.yaml", parameters(["NULL", "_Bool", "x_"], False)))
        for name in ("name_NULL", "name_Bool", "name_x"):
            self.assertIn("double %s;" % name, code)

    def test_the_machines_name_stays_in_its_comment(self):
        for name in ("a */ b", "/* a", "a /*/ b", "a **/ /** b"):
            code = self.print(self.write("m.yaml", "name: '%s'\n" % name + coordinates(["q"])))
            self.look_at(code, "comment")


if __name__ == "__main__":
    unittest.main()
