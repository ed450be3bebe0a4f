// Prints values as statements: a variable for each value used more than once, and calls before their first result.
#include <stdlib.h>
#include <string.h>
#include "graph/print.h"

enum { INLINE_MAX = 9, LINE_MAX_LENGTH = 112 }; // operations in one expression; columns

// Variables of the printed functions, and the functions of <math.h> that they call, which a variable of that name
// would hide.
static bool is_used(const YkPrinter *pr, const char *name)
{
    static const char *const words[] = {
        "m",        "c",      "in",      "out",  "i",     "n",     "known", "x",      "status",
        "margin",   "how",    "witness", "p",    "q",     "t",     "miss",  "finite", "residual",
        "jacobian", "system", "machine", "abs",  "acos",  "asin",  "atan",  "atan2",  "copysign",
        "cos",      "cosh",   "exp",     "fabs", "fmax",  "fmin",  "fmod",  "log",    "log10",
        "pow",      "sin",    "sinh",    "sqrt", "tan",   "tanh",  "acosf", "asinf",  "atan2f",
        "atanf",    "cosf",   "coshf",   "expf", "fabsf", "fmaxf", "fminf", "fmodf",  "logf",
        "log10f",   "powf",   "rintf",   "sinf", "sinhf", "sqrtf", "tanf",  "tanhf"};
    if (pr->unknowns && strcmp(pr->unknowns, name) == 0) return true;
    for (size_t k = 0; k < sizeof words / sizeof *words; k++)
        if (strcmp(words[k], name) == 0) return true;
    return false;
}

static const char *allowed(const YkPrinter *pr, const char *wish)
{
    return pr->file->name ? pr->file->name(pr->file->context, wish) : wish;
}

const char *yk_printer_unique(YkPrinter *pr, const char *wish)
{
    const char *name = wish = allowed(pr, wish);
    int32_t existing;
    for (int k = 2; !pr->graph->failed && (is_used(pr, name) || yk_names_find(&pr->taken, name) != YK_NONE); k++)
        name = allowed(pr, yk_graph_text(pr->graph, "%s_%d", wish, k));
    if (!yk_names_add(&pr->taken, name, 0, &existing)) pr->failed = true;
    return name;
}

// --- statements

// Returns the number of operations in its expression as it would be written.
static int weight(const YkPrinter *pr, YkRef value)
{
    const YkValue *v = yk_printer_at(pr, value);
    if (value < 0 || yk_printer_is_given(pr, value) || pr->local[value]) return 0;
    if (v->op == YK_VALUE_MINUS) return weight(pr, v->a);
    int sum = 1;
    const YkRef operands[] = {v->a, v->b, v->c};
    for (size_t k = 0; k < 3; k++) sum += operands[k] >= 0 ? weight(pr, operands[k]) : 0;
    return sum;
}

// Writes a comment before the first statement of its section.
static void heading(YkPrinter *pr, int32_t section)
{
    const char *text = pr->graph->sections[section];
    if (section == pr->section) return;
    pr->section = section;
    if (text) yk_text_format(pr->out, "\n    /* %s */\n", text);
}

// Breaks a line that is too long after a blank at its outermost places.
void yk_printer_wrap(YkPrinter *pr, size_t from)
{
    size_t start = from;
    while (pr->out->length - start > LINE_MAX_LENGTH) {
        size_t at = start + LINE_MAX_LENGTH;
        while (at > start + 20 && pr->out->data[at] != ' ') at--;
        if (at <= start + 20) return;
        char *rest = yk_arena_copy(pr->graph->arena, pr->out->data + at + 1, pr->out->length - at - 1);
        if (!rest) {
            pr->failed = true;
            return;
        }
        pr->out->length = at;
        pr->out->data[at] = 0;
        yk_text_puts(pr->out, "\n");
        start = pr->out->length;
        yk_text_format(pr->out, "        %s", rest);
    }
}

static void declare(YkPrinter *pr, YkRef value, const char *name)
{
    size_t from = pr->out->length;
    yk_text_format(pr->out, "    const %s %s = ", yk_printer_real(pr), name);
    yk_printer_written(pr, value);
    yk_text_puts(pr->out, ";");
    yk_printer_wrap(pr, from);
    yk_text_puts(pr->out, "\n");
    pr->local[value] = name;
}

// Declares the sine and, right after it, the cosine of one angle.
static void declare_pair(YkPrinter *pr, YkRef sine)
{
    const YkValue *s = yk_printer_at(pr, sine), *c = yk_printer_at(pr, sine + 1);
    pr->uses[YK_HELPER_SINCOS] = true;
    pr->local[sine] = yk_printer_unique(pr, s->name ? s->name : yk_graph_text(pr->graph, "s%d", (int)sine));
    pr->local[sine + 1] = yk_printer_unique(pr, c->name ? c->name : yk_graph_text(pr->graph, "c%d", (int)sine));
    yk_text_format(pr->out, "    %s %s, %s;\n    %s_sincos(", yk_printer_real(pr), pr->local[sine], pr->local[sine + 1],
                   pr->prefix);
    yk_printer_value(pr, s->a);
    yk_text_format(pr->out, ", &%s, &%s);\n", pr->local[sine], pr->local[sine + 1]);
}

