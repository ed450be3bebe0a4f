// Reads numbers, names and functions in expressions.
#include <string.h>
#include "base/letters.h"
#include "base/number.h"
#include "ring/read/reader.h"

enum { TOKEN_MAX = 300 };

static bool is_name_part(char c)
{
    return yk_begins_name(c) || yk_is_digit(c) || c == '.';
}

static char peek_at(const YkRingReader *reader, size_t offset)
{
    return reader->at + offset < reader->length ? reader->text[reader->at + offset] : '\0';
}

const YkPoisson *yk_reader_number(YkRingReader *reader)
{
    int64_t mantissa;
    int32_t exponent;
    double rounded;
    size_t start = reader->at, rest = reader->length - reader->at;
    size_t length = yk_number_read(reader->text + start, rest, &rounded);
    if (length == 0) return yk_reader_expected(reader, "a number");
    reader->at += length;
    const YkPoisson *value = NULL;
    if (yk_number_read_exact(reader->text + start, rest, &mantissa, &exponent) && exponent > -40 && exponent < 40)
        value = yk_ring_decimal(reader->ring, mantissa, exponent);
    if (!value)
        return yk_reader_refuse(reader, YK_CODE_RING_SIZE, start, "%s", "the number is too large for exact arithmetic");
    if (peek_at(reader, 0) == 'i' && !is_name_part(peek_at(reader, 1))) {
        reader->at++;
        value = yk_ring_multiply(reader->ring, value, yk_ring_i(reader->ring));
    }
    yk_reader_blanks(reader);
    return value;
}

static const YkPoisson *unknown_name(YkRingReader *reader, size_t start, const char *name)
{
    if (reader->failed) return NULL;
    yk_reader_refuse(reader, YK_CODE_UNKNOWN_NAME, start, "unknown name %q", name);
    const YkRing *ring = reader->ring;
    enum { CANDIDATES_MAX = 1000 };
    const char *candidates[CANDIDATES_MAX];
    size_t count = ring->symbol_count < CANDIDATES_MAX ? ring->symbol_count : CANDIDATES_MAX;
    for (size_t i = 0; i < count; i++) candidates[i] = ring->symbols[i].name;
    const char *near = yk_nearest(name, candidates, count);
    if (near) yk_problem_hint(reader->problems, "did you mean %q?", near);
    return NULL;
}

// Copies text[start..at) as a string; returns false if it is too long for a name.
static bool token(const YkRingReader *reader, size_t start, char out[TOKEN_MAX])
{
    size_t length = reader->at - start;
    if (length >= TOKEN_MAX) return false;
    memcpy(out, reader->text + start, length);
    out[length] = '\0';
    return true;
}

static int32_t find_symbol(const YkRingReader *reader, const char *name)
{
    const YkRing *ring = reader->ring;
    int32_t symbol = reader->format == YK_RING_LATEX ? yk_names_find(&ring->latex_names, name) : YK_NONE;
    if (reader->format == YK_RING_C) symbol = yk_names_find(&ring->c_names, name);
    return symbol != YK_NONE ? symbol : yk_ring_find(ring, name);
}

static void skip_group(YkRingReader *reader)
{
    while (reader->at < reader->length && reader->text[reader->at] != '}' && reader->text[reader->at] != '{')
        reader->at++;
    if (yk_reader_peek(reader) == '}') reader->at++;
}

// Skips a symbol in LaTeX: [\dot{] base [}] [_{subscript}], base a letter, a command, or \mathit{word}.
static void skip_latex_name(YkRingReader *reader)
{
    bool accent =
        yk_reader_sees(reader, "\\dot") || yk_reader_sees(reader, "\\ddot") || yk_reader_sees(reader, "\\dddot");
    if (accent) {
        while (reader->at < reader->length && reader->text[reader->at] != '{') reader->at++;
        if (reader->at < reader->length) reader->at++;
    }
    if (yk_reader_sees(reader, "\\mathit") || yk_reader_sees(reader, "\\mathtt") ||
        yk_reader_sees(reader, "\\mathrm")) {
        reader->at += strlen("\\mathit");
        if (yk_reader_peek(reader) == '{') reader->at++;
        skip_group(reader);
    } else {
        bool command = yk_reader_peek(reader) == '\\';
        reader->at++;
        while (command && yk_is_letter(yk_reader_peek(reader))) reader->at++;
    }
    if (accent && yk_reader_peek(reader) == '}') reader->at++;
    if (yk_reader_peek(reader) != '_') return;
    reader->at++;
    if (yk_reader_peek(reader) == '{') {
        reader->at++;
        skip_group(reader);
    } else if (reader->at < reader->length)
        reader->at++;
}

static void skip_name(YkRingReader *reader)
{
    if (reader->format == YK_RING_LATEX) {
        skip_latex_name(reader);
        return;
    }
    while (is_name_part(yk_reader_peek(reader))) reader->at++;
    while (yk_reader_peek(reader) == '\'') reader->at++;
}

// Turns x_1 into x_{1}: both mean the same.
static void brace_subscript(char name[TOKEN_MAX])
{
    size_t length = strlen(name);
    if (length < 3 || name[length - 2] != '_' || name[length - 1] == '}' || length + 3 > TOKEN_MAX) return;
    const char last = name[length - 1];
    memcpy(name + length - 1, (const char[]){'{', last, '}', '\0'}, 4);
}

