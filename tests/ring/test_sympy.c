// Against SymPy, if it is installed: products and derivatives of random elements, and Lagrange's equations of the
// double pendulum, which SymPy derives by itself, compared in forty digits at two points: symbols that vanish there
// count as nothing, and expanding them took SymPy a minute. Python computes; this program only compares.
#include "ring/machines.h"
#include <unistd.h>

enum { SKIPPED = 77 };

static const char SCRIPT[] =
    "import sys\n"
    "try:\n"
    "    from sympy import *\n"
    "except ImportError:\n"
    "    sys.exit(77)\n"
    "def read(text):\n"
    "    for old, new in ((\"'\", '_d'), ('A.', 'A_'), ('^', '**')):\n"
    "        text = text.replace(old, new)\n"
    "    names = {n: Symbol(n, real=True) for n in ('I1', 's', 's1', 's2', 's3')}\n"
    "    return sympify(text, locals=names, rational=True)\n"
    "def is_zero(a):\n"
    "    for shift in (3, 8):\n"
    "        at = {x: Rational(shift + k, 7) for k, x in enumerate(sorted(a.free_symbols, key=str))}\n"
    "        if abs(a.evalf(40, subs=at)) > 1e-25: return False\n"
    "    return True\n"
    "def pendulum(line):\n"
    "    t = Symbol('t'); q = [Function('theta%d' % k)(t) for k in (1, 2)]\n"
    "    m1, m2, J1, J2, l1, lc1, lc2, g = (Symbol(n) for n in 'm1 m2 I1 I2 l1 lc1 lc2 g'.split())\n"
    "    c = [Matrix([lc1*sin(q[0]), -lc1*cos(q[0])])]\n"
    "    c.append(Matrix([l1*sin(q[0]) + lc2*sin(q[0] + q[1]), -l1*cos(q[0]) - lc2*cos(q[0] + q[1])]))\n"
    "    T = sum(m*p.diff(t).dot(p.diff(t))/2 for m, p in zip((m1, m2), c))\n"
    "    T += J1*q[0].diff(t)**2/2 + J2*(q[0] + q[1]).diff(t)**2/2\n"
    "    L = T - g*(m1*c[0][1] + m2*c[1][1])\n"
    "    k = int(line[0]) - 1\n"
    "    own = L.diff(q[k].diff(t)).diff(t) - L.diff(q[k])\n"
    "    for d, e in ((2, '_d_d'), (1, '_d'), (0, '')):\n"
    "        own = own.subs({(x.diff(t, d) if d else x): Symbol('theta%d%s' % (i + 1, e)) for i, x in enumerate(q)})\n"
    "    ours = sympify(line[1].replace(\"'\", '_d').replace('^', '**'), locals={n: Symbol(n) for n in ('I1', 'I2')})\n"
    "    return is_zero(own - ours)\n"
    "bad = 0\n"
    "for line in open(sys.argv[1]):\n"
    "    kind, *parts = line.rstrip('\\n').split('|')\n"
    "    if kind == 'pendulum':\n"
    "        good = pendulum(parts)\n"
    "    else:\n"
    "        a, b, result = (read(p) for p in parts)\n"
    "        good = is_zero((a*b if kind == 'product' else a.diff(b)) - result)\n"
    "    if not good:\n"
    "        print('SymPy disagrees:', line)\n"
    "        bad = 1\n"
    "sys.exit(bad)\n";

static void put(FILE *file, YkRing *ring, Element a, char end)
{
    YkText text = {0};
    assert_true(yk_ring_write(ring, a, YK_RING_TEXT, YK_RING_TEXTBOOK, &text));
    fprintf(file, "%s%c", yk_text_get(&text), end);
    yk_text_free(&text);
}

static void write_cases(FILE *file)
{
    Fixture f = fixture_new(1);
    for (int i = 0; i < 20; i++) {
        Element a = yk_ring_real(f.ring, random_element(&f, 2)), b = yk_ring_real(f.ring, random_element(&f, 2));
        fputs("product|", file);
        put(file, f.ring, a, '|');
        put(file, f.ring, b, '|');
        put(file, f.ring, yk_ring_multiply(f.ring, a, b), '\n');
        int32_t x = below(&f, (int)f.gravity); // a parameter: SymPy knows no chain of rates
        fputs("derivative|", file);
        put(file, f.ring, a, '|');
        put(file, f.ring, yk_ring_of(f.ring, x), '|');
        put(file, f.ring, yk_ring_partial(f.ring, a, x), '\n');
    }
    yk_ring_free(f.ring);
    Machine m = chain(2, true);
    Element T, V;
    energies(&m, &T, &V);
    for (int i = 0; i < 2; i++) {
        fprintf(file, "pendulum|%d|", i + 1);
        put(file, m.ring, lagrange(&m, T, V, i), '\n');
    }
    yk_ring_free(m.ring);
}

// A new file with this content; its name in path.
static FILE *new_file(char *path)
{
    int descriptor = mkstemp(path);
    assert_true(descriptor >= 0);
    FILE *file = fdopen(descriptor, "w");
    assert_non_null(file);
    return file;
}

static int run_python(const char *python, const char *script, const char *cases)
{
    char command[200];
    snprintf(command, sizeof command, "%s %s %s 2>&1", python, script, cases);
    FILE *pipe = popen(command, "r");
    assert_non_null(pipe);
    for (char line[2000]; fgets(line, sizeof line, pipe);) print_error("%s", line);
    int status = pclose(pipe);
    return status >= 0 && status % 256 == 0 ? status / 256 : 1;
}

static void sympy_finds_the_same(void **state)
{
    (void)state;
    static const char *const pythons[] = {"/usr/bin/python3", "python3"};
    char script[] = "/tmp/yoke-script-XXXXXX", cases[] = "/tmp/yoke-cases-XXXXXX";
    FILE *file = new_file(script);
    fputs(SCRIPT, file);
    fclose(file);
    file = new_file(cases);
    write_cases(file);
    fclose(file);
    int outcome = SKIPPED;
    for (size_t i = 0; i < 2 && (outcome == SKIPPED || outcome == 127); i++)
        outcome = run_python(pythons[i], script, cases);
    unlink(script);
    unlink(cases);
    if (outcome == SKIPPED || outcome == 127) skip();
    assert_int_equal(outcome, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sympy_finds_the_same),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
