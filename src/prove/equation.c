// Reads equations as people write them into structured forms; quotients by sums are allowed.
#include "prove/equation.h"

enum { DEPTH_MAX = 100, POWER_MAX = 32 };

static const YkForm *read_sum(YkEquationReader *reader, bool is_side);

const YkForm *yk_equation_refuse(YkEquationReader *reader, size_t start, const char *message, const char *hint)
{
    YkPlace place = reader->place;
    if (reader->failed) return NULL;
    reader->failed = true;
    place.column += (uint32_t)start;
    place.length = 1;
    yk_problem(reader->problems, YK_CODE_EXPR_SYNTAX, place, "%s", message);
    if (hint) yk_problem_hint(reader->problems, "%s", hint);
    return NULL;
}

char yk_equation_peek(YkEquationReader *reader)
{
    while (reader->at < reader->length && (reader->text[reader->at] == ' ' || reader->text[reader->at] == '\t'))
        reader->at++;
    return reader->at < reader->length ? reader->text[reader->at] : '\0';
}

const YkForm *yk_equation_bracket(YkEquationReader *reader)
{
    char open = yk_equation_peek(reader), close = open == '(' ? ')' : ']'; // textbooks write s = h [64 u^3 - ...]
    if (++reader->depth > DEPTH_MAX)
        return yk_equation_refuse(reader, reader->at, "brackets are nested too deeply", NULL);
    size_t start = reader->at++;
    const YkForm *inner = read_sum(reader, false);
    reader->depth--;
    if (!inner) return NULL;
    char c = yk_equation_peek(reader);
    if (c == '\0' || c == '=') return yk_equation_refuse(reader, start, "this bracket is never closed", NULL);
    if (c != close)
        return yk_equation_refuse(reader, reader->at, close == ')' ? "`)` is expected here" : "`]` is expected here",
                                  NULL);
    reader->at++;
    return inner;
}

static const YkForm *raise(YkEquationReader *reader, const YkForm *base, int64_t exponent)
{
    YkRing *ring = reader->d->ring;
    const YkPoisson *one = yk_ring_rational(ring, 1, 1);
    const YkForm *product = yk_form_of(ring, one);
    for (int64_t k = exponent < 0 ? -exponent : exponent; k > 0; k--) product = yk_form_multiply(ring, product, base);
    return exponent < 0 ? yk_form_divide(ring, yk_form_of(ring, one), product) : product;
}

// `^`, or `**` as some write it.
static bool takes_power(YkEquationReader *reader)
{
    char c = yk_equation_peek(reader);
    bool is_double = c == '*' && reader->at + 1 < reader->length && reader->text[reader->at + 1] == '*';
    if (c != '^' && !is_double) return false;
    reader->at += is_double ? 2 : 1;
    return true;
}

// Reads a power if ^ follows, otherwise returns base. NULL base: NULL.
static const YkForm *raised(YkEquationReader *reader, const YkForm *base)
{
    YkEquationSize size = reader->size;
    if (!base || !takes_power(reader)) return base;
    size_t start = reader->at;
    bool negative = yk_equation_peek(reader) == '-';
    if (negative) reader->at++;
    int64_t over, under;
    const YkForm *exponent = yk_equation_atom(reader);
    if (!exponent) return NULL;
    const YkPoisson *value = yk_form_expand(reader->d->ring, exponent, 1);
    if (!value) yk_ring_clear(reader->d->ring);
    if (!value || !yk_ring_is_rational(value, &over, &under) || under != 1 || over > POWER_MAX || over < -POWER_MAX)
        return yk_equation_refuse(reader, start, "an exponent is a whole number here, up to 32", NULL);
    reader->size = yk_equation_size_power(size, (int)(negative ? -over : over));
    return raise(reader, base, negative ? -over : over);
}

static const YkForm *read_power(YkEquationReader *reader)
{
    return raised(reader, yk_equation_atom(reader));
}

static bool begins_atom(char c)
{
    return (unsigned char)c >= 0x80 || yk_begins_name(c) || yk_is_digit(c) || c == '(' || c == '[' || c == '.';
}

