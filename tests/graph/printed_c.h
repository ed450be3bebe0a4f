// Reads and computes the C that the printer writes: declarations with one expression each, sines in pairs, values of
// the machine, and calls of laws as these tests print them.
#ifndef TESTS_GRAPH_PRINTED_C_H
#define TESTS_GRAPH_PRINTED_C_H
#include <ctype.h>
#include "graph/graph_check.h"

enum { PRINTED_NAMES = 2000, PRINTED_LENGTH = 40 };

typedef struct Printed {
    const char *at;    // where it reads
    bool is_twice;     // in the angle of a sine and a cosine: what it reads is used by both
    size_t operations; // read so far; those that a pose does
    size_t count;
    struct {
        char name[PRINTED_LENGTH];
        double is;
        size_t uses, weight; // weight: operations in its declaration
        bool is_pair;        // one of a sine and a cosine
    } names[PRINTED_NAMES];
} Printed;

static inline double printed_sum(Printed *p);

static inline void printed_expect(Printed *p, const char *text)
{
    size_t n = strlen(text);
    if (strncmp(p->at, text, n) != 0) print_error("expected `%s` at `%.60s`\n", text, p->at);
    assert_true(strncmp(p->at, text, n) == 0);
    p->at += n;
}

static inline bool printed_take(Printed *p, const char *text)
{
    size_t n = strlen(text);
    bool is_there = strncmp(p->at, text, n) == 0;
    if (is_there) p->at += n;
    return is_there;
}

static inline void printed_blank(Printed *p)
{
    while (*p->at == ' ' || *p->at == '\n') p->at++;
}

// Reads a name: letters, digits, `m->` before and an index behind it.
static inline void printed_name(Printed *p, char *name)
{
    size_t n = 0;
    for (; isalnum(*p->at) || strchr("_[]", *p->at) || strncmp(p->at, "->", 2) == 0 || (n > 0 && name[n - 1] == '-');) {
        if (!*p->at) break;
        assert_true(n + 1 < PRINTED_LENGTH);
        name[n++] = *p->at++;
    }
    name[n] = 0;
    assert_true(n > 0);
}

// Nothing is declared twice.
static inline void printed_declare(Printed *p, const char *name, double is, size_t before)
{
    for (size_t k = 0; k < p->count; k++) {
        if (strcmp(p->names[k].name, name) == 0) print_error("%s is declared twice\n", name);
        assert_true(strcmp(p->names[k].name, name) != 0);
    }
    assert_true(p->count < PRINTED_NAMES);
    strcpy(p->names[p->count].name, name);
    p->names[p->count].uses = 0;
    p->names[p->count].weight = p->operations - before;
    p->names[p->count].is_pair = false;
    p->names[p->count++].is = is;
}

static inline double printed_call(Printed *p, const char *name, double a, double b)
{
    static const struct {
        const char *name;
        YkFunction function;
    } functions[] = {{"sin", YK_SIN},     {"cos", YK_COS},     {"tan", YK_TAN},   {"asin", YK_ASIN},
                     {"acos", YK_ACOS},   {"atan", YK_ATAN},   {"sinh", YK_SINH}, {"cosh", YK_COSH},
                     {"tanh", YK_TANH},   {"sqrt", YK_SQRT},   {"exp", YK_EXP},   {"log", YK_LOG},
                     {"log10", YK_LOG10}, {"atan2", YK_ATAN2}, {"fabs", YK_ABS},  {"P_sign", YK_SIGN},
                     {"fmin", YK_MIN},    {"fmax", YK_MAX}};
    static const struct {
        const char *name;
        YkValueKind op;
    } helpers[] = {{"pow", YK_VALUE_POWER},         {"P_root", YK_VALUE_ROOT},      {"P_per_root", YK_VALUE_PER_ROOT},
                   {"P_nonzero", YK_VALUE_NONZERO}, {"P_least", YK_VALUE_LEAST},    {"P_largest", YK_VALUE_LARGEST},
                   {"P_angle", YK_VALUE_ANGLE},     {"P_nearest", YK_VALUE_NEAREST}};
    p->operations++;
    for (size_t k = 0; k < sizeof functions / sizeof *functions; k++)
        if (strcmp(name, functions[k].name) == 0) return graph_function(functions[k].function, a, b);
    for (size_t k = 0; k < sizeof helpers / sizeof *helpers; k++)
        if (strcmp(name, helpers[k].name) == 0) return graph_operate(&(YkValue){.op = helpers[k].op}, a, b, 0);
    print_error("what is %s?\n", name);
    fail();
    return 0;
}

