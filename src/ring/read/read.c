// The grammar of expressions, by recursive descent:
//   sum     [+-] product { [+-] product }
//   product factor { [* / or nothing] factor }      juxtaposition binds like *
//   factor  [+-] base [ ^ whole number ]
//   base    number | name | function | ( sum ) | { sum } in LaTeX
#include <stdlib.h>
#include <string.h>
#include "base/letters.h"
#include "ring/read/reader.h"

enum { DEPTH_MAX = 200 };

char yk_reader_peek(const YkRingReader *reader)
{
    return reader->at < reader->length ? reader->text[reader->at] : '\0';
}

bool yk_reader_sees(const YkRingReader *reader, const char *what)
{
    size_t length = strlen(what);
    if (reader->length - reader->at < length || memcmp(reader->text + reader->at, what, length) != 0) return false;
    char next = reader->at + length < reader->length ? reader->text[reader->at + length] : '\0';
    return !yk_begins_name(what[length - 1]) || !yk_begins_name(next);
}

void yk_reader_blanks(YkRingReader *reader)
{
    static const char *const blanks[] = {" ",   "\t",  "\n",  "\r",     "~",      "\\,",    "\\;",
                                         "\\:", "\\!", "\\ ", "\\quad", "\\left", "\\right"};
    size_t kinds = reader->format == YK_RING_LATEX ? sizeof blanks / sizeof *blanks : 4;
    for (size_t i = 0; i < kinds;) {
        if (!yk_reader_sees(reader, blanks[i])) {
            i++;
            continue;
        }
        reader->at += strlen(blanks[i]);
        i = 0;
    }
}

bool yk_reader_takes(YkRingReader *reader, const char *what)
{
    if (!yk_reader_sees(reader, what)) return false;
    reader->at += strlen(what);
    yk_reader_blanks(reader);
    return true;
}

const YkPoisson *yk_reader_refuse(YkRingReader *reader, YkCode code, size_t start, const char *message,
                                  const char *detail)
{
    YkPlace place = reader->place;
    if (reader->failed) return NULL;
    reader->failed = true;
    place.column += (uint32_t)start;
    place.length = reader->at > start ? (uint32_t)(reader->at - start) : 1;
    yk_problem(reader->problems, code, place, message, detail);
    return NULL;
}

const YkPoisson *yk_reader_expected(YkRingReader *reader, const char *wanted)
{
    if (reader->at >= reader->length)
        return yk_reader_refuse(reader, YK_CODE_EXPR_SYNTAX, reader->at, "the expression ends where %s is expected",
                                wanted);
    char c = yk_reader_peek(reader);
    if (c < ' ' || c > '~')
        return yk_reader_refuse(reader, YK_CODE_EXPR_CHARACTER, reader->at, "%s is expected, not this character",
                                wanted);
    size_t start = reader->at++;
    return yk_reader_refuse(reader, YK_CODE_EXPR_SYNTAX, start, "%s is expected here", wanted);
}

// Reports a refusal of the ring as a problem.
static const YkPoisson *checked(YkRingReader *reader, size_t start, const YkPoisson *result)
{
    if (result || reader->failed) return result;
    YkRingStatus status = yk_ring_status(reader->ring);
    YkCode code = status == YK_RING_MEMORY    ? YK_CODE_OUT_OF_MEMORY
                  : status == YK_RING_DIVISOR ? YK_CODE_RING_DIVISOR
                                              : YK_CODE_RING_SIZE;
    return yk_reader_refuse(reader, code, start, "%s", yk_ring_status_text(status));
}

static const YkPoisson *bracketed(YkRingReader *reader, const char *close)
{
    if (reader->depth >= DEPTH_MAX)
        return yk_reader_refuse(reader, YK_CODE_EXPR_TOO_DEEP, reader->at, "%s", "parentheses are nested too deeply");
    reader->depth++;
    const YkPoisson *inner = yk_reader_sum(reader);
    reader->depth--;
    if (!inner) return NULL;
    return yk_reader_takes(reader, close) ? inner : yk_reader_expected(reader, close[0] == ')' ? "`)`" : "`}`");
}

static const YkPoisson *fraction(YkRingReader *reader)
{
    size_t start = reader->at;
    if (!yk_reader_takes(reader, "{")) return yk_reader_expected(reader, "`{`");
    const YkPoisson *over = bracketed(reader, "}");
    if (!over) return NULL;
    if (!yk_reader_takes(reader, "{")) return yk_reader_expected(reader, "`{`");
    const YkPoisson *under = bracketed(reader, "}");
    return under ? checked(reader, start, yk_ring_divide(reader->ring, over, under)) : NULL;
}

static const YkPoisson *base(YkRingReader *reader)
{
    char c = yk_reader_peek(reader);
    bool latex = reader->format == YK_RING_LATEX, found = false;
    if (yk_is_digit(c) || c == '.') return yk_reader_number(reader);
    if (yk_reader_takes(reader, "(")) return bracketed(reader, ")");
    if (latex && yk_reader_takes(reader, "{")) return bracketed(reader, "}");
    if (latex && (yk_reader_takes(reader, "\\frac") || yk_reader_takes(reader, "\\tfrac"))) return fraction(reader);
    const YkPoisson *value = yk_reader_function(reader, &found);
    if (found) return value;
    if (yk_begins_name(c) || (latex && c == '\\')) return yk_reader_name(reader);
    return yk_reader_expected(reader, "a number, a name or `(`");
}