static const YkForm *read_product(YkEquationReader *reader)
{
    const YkForm *product = read_power(reader);
    while (product) {
        char c = yk_equation_peek(reader);
        if (c != '*' && c != '/' && !begins_atom(c)) break;
        YkEquationSize size = reader->size;
        if (c == '*' || c == '/') reader->at++;
        const YkForm *factor = read_power(reader);
        if (!factor) return NULL;
        reader->size = yk_equation_size_times(size, reader->size, c == '/' ? -1 : 1);
        product = c == '/' ? yk_form_divide(reader->d->ring, product, factor)
                           : yk_form_multiply(reader->d->ring, product, factor);
    }
    return product;
}

static void note_term(YkEquationReader *reader, size_t start, bool negative, const YkForm *form)
{
    YkEquation *equation = reader->equation;
    size_t end = reader->at;
    while (end > start && reader->text[end - 1] == ' ') end--;
    if (equation->term_count == YK_EQUATION_TERMS_MAX) return;
    equation->terms[equation->term_count++] = (YkEquationTerm){reader->is_right, negative, start, end, form};
}

static const YkForm *read_sum(YkEquationReader *reader, bool is_side)
{
    const YkForm *sum = yk_form_of(reader->d->ring, yk_ring_rational(reader->d->ring, 0, 1));
    char c = yk_equation_peek(reader);
    YkEquationSize size = {.kind = YK_SIZE_BARE};
    bool first = true;
    while (sum && (first || c == '+' || c == '-')) {
        bool negative = c == '-';
        if (c == '+' || c == '-') reader->at++;
        yk_equation_peek(reader);
        size_t start = reader->at;
        const YkForm *term = read_product(reader);
        if (!term) return NULL;
        size = first ? reader->size : yk_equation_size_sum(reader, start, size, reader->size);
        if (reader->failed) return NULL;
        if (is_side) note_term(reader, start, negative, term);
        sum = negative ? yk_form_subtract(reader->d->ring, sum, term) : yk_form_add(reader->d->ring, sum, term);
        first = false;
        c = yk_equation_peek(reader);
    }
    reader->size = size;
    return sum;
}

// Reports what the ring refused; the next equation starts afresh.
static bool fail_sides(YkEquationReader *reader)
{
    YkRingStatus why = yk_ring_status(reader->d->ring);
    if (why != YK_RING_OK) yk_equation_refuse(reader, 0, yk_ring_status_text(why), NULL);
    yk_ring_clear(reader->d->ring);
    return false;
}

bool yk_equation_read(YkDerivation *d, const char *text, size_t length, YkPlace place, YkProblems *problems,
                      YkEquation *equation)
{
    YkEquationReader reader = {
        .d = d, .text = text, .length = length, .place = place, .problems = problems, .equation = equation};
    *equation = (YkEquation){0};
    equation->left = read_sum(&reader, true);
    if (equation->left && yk_equation_peek(&reader) != '=')
        yk_equation_refuse(&reader, reader.at,
                           reader.at < length ? "an operator or `=` is expected here"
                                              : "there is no `=` in this equation",
                           "an equation has two sides: `l1*cos(theta1) - d3*cos(theta2) = 0`");
    if (reader.failed || !equation->left) return fail_sides(&reader);
    reader.at++;
    while (reader.at < length && text[reader.at] == '=') reader.at++; // == is accepted
    reader.is_right = true;
    YkEquationSize left = reader.size;
    size_t start = reader.at;
    equation->right = read_sum(&reader, true);
    if (equation->right && yk_equation_peek(&reader) != '\0')
        yk_equation_refuse(&reader, reader.at,
                           text[reader.at] == '=' ? "there is a second `=`: one equation at a time"
                                                  : "an operator is expected here, or the equation's end",
                           NULL);
    if (equation->right) yk_equation_compare_sides(&reader, start, left, reader.size);
    return (!reader.failed && equation->right) || fail_sides(&reader);
}