static inline double printed_primary(Printed *p)
{
    char name[PRINTED_LENGTH];
    printed_blank(p);
    if (printed_take(p, "(")) {
        double a = printed_sum(p);
        if (printed_take(p, " < 0 ? ")) {
            double b = printed_sum(p);
            printed_expect(p, " : ");
            double c = printed_sum(p);
            a = a < 0 ? b : c;
            p->operations++;
        }
        printed_expect(p, ")");
        return a;
    }
    if (isdigit(*p->at)) {
        char *end;
        double number = strtod(p->at, &end);
        assert_true(memchr(p->at, '.', (size_t)(end - p->at)) || memchr(p->at, 'e', (size_t)(end - p->at)));
        p->at = end;
        return number;
    }
    printed_name(p, name);
    if (printed_take(p, "(")) {
        double a = printed_sum(p), b = printed_take(p, ",") ? printed_sum(p) : 0;
        printed_expect(p, ")");
        return printed_call(p, name, a, b);
    }
    for (size_t k = 0; k < p->count; k++)
        if (strcmp(p->names[k].name, name) == 0) {
            p->names[k].uses += p->is_twice ? 2 : 1;
            return p->names[k].is;
        }
    print_error("%s is not declared\n", name);
    fail();
    return 0;
}

static inline double printed_signed(Printed *p)
{
    printed_blank(p);
    return printed_take(p, "-") ? -printed_signed(p) : printed_primary(p);
}

static inline char printed_operator(Printed *p, char first, char second)
{
    char op = p->at[0] == ' ' && p->at[1] && p->at[2] == ' ' ? p->at[1] : 0;
    if (op != first && op != second) return 0;
    p->at += 3;
    p->operations++;
    return op;
}

static inline double printed_product(Printed *p)
{
    double a = printed_signed(p);
    for (char op; (op = printed_operator(p, '*', '/'));) {
        double b = printed_signed(p);
        a = op == '*' ? a * b : a / b;
    }
    return a;
}

static inline double printed_sum(Printed *p)
{
    double a = printed_product(p);
    for (char op; (op = printed_operator(p, '+', '-'));) {
        double b = printed_product(p);
        a = op == '+' ? a + b : a - b;
    }
    return a;
}

static inline double printed_value(Printed *p, const char *text)
{
    p->at = text;
    double value = printed_sum(p);
    assert_true(*p->at == 0);
    return value;
}

// Joins lines that were broken at a blank.
static inline void printed_join(char *text)
{
    static const char broken[] = "\n        ";
    for (char *at; (at = strstr(text, broken)); memmove(at + 1, at + strlen(broken), strlen(at + strlen(broken)) + 1))
        *at = ' ';
}

// Runs statements, whose lines it joins. `type`: of variables.
static inline void printed_run(Printed *p, char *text, const char *type)
{
    char name[PRINTED_LENGTH], cosine[PRINTED_LENGTH];
    printed_join(text);
    p->at = text;
    for (printed_blank(p); *p->at; printed_blank(p)) {
        size_t before = p->operations;
        if (printed_take(p, "/*")) {
            p->at = strstr(p->at, "*/") + 2;
        } else if (printed_take(p, "const ")) {
            printed_expect(p, type);
            printed_expect(p, " ");
            printed_name(p, name);
            printed_expect(p, " = ");
            double is = printed_sum(p);
            printed_declare(p, name, is, before);
            printed_expect(p, ";");
        } else if (printed_take(p, "square ")) { // a law of these tests
            printed_name(p, name);
            printed_expect(p, " = ");
            double x = printed_sum(p);
            const double result[] = {3 * x * x, 6 * x, 6};
            for (int k = 0; k < 3; k++) {
                snprintf(cosine, sizeof cosine, "%.30s[%d]", name, k);
                printed_declare(p, cosine, result[k], p->operations);
            }
            printed_expect(p, ";");
        } else if (printed_take(p, type)) {
            printed_expect(p, " ");
            printed_name(p, name);
            printed_expect(p, ", ");
            printed_name(p, cosine);
            printed_expect(p, ";\n    P_sincos(");
            p->is_twice = true;
            double angle = printed_sum(p);
            p->is_twice = false;
            printed_expect(p, ", &");
            printed_expect(p, name);
            printed_expect(p, ", &");
            printed_expect(p, cosine);
            printed_expect(p, ");");
            printed_declare(p, name, sin(angle), before);
            p->names[p->count - 1].is_pair = true;
            printed_declare(p, cosine, cos(angle), before);
            p->names[p->count - 1].is_pair = true;
        } else {
            printed_name(p, name);
            printed_expect(p, " = ");
            double is = printed_sum(p);
            printed_declare(p, name, is, before);
            printed_expect(p, ";");
        }
    }
}
#endif
