// Equations as a hand writes them, read into structured forms: quotients by sums are welcome.
#include <string.h>
#include "base/number.h"
#include "derive/check.h"

enum { DEPTH_MAX = 100, POWER_MAX = 32 };

typedef struct Reader {
    YkRing *ring;
    const char *text;
    size_t length, at;
    YkPlace place;
    YkProblems *problems;
    int depth;
    bool is_right, failed;
    YkEquation *equation; // takes the summands of the sides
} Reader;

static const YkForm *read_sum(Reader *reader, bool is_side);

static char peek(Reader *reader)
{
    while (reader->at < reader->length && (reader->text[reader->at] == ' ' || reader->text[reader->at] == '\t'))
        reader->at++;
    return reader->at < reader->length ? reader->text[reader->at] : '\0';
}

static bool is_letter(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

static bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

static const YkForm *refuse(Reader *reader, size_t start, const char *message, const char *hint)
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

// A piece of the text that the ring reads: a name, a number, cos(...).
static const YkForm *leaf(Reader *reader, size_t start, size_t end)
{
    YkPlace place = reader->place;
    place.column += (uint32_t)start;
    const YkPoisson *a =
        yk_ring_read(reader->ring, YK_RING_TEXT, reader->text + start, end - start, place, reader->problems);
    if (!a) reader->failed = true;
    return yk_form_of(reader->ring, a);
}

static size_t name_end(const Reader *reader, size_t at)
{
    while (at < reader->length &&
           (is_letter(reader->text[at]) || is_digit(reader->text[at]) || reader->text[at] == '.'))
        at++;
    while (at < reader->length && reader->text[at] == '\'') at++;
    return at;
}

// Behind the bracket that closes the one at `at`; 0 where there is none.
static size_t behind_bracket(const Reader *reader, size_t at)
{
    int depth = 0;
    for (; at < reader->length; at++) {
        depth += (reader->text[at] == '(') - (reader->text[at] == ')');
        if (depth == 0) return at + 1;
    }
    return 0;
}

static const YkForm *function(Reader *reader, size_t start, size_t end)
{
    size_t behind = behind_bracket(reader, reader->at);
    if (behind == 0) return refuse(reader, reader->at, "this bracket is never closed", NULL);
    size_t length = end - start, open = reader->at;
    reader->at = behind;
    if (length != 3 || strncmp(reader->text + start, "tan", 3) != 0) return leaf(reader, start, behind);
    // tan(x) = sin(x) / cos(x)
    YkText text = {0};
    const YkForm *parts[2] = {NULL, NULL};
    for (int k = 0; k < 2; k++) {
        yk_text_clear(&text);
        yk_text_puts(&text, k == 0 ? "sin" : "cos");
        yk_text_add(&text, reader->text + open, behind - open);
        YkPlace place = reader->place;
        place.column += (uint32_t)start;
        parts[k] = yk_form_of(reader->ring, yk_ring_read(reader->ring, YK_RING_TEXT, yk_text_get(&text), text.length,
                                                         place, k == 0 ? reader->problems : NULL));
    }
    yk_text_free(&text);
    if (!parts[0] || !parts[1]) reader->failed = true;
    return yk_form_divide(reader->ring, parts[0], parts[1]);
}

static bool is_function_name(const Reader *reader, size_t start, size_t end)
{
    static const char *const words[] = {"cos", "sin", "tan", "sqrt", "exp", "pow"};
    for (size_t k = 0; k < sizeof words / sizeof *words; k++)
        if (strlen(words[k]) == end - start && strncmp(words[k], reader->text + start, end - start) == 0) return true;
    return false;
}

static const YkForm *read_atom(Reader *reader)
{
    char c = peek(reader);
    size_t start = reader->at;
    if (c == '(' || c == '[') { // books write s = h [64 u^3 - ...]
        if (++reader->depth > DEPTH_MAX) return refuse(reader, start, "brackets are nested too deeply", NULL);
        reader->at++;
        const YkForm *inner = read_sum(reader, false);
        reader->depth--;
        if (!inner) return NULL;
        if (peek(reader) != (c == '(' ? ')' : ']'))
            return refuse(reader, reader->at, c == '(' ? "`)` is wanted here" : "`]` is wanted here", NULL);
        reader->at++;
        return inner;
    }
    if (is_letter(c)) {
        size_t end = name_end(reader, start);
        reader->at = end;
        if (peek(reader) == '(' && is_function_name(reader, start, end)) return function(reader, start, end);
        reader->at = end;
        return leaf(reader, start, end);
    }
    double value;
    size_t bytes = is_digit(c) || c == '.' ? yk_number_read(reader->text + start, reader->length - start, &value) : 0;
    if (bytes > 0) {
        reader->at = start + bytes;
        return leaf(reader, start, reader->at);
    }
    if (c == '\0') return refuse(reader, start, "the equation ends where a quantity is wanted", NULL);
    if (c == '=') return refuse(reader, start, "a quantity is wanted before `=`", NULL);
    return refuse(reader, start, "a quantity is wanted here", "write products with `*` or a blank, powers with `^`");
}

static const YkForm *raise(Reader *reader, const YkForm *base, int64_t exponent)
{
    YkRing *ring = reader->ring;
    const YkPoisson *one = yk_ring_rational(ring, 1, 1);
    const YkForm *product = yk_form_of(ring, one);
    for (int64_t k = exponent < 0 ? -exponent : exponent; k > 0; k--) product = yk_form_multiply(ring, product, base);
    return exponent < 0 ? yk_form_divide(ring, yk_form_of(ring, one), product) : product;
}

static const YkForm *read_power(Reader *reader)
{
    const YkForm *base = read_atom(reader);
    if (!base || peek(reader) != '^') return base;
    reader->at++;
    size_t start = reader->at;
    bool negative = peek(reader) == '-';
    if (negative) reader->at++;
    int64_t over, under;
    const YkForm *exponent = read_atom(reader);
    if (!exponent) return NULL;
    const YkPoisson *value = yk_form_expand(reader->ring, exponent, 1);
    if (!value || !yk_ring_is_rational(value, &over, &under) || under != 1 || over > POWER_MAX || over < -POWER_MAX)
        return refuse(reader, start, "an exponent is a whole number here, up to 32", NULL);
    return raise(reader, base, negative ? -over : over);
}

static bool begins_atom(char c)
{
    return is_letter(c) || is_digit(c) || c == '(' || c == '[' || c == '.';
}

static const YkForm *read_product(Reader *reader)
{
    const YkForm *product = read_power(reader);
    while (product) {
        char c = peek(reader);
        if (c != '*' && c != '/' && !begins_atom(c)) break;
        if (c == '*' || c == '/') reader->at++;
        const YkForm *factor = read_power(reader);
        if (!factor) return NULL;
        product =
            c == '/' ? yk_form_divide(reader->ring, product, factor) : yk_form_multiply(reader->ring, product, factor);
    }
    return product;
}

static void note_term(Reader *reader, size_t start, bool negative, const YkForm *form)
{
    YkEquation *equation = reader->equation;
    size_t end = reader->at;
    while (end > start && reader->text[end - 1] == ' ') end--;
    if (equation->term_count == YK_EQUATION_TERMS_MAX) return;
    equation->terms[equation->term_count++] = (YkEquationTerm){reader->is_right, negative, start, end, form};
}

static const YkForm *read_sum(Reader *reader, bool is_side)
{
    const YkForm *sum = yk_form_of(reader->ring, yk_ring_rational(reader->ring, 0, 1));
    char c = peek(reader);
    bool first = true;
    while (sum && (first || c == '+' || c == '-')) {
        bool negative = c == '-';
        if (c == '+' || c == '-') reader->at++;
        peek(reader);
        size_t start = reader->at;
        const YkForm *term = read_product(reader);
        if (!term) return NULL;
        if (is_side) note_term(reader, start, negative, term);
        sum = negative ? yk_form_subtract(reader->ring, sum, term) : yk_form_add(reader->ring, sum, term);
        first = false;
        c = peek(reader);
    }
    return sum;
}

bool yk_equation_read(YkRing *ring, const char *text, size_t length, YkPlace place, YkProblems *problems,
                      YkEquation *equation)
{
    Reader reader = {
        .ring = ring, .text = text, .length = length, .place = place, .problems = problems, .equation = equation};
    *equation = (YkEquation){0};
    equation->left = read_sum(&reader, true);
    if (equation->left && peek(&reader) != '=')
        refuse(&reader, reader.at,
               reader.at < length ? "an operator or `=` is wanted here" : "there is no `=` in this equation",
               "an equation has two sides: `l1*cos(theta1) - d3*cos(theta2) = 0`");
    if (reader.failed || !equation->left) return false;
    reader.at++;
    while (reader.at < length && text[reader.at] == '=') reader.at++; // == is kindly taken
    reader.is_right = true;
    equation->right = read_sum(&reader, true);
    if (equation->right && peek(&reader) != '\0')
        refuse(&reader, reader.at, "an operator is wanted here, or the equation's end", NULL);
    return !reader.failed && equation->right != NULL;
}