void yk_printer_array(YkPrinter *pr, const char *name, const YkRef *values, size_t count, size_t size)
{
    size_t from = pr->out->length;
    yk_text_format(pr->out, "    %s %s[%d] = {", yk_printer_real(pr), name, (int)size);
    for (size_t k = 0; k < count; k++) {
        if (k > 0) yk_text_puts(pr->out, ", ");
        yk_printer_value(pr, values[k]);
    }
    yk_text_puts(pr->out, "};");
    yk_printer_wrap(pr, from);
    yk_text_puts(pr->out, "\n");
}

// Makes sure that the call is written before its first result.
static const char *ensure_call(YkPrinter *pr, int32_t index, const char **names)
{
    YkCall call = pr->graph->calls[index];
    if (!names[index]) names[index] = pr->file->call(pr, &call);
    return names[index];
}

// --- all together

static bool needs_variable(const YkPrinter *pr, YkRef value)
{
    const YkValue *v = yk_printer_at(pr, value);
    if (v->op == YK_VALUE_MINUS) return false;
    if (pr->count[value] > 1 || (v->name && pr->count[value] > 0)) return true;
    return weight(pr, value) > INLINE_MAX;
}

static void statement(YkPrinter *pr, YkRef value, const char **call_names)
{
    YkValue v = *yk_printer_at(pr, value);
    if (pr->local[value]) return;
    if ((v.op == YK_VALUE_SINE || v.op == YK_VALUE_COSINE) && !pr->in_machine) {
        heading(pr, v.section);
        declare_pair(pr, v.op == YK_VALUE_SINE ? value : v.b);
    } else if (v.op == YK_VALUE_RESULT) {
        if (!call_names[v.a]) heading(pr, pr->graph->calls[v.a].section);
        pr->local[value] = yk_graph_text(pr->graph, "%s[%d]", ensure_call(pr, v.a, call_names), (int)v.b);
    } else if (needs_variable(pr, value)) {
        heading(pr, v.section);
        declare(pr, value, yk_printer_unique(pr, v.name ? v.name : yk_graph_text(pr->graph, "t%d", (int)value)));
    }
}

static void keep(YkPrinter *pr, YkRef leaf)
{
    if (pr->count[leaf] == 0 || pr->local[leaf]) return;
    const char *name = yk_printer_unique(pr, yk_graph_text(pr->graph, "t%d", (int)leaf));
    yk_text_format(pr->out, "    const %s %s = ", yk_printer_real(pr), name);
    yk_printer_value(pr, leaf);
    yk_text_puts(pr->out, ";\n");
    pr->local[leaf] = name;
}

void yk_printer_body(YkPrinter *pr, const YkRef *roots, size_t count)
{
    yk_printer_begin(pr, roots, count);
    const char **names = calloc(pr->graph->call_count + 1, sizeof *names);
    if (!names) {
        pr->failed = true;
        return;
    }
    for (size_t k = 0; k < pr->written_count; k++) keep(pr, pr->written[k]);
    for (size_t k = 0; k < pr->room - 1; k++)
        if (pr->marked[k] && !pr->failed) statement(pr, (YkRef)k, names);
    free(names);
}

static int by_ref(const void *a, const void *b)
{
    return *(const YkRef *)a < *(const YkRef *)b ? -1 : *(const YkRef *)a > *(const YkRef *)b;
}

void yk_printer_machine(YkPrinter *pr)
{
    pr->in_machine = true;
    if (pr->field_count > 0) qsort(pr->fields, pr->field_count, sizeof *pr->fields, by_ref);
    yk_printer_begin(pr, pr->fields, pr->field_count);
    for (size_t k = 0; k < pr->field_count; k++) { // fields have their names already
        YkRef field = pr->fields[k];
        for (YkRef v = k == 0 ? 0 : pr->fields[k - 1] + 1; v < field; v++)
            if (pr->marked[v] && needs_variable(pr, v))
                declare(pr, v,
                        yk_printer_unique(pr, yk_printer_at(pr, v)->name ? yk_printer_at(pr, v)->name
                                                                         : yk_graph_text(pr->graph, "t%d", (int)v)));
        size_t from = pr->out->length;
        yk_text_format(pr->out, "    %s%s = ", pr->file->machine, pr->field[field]);
        yk_printer_written(pr, field);
        yk_text_puts(pr->out, ";");
        yk_printer_wrap(pr, from);
        yk_text_puts(pr->out, "\n");
        pr->local[field] = yk_graph_text(pr->graph, "%s%s", pr->file->machine, pr->field[field]);
    }
    pr->in_machine = false;
}