const YkPoisson *yk_reader_name(YkRingReader *reader)
{
    char name[TOKEN_MAX];
    size_t start = reader->at;
    skip_name(reader);
    if (reader->at > reader->length) reader->at = reader->length;
    if (!token(reader, start, name))
        return yk_reader_refuse(reader, YK_CODE_EXPR_SYNTAX, start, "%s", "the name is too long");
    if (reader->format == YK_RING_LATEX) brace_subscript(name);
    int32_t symbol = find_symbol(reader, name);
    yk_reader_blanks(reader);
    if (symbol >= 0) return yk_ring_of(reader->ring, symbol);
    if (strcmp(name, "pi") == 0 || strcmp(name, "\\pi") == 0) return yk_ring_pi(reader->ring);
    if (strcmp(name, "i") == 0 || strcmp(name, "\\mathrm{i}") == 0) return yk_ring_i(reader->ring);
    return unknown_name(reader, start, name);
}

static const YkPoisson *refuse_angle(YkRingReader *reader, size_t start)
{
    if (yk_ring_status(reader->ring) == YK_RING_MEMORY)
        return yk_reader_refuse(reader, YK_CODE_OUT_OF_MEMORY, start, "%s", "out of memory");
    return yk_reader_refuse(reader, YK_CODE_RING_ANGLE, start, "%s",
                            "an angle here is a sum of whole multiples of angles and of fractions of pi");
}

// Reads (angle), or ((angle)) turned by i for exp; in LaTeX e^{...}.
static const YkPoisson *unit_argument(YkRingReader *reader, bool is_exp, const char *close)
{
    size_t start = reader->at;
    const YkPoisson *angle = yk_reader_sum(reader);
    if (!angle) return NULL;
    if (is_exp) angle = yk_ring_divide(reader->ring, angle, yk_ring_i(reader->ring));
    const YkPoisson *unit = yk_ring_exp_of(reader->ring, angle);
    if (!unit) return refuse_angle(reader, start);
    return yk_reader_takes(reader, close) ? unit : yk_reader_expected(reader, close[0] == ')' ? "`)`" : "`}`");
}

static const YkPoisson *root_argument(YkRingReader *reader, const char *close)
{
    int64_t square, one;
    size_t start = reader->at;
    const YkPoisson *value = yk_reader_sum(reader);
    if (!value) return NULL;
    const YkPoisson *root = NULL;
    if (yk_ring_is_rational(value, &square, &one) && one == 1) root = yk_ring_sqrt(reader->ring, square);
    if (!root)
        return yk_reader_refuse(reader, YK_CODE_EXPR_SYNTAX, start, "%s",
                                "only roots of 2, 3, 6 and squares times these are known");
    return yk_reader_takes(reader, close) ? root : yk_reader_expected(reader, close[0] == ')' ? "`)`" : "`}`");
}

// Reads: base, exponent)
static const YkPoisson *power_arguments(YkRingReader *reader)
{
    int64_t exponent, one;
    size_t start = reader->at;
    const YkPoisson *value = yk_reader_sum(reader);
    if (!value) return NULL;
    if (!yk_reader_takes(reader, ",")) return yk_reader_expected(reader, "`,`");
    const YkPoisson *power = yk_reader_sum(reader);
    if (!power) return NULL;
    if (!yk_reader_takes(reader, ")")) return yk_reader_expected(reader, "`)`");
    bool whole = yk_ring_is_rational(power, &exponent, &one) && one == 1 && exponent >= -YK_POWER_MAX &&
                 exponent <= YK_POWER_MAX;
    const YkPoisson *result = whole ? yk_ring_power(reader->ring, value, (int32_t)exponent) : NULL;
    return result ? result : yk_reader_refuse(reader, YK_CODE_RING_SIZE, start, "%s", "this power cannot be expanded");
}

static const YkPoisson *real_or_imaginary(YkRing *ring, const YkPoisson *unit, bool is_sin)
{
    return is_sin ? yk_ring_imaginary(ring, unit) : yk_ring_real(ring, unit);
}

const YkPoisson *yk_reader_function(YkRingReader *reader, bool *found)
{
    enum { COS, SIN, EXP, SQRT, POW, FUNCTIONS };
    static const char *const plain[] = {"cos", "sin", "exp", "sqrt", "pow"};
    static const char *const latex[] = {"\\cos", "\\sin", "e^{\\mathrm{i}", "\\sqrt", "\\pow"};
    enum { NESTED_MAX = 200 };
    bool in_latex = reader->format == YK_RING_LATEX;
    size_t start = reader->at;
    int function = 0;
    while (function < FUNCTIONS && !yk_reader_sees(reader, (in_latex ? latex : plain)[function])) function++;
    *found =
        function < FUNCTIONS &&
        !(reader->at + strlen(plain[function]) < reader->length && !in_latex &&
          (is_name_part(peek_at(reader, strlen(plain[function]))) || peek_at(reader, strlen(plain[function])) == '\''));
    if (!*found) return NULL;
    bool latex_exp = in_latex && function == EXP;
    reader->at += latex_exp ? strlen("e^{") : strlen((in_latex ? latex : plain)[function]);
    yk_reader_blanks(reader);
    const char *close = latex_exp || (in_latex && function == SQRT) ? "}" : ")";
    if (!latex_exp && !yk_reader_takes(reader, close[0] == ')' ? "(" : "{"))
        return yk_reader_expected(reader, close[0] == ')' ? "`(`" : "`{`");
    if (reader->depth >= NESTED_MAX)
        return yk_reader_refuse(reader, YK_CODE_EXPR_TOO_DEEP, start, "%s", "parentheses are nested too deeply");
    reader->depth++;
    const YkPoisson *value;
    if (function == SQRT)
        value = root_argument(reader, close);
    else if (function == POW)
        value = power_arguments(reader);
    else
        value = unit_argument(reader, function == EXP, close);
    reader->depth--;
    return value && function <= SIN ? real_or_imaginary(reader->ring, value, function == SIN) : value;
}