// Reads a whole number after ^, perhaps in brackets; returns false with a problem.
static bool exponent(YkRingReader *reader, int32_t *power)
{
    char close = yk_reader_takes(reader, "(") ? ')' : yk_reader_takes(reader, "{") ? '}' : '\0';
    bool negative = yk_reader_takes(reader, "-");
    size_t start = reader->at;
    int32_t value = 0;
    for (; yk_is_digit(yk_reader_peek(reader)); reader->at++)
        if (value <= YK_POWER_MAX) value = 10 * value + (yk_reader_peek(reader) - '0');
    if (reader->at == start) return yk_reader_expected(reader, "a whole number as exponent") != NULL;
    yk_reader_blanks(reader);
    if (close != '\0' && !yk_reader_takes(reader, close == ')' ? ")" : "}"))
        return yk_reader_expected(reader, "the end of the exponent") != NULL;
    *power = negative ? -value : value;
    return true;
}

const YkPoisson *yk_reader_factor(YkRingReader *reader)
{
    bool negative = false;
    size_t start = reader->at;
    int32_t power = 0;
    for (;; negative = !negative) {
        while (yk_reader_takes(reader, "+")) {}
        if (!yk_reader_takes(reader, "-")) break;
    }
    const YkPoisson *value = base(reader);
    if (!value) return NULL;
    yk_reader_blanks(reader);
    if (yk_reader_takes(reader, "^")) {
        if (!exponent(reader, &power)) return NULL;
        value = checked(reader, start, yk_ring_power(reader->ring, value, power));
    }
    return negative ? checked(reader, start, yk_ring_negate(reader->ring, value)) : value;
}

// Returns whether a factor begins here, without an operator before it.
static bool juxtaposed(const YkRingReader *reader)
{
    char c = yk_reader_peek(reader);
    return yk_begins_name(c) || yk_is_digit(c) || c == '(' ||
           (reader->format == YK_RING_LATEX && (c == '\\' || c == '{'));
}

static const YkPoisson *product(YkRingReader *reader)
{
    size_t start = reader->at;
    const YkPoisson *value = yk_reader_factor(reader);
    while (value) {
        bool divides = yk_reader_takes(reader, "/");
        if (!divides && !yk_reader_takes(reader, "*") && !yk_reader_takes(reader, "\\cdot") && !juxtaposed(reader))
            break;
        const YkPoisson *factor = yk_reader_factor(reader);
        if (!factor) return NULL;
        value = divides ? yk_ring_divide(reader->ring, value, factor) : yk_ring_multiply(reader->ring, value, factor);
        value = checked(reader, start, value);
    }
    return value;
}

// The parts of a sum. They are added at once: one by one, a long sum would be copied for each of its terms.
typedef struct Parts {
    const YkPoisson **items;
    size_t count, capacity;
} Parts;

static bool keep_part(YkRingReader *reader, Parts *parts, const YkPoisson *part)
{
    if (!part) return false;
    if (!YK_ROOM(parts->items, parts->count, parts->capacity)) {
        yk_ring_fail(reader->ring, YK_RING_MEMORY);
        return checked(reader, reader->at, NULL) != NULL;
    }
    parts->items[parts->count++] = part;
    return true;
}

const YkPoisson *yk_reader_sum(YkRingReader *reader)
{
    size_t start = reader->at;
    Parts parts = {0};
    bool well = keep_part(reader, &parts, product(reader));
    while (well) {
        bool minus = yk_reader_takes(reader, "-");
        if (!minus && !yk_reader_takes(reader, "+")) break;
        const YkPoisson *part = product(reader);
        if (minus && part) part = checked(reader, start, yk_ring_negate(reader->ring, part));
        well = keep_part(reader, &parts, part);
    }
    const YkPoisson *sum = well ? checked(reader, start, yk_ring_sum(reader->ring, parts.items, parts.count)) : NULL;
    free(parts.items);
    return sum;
}

const YkPoisson *yk_ring_read(YkRing *ring, YkRingFormat format, const char *text, size_t length, YkPlace place,
                              YkProblems *problems)
{
    YkRingStatus before = ring->status;
    YkRingReader reader = {
        .ring = ring, .format = format, .text = text, .length = length, .place = place, .problems = problems};
    ring->status = YK_RING_OK;
    yk_reader_blanks(&reader);
    bool has_names = format == YK_RING_TEXT || format == YK_RING_BOOK || yk_ring_typeset(ring);
    const YkPoisson *value = has_names ? yk_reader_sum(&reader) : checked(&reader, 0, NULL);
    if (value && reader.at < length) value = yk_reader_expected(&reader, "an operator or the end");
    if (ring->status != YK_RING_MEMORY) ring->status = before;
    return value;
}
