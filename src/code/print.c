#include "code/print.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/number.h"
#include "expr/function.h"

enum { INLINE_MAX = 9, LINE_MAX_LENGTH = 112 }; // operations in one expression; columns

static const YkValue *value_of(const YkPrinter *pr, YkRef value)
{
    return &pr->program->graph.values[value];
}

bool yk_printer_start(YkPrinter *pr, YkProgram *program, const char *prefix, bool single, YkText *out)
{
    *pr = (YkPrinter){.program = program, .prefix = prefix, .single = single, .out = out};
    size_t n = pr->room = program->graph.count + 1;
    pr->field = calloc(n, sizeof *pr->field);
    pr->marked = calloc(n, sizeof *pr->marked);
    pr->count = calloc(n, sizeof *pr->count);
    pr->local = calloc(n, sizeof *pr->local);
    pr->call_done = calloc(program->graph.call_count + 1, sizeof *pr->call_done);
    return pr->field && pr->marked && pr->count && pr->local && pr->call_done;
}

void yk_printer_end(YkPrinter *pr)
{
    free(pr->field);
    free(pr->fields);
    free(pr->marked);
    free(pr->count);
    free(pr->local);
    free(pr->call_done);
    yk_names_free(&pr->taken);
}

// --- numbers and names
// ----------------------------------------------------------------------------------------------------

void yk_printer_number(YkPrinter *pr, double number)
{
    char text[YK_NUMBER_SIZE];
    if (pr->single)
        yk_number_write_digits(number, 9, text);
    else
        yk_number_write(number, text);
    yk_text_puts(pr->out, text);
    if (!strpbrk(text, ".en")) yk_text_puts(pr->out, ".0");
    if (pr->single) yk_text_puts(pr->out, "f");
}

// A name for a variable that nothing else has.
static const char *unique(YkPrinter *pr, const char *wish)
{
    static const char *const reserved[] = {"m", "c", "in", "out", "i", "n", "known", "x", "status", "margin", NULL};
    const char *name = wish;
    int32_t existing;
    for (int k = 2;; k++) {
        bool is_reserved = false;
        for (size_t i = 0; reserved[i]; i++) is_reserved = is_reserved || strcmp(reserved[i], name) == 0;
        if (!is_reserved && yk_names_find(&pr->taken, name) == YK_NONE) break;
        name = yk_program_text(pr->program, "%s_%d", wish, k);
    }
    if (!yk_names_add(&pr->taken, name, 0, &existing)) pr->failed = true;
    return name;
}

static const char *real(const YkPrinter *pr)
{
    return pr->single ? "float" : "double";
}

// --- what is needed
// -------------------------------------------------------------------------------------------------------

static int32_t cut_of(const YkPrinter *pr, YkRef value)
{
    for (size_t k = 0; k < pr->cut_count; k++)
        if (pr->cut[k] == value) return (int32_t)k;
    return -1;
}

// Does it stand for itself: a number, a leaf, a value of the machine, an element of `known`?
static bool is_given(const YkPrinter *pr, YkRef value)
{
    const YkValue *v = value_of(pr, value);
    if (v->op == YK_VALUE_NUMBER || v->op == YK_VALUE_LEAF) return true;
    if (pr->cut && cut_of(pr, value) >= 0) return true;
    return v->of_parameters && !pr->in_machine;
}

static void mark_call(YkPrinter *pr, int32_t index);

static void mark(YkPrinter *pr, YkRef value)
{
    pr->count[value]++;
    if (pr->marked[value] || is_given(pr, value)) return;
    pr->marked[value] = true;
    const YkValue *v = value_of(pr, value);
    if (v->op == YK_VALUE_RESULT) {
        mark_call(pr, v->a);
        return;
    }
    const YkRef operands[] = {v->a, v->b, v->c};
    for (size_t k = 0; k < 3; k++)
        if (operands[k] >= 0) mark(pr, operands[k]);
}

enum { KNOWN_MAX = 512 };

static void mark_call(YkPrinter *pr, int32_t index)
{
    if (pr->call_done[index]) return;
    pr->call_done[index] = true;
    YkCall call = pr->program->graph.calls[index];
    for (size_t k = 0; k < call.argument_count; k++) mark(pr, call.arguments[k]);
    if (call.kind != YK_CALL_GROUP) return;
    YkRef known[KNOWN_MAX];
    size_t count = yk_printer_group_known(pr, (size_t)call.index, known, KNOWN_MAX);
    for (size_t k = 0; k < count && k < KNOWN_MAX; k++) {
        mark(pr, known[k]);
        pr->count[known[k]]++; // an element of an array: a variable of its own
    }
}

static void begin(YkPrinter *pr, const YkRef *roots, size_t count)
{
    memset(pr->marked, 0, pr->room * sizeof *pr->marked);
    memset(pr->count, 0, pr->room * sizeof *pr->count);
    memset(pr->local, 0, pr->room * sizeof *pr->local);
    memset(pr->call_done, 0, (pr->program->graph.call_count + 1) * sizeof *pr->call_done);
    yk_names_free(&pr->taken);
    pr->section = -1;
    for (size_t k = 0; k < count; k++) mark(pr, roots[k]);
}

// The machine's value itself, or what it is the opposite of.
static void need_field(YkPrinter *pr, YkRef value)
{
    const YkValue *v = value_of(pr, value);
    if (!v->of_parameters || v->op == YK_VALUE_NUMBER || v->op == YK_VALUE_LEAF) return;
    if (v->op == YK_VALUE_MINUS) {
        need_field(pr, v->a);
        return;
    }
    if (pr->field[value]) return;
    pr->field[value] = ""; // named below, in order
    if (YK_ROOM(pr->fields, pr->field_count, pr->field_capacity))
        pr->fields[pr->field_count++] = value;
    else
        pr->failed = true;
}

void yk_printer_need(YkPrinter *pr, const YkRef *roots, size_t count)
{
    begin(pr, roots, count);
    for (size_t k = 0; k < pr->room - 1; k++)
        if (pr->count[k] > 0) need_field(pr, (YkRef)k);
}

// --- expressions
// ----------------------------------------------------------------------------------------------------------

typedef enum Rank { RANK_SUM = 1, RANK_PRODUCT, RANK_SIGN, RANK_PRIMARY } Rank;

static void expression(YkPrinter *pr, YkRef value, Rank least);

static Rank rank_of(const YkPrinter *pr, YkRef value)
{
    const YkValue *v = value_of(pr, value);
    if (v->op == YK_VALUE_NUMBER) return v->number < 0 ? RANK_SIGN : RANK_PRIMARY;
    if (v->op == YK_VALUE_MINUS) return RANK_SIGN;
    if (is_given(pr, value) || pr->local[value]) return RANK_PRIMARY;
    switch (v->op) {
    case YK_VALUE_ADD:
    case YK_VALUE_SUBTRACT:
        return RANK_SUM;
    case YK_VALUE_MULTIPLY:
    case YK_VALUE_DIVIDE:
    case YK_VALUE_WITNESS:
        return RANK_PRODUCT;
    default:
        return RANK_PRIMARY;
    }
}

static void call_helper(YkPrinter *pr, YkHelper helper, const char *name, YkRef a, YkRef b)
{
    pr->uses[helper] = true;
    yk_text_format(pr->out, "%s_%s(", pr->prefix, name);
    expression(pr, a, RANK_SUM);
    if (b >= 0) {
        yk_text_puts(pr->out, ", ");
        expression(pr, b, RANK_SUM);
    }
    yk_text_puts(pr->out, ")");
}

static void call_math(YkPrinter *pr, const char *name, YkRef a, YkRef b)
{
    yk_text_format(pr->out, "%s%s(", name, pr->single ? "f" : "");
    expression(pr, a, RANK_SUM);
    if (b >= 0) {
        yk_text_puts(pr->out, ", ");
        expression(pr, b, RANK_SUM);
    }
    yk_text_puts(pr->out, ")");
}

static void function(YkPrinter *pr, const YkValue *v)
{
    static const char *const own[] = {[YK_ABS] = "fabs", [YK_MIN] = "fmin", [YK_MAX] = "fmax"};
    if (v->function == YK_SIGN) {
        call_helper(pr, YK_HELPER_SIGN, "sign", v->a, -1);
        return;
    }
    bool is_own = v->function == YK_ABS || v->function == YK_MIN || v->function == YK_MAX;
    call_math(pr, is_own ? own[v->function] : yk_function_name(v->function), v->a, v->b);
}

static void operation(YkPrinter *pr, const YkValue *v)
{
    static const char *const signs[] = {
        [YK_VALUE_ADD] = " + ", [YK_VALUE_SUBTRACT] = " - ", [YK_VALUE_MULTIPLY] = " * ", [YK_VALUE_DIVIDE] = " / "};
    bool is_sum = v->op == YK_VALUE_ADD || v->op == YK_VALUE_SUBTRACT;
    expression(pr, v->a, is_sum ? RANK_SUM : RANK_PRODUCT);
    yk_text_puts(pr->out, signs[v->op]);
    expression(pr, v->b, is_sum ? RANK_PRODUCT : RANK_SIGN); // to the right as it was built
}

static void given(YkPrinter *pr, YkRef value)
{
    const YkValue *v = value_of(pr, value);
    int32_t known = pr->cut ? cut_of(pr, value) : -1;
    if (known >= 0)
        yk_text_format(pr->out, "known[%d]", (int)known);
    else if (v->op == YK_VALUE_LEAF && v->of_parameters)
        yk_text_format(pr->out, "%s%s", pr->in_machine ? "p->" : "m->p.", v->name);
    else if (v->op == YK_VALUE_LEAF)
        yk_text_puts(pr->out, v->name);
    else
        yk_text_format(pr->out, "m->%s", pr->field[value] ? pr->field[value] : "lost");
}

static void choose(YkPrinter *pr, const YkValue *v)
{
    yk_text_puts(pr->out, "(");
    expression(pr, v->a, RANK_SUM);
    yk_text_puts(pr->out, " < 0 ? ");
    expression(pr, v->b, RANK_SUM);
    yk_text_puts(pr->out, " : ");
    expression(pr, v->c, RANK_SUM);
    yk_text_puts(pr->out, ")");
}

static void written(YkPrinter *pr, YkRef value)
{
    const YkValue *v = value_of(pr, value);
    switch (v->op) {
    case YK_VALUE_ADD:
    case YK_VALUE_SUBTRACT:
    case YK_VALUE_MULTIPLY:
    case YK_VALUE_DIVIDE:
        operation(pr, v);
        break;
    case YK_VALUE_FUNCTION:
        function(pr, v);
        break;
    case YK_VALUE_POWER:
        call_math(pr, "pow", v->a, v->b);
        break;
    case YK_VALUE_SINE: // of the machine; a pose has them in pairs
        call_math(pr, "sin", v->a, -1);
        break;
    case YK_VALUE_COSINE:
        call_math(pr, "cos", v->a, -1);
        break;
    case YK_VALUE_ANGLE:
        call_helper(pr, YK_HELPER_ANGLE, "angle", v->a, v->b);
        break;
    case YK_VALUE_NEAREST:
        call_helper(pr, YK_HELPER_NEAREST, "nearest", v->a, v->b);
        break;
    case YK_VALUE_ROOT:
        call_helper(pr, YK_HELPER_ROOT, "root", v->a, -1);
        break;
    case YK_VALUE_PER_ROOT:
        call_helper(pr, YK_HELPER_PER_ROOT, "per_root", v->a, -1);
        break;
    case YK_VALUE_NONZERO:
        call_helper(pr, YK_HELPER_NONZERO, "nonzero", v->a, -1);
        break;
    case YK_VALUE_LEAST:
        call_helper(pr, YK_HELPER_LEAST, "least", v->a, v->b);
        break;
    case YK_VALUE_LARGEST:
        call_helper(pr, YK_HELPER_LARGEST, "largest", v->a, v->b);
        break;
    case YK_VALUE_SIZE:
        call_math(pr, "fabs", v->a, -1);
        break;
    case YK_VALUE_WITNESS:
        yk_text_puts(pr->out, "0 * ");
        expression(pr, v->a, RANK_SIGN);
        break;
    case YK_VALUE_CHOOSE:
        choose(pr, v);
        break;
    default:
        break;
    }
}

static void expression(YkPrinter *pr, YkRef value, Rank least)
{
    const YkValue *v = value_of(pr, value);
    bool in_brackets = rank_of(pr, value) < least;
    if (in_brackets) yk_text_puts(pr->out, "(");
    if (v->op == YK_VALUE_NUMBER) {
        yk_printer_number(pr, v->number);
    } else if (v->op == YK_VALUE_MINUS && !(pr->cut && cut_of(pr, value) >= 0)) {
        yk_text_puts(pr->out, "-");
        expression(pr, v->a, RANK_PRIMARY);
    } else if (pr->local[value]) {
        yk_text_puts(pr->out, pr->local[value]);
    } else if (is_given(pr, value)) {
        given(pr, value);
    } else {
        written(pr, value);
    }
    if (in_brackets) yk_text_puts(pr->out, ")");
}

void yk_printer_value(YkPrinter *pr, YkRef value)
{
    expression(pr, value, RANK_SUM);
}

// --- statements
// -----------------------------------------------------------------------------------------------------------

// How many operations stand in its expression as it would be written.
static int weight(const YkPrinter *pr, YkRef value)
{
    const YkValue *v = value_of(pr, value);
    if (value < 0 || is_given(pr, value) || pr->local[value]) return 0;
    if (v->op == YK_VALUE_MINUS) return weight(pr, v->a);
    int sum = 1;
    const YkRef operands[] = {v->a, v->b, v->c};
    for (size_t k = 0; k < 3; k++) sum += operands[k] >= 0 ? weight(pr, operands[k]) : 0;
    return sum;
}

// Comments stand before the first statement of their section.
static void heading(YkPrinter *pr, int32_t section)
{
    const char *text = pr->program->graph.sections[section];
    if (section == pr->section) return;
    pr->section = section;
    if (text) yk_text_format(pr->out, "\n    /* %s */\n", text);
}

// Breaks a line that is too long after a blank at its outermost places.
static void wrap(YkPrinter *pr, size_t from)
{
    size_t start = from;
    while (pr->out->length - start > LINE_MAX_LENGTH) {
        size_t at = start + LINE_MAX_LENGTH;
        while (at > start + 20 && pr->out->data[at] != ' ') at--;
        if (at <= start + 20) return;
        char *rest = yk_arena_copy(pr->program->arena, pr->out->data + at + 1, pr->out->length - at - 1);
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
    yk_text_format(pr->out, "    const %s %s = ", real(pr), name);
    written(pr, value);
    yk_text_puts(pr->out, ";");
    wrap(pr, from);
    yk_text_puts(pr->out, "\n");
    pr->local[value] = name;
}

// The sine and, right behind, the cosine of one angle.
static void declare_pair(YkPrinter *pr, YkRef sine)
{
    const YkValue *s = value_of(pr, sine), *c = value_of(pr, sine + 1);
    pr->uses[YK_HELPER_SINCOS] = true;
    pr->local[sine] = unique(pr, s->name ? s->name : yk_program_text(pr->program, "s%d", (int)sine));
    pr->local[sine + 1] = unique(pr, c->name ? c->name : yk_program_text(pr->program, "c%d", (int)sine));
    yk_text_format(pr->out, "    %s %s, %s;\n    %s_sincos(", real(pr), pr->local[sine], pr->local[sine + 1],
                   pr->prefix);
    expression(pr, s->a, RANK_SUM);
    yk_text_format(pr->out, ", &%s, &%s);\n", pr->local[sine], pr->local[sine + 1]);
}

// A row of values as the start of an array.
static void array(YkPrinter *pr, const char *name, const YkRef *values, size_t count, size_t size)
{
    size_t from = pr->out->length;
    yk_text_format(pr->out, "    %s %s[%d] = {", real(pr), name, (int)size);
    for (size_t k = 0; k < count; k++) {
        if (k > 0) yk_text_puts(pr->out, ", ");
        expression(pr, values[k], RANK_SUM);
    }
    yk_text_puts(pr->out, "};");
    wrap(pr, from);
    yk_text_puts(pr->out, "\n");
}

static const char *call_array(YkPrinter *pr, const YkCall *call)
{
    static const char *const endings[] = {"system", "solution", "law"};
    return unique(pr, yk_program_text(pr->program, "%s_%s", call->name, endings[call->kind]));
}

// Equations: the entries that are not zero, then the solution in their place.
static void call_solve(YkPrinter *pr, const YkCall *call, const char *name)
{
    pr->uses[YK_HELPER_SOLVE] = true;
    if (call->argument_count <= 24) {
        array(pr, name, call->arguments, call->argument_count, call->result_count);
    } else {
        yk_text_format(pr->out, "    %s %s[%d] = {0};\n", real(pr), name, (int)call->result_count);
        for (size_t k = 0; k < call->argument_count; k++) {
            if (yk_dag_is_number(&pr->program->graph, call->arguments[k], 0)) continue;
            size_t from = pr->out->length;
            yk_text_format(pr->out, "    %s[%d] = ", name, (int)k);
            expression(pr, call->arguments[k], RANK_SUM);
            yk_text_puts(pr->out, ";");
            wrap(pr, from);
            yk_text_puts(pr->out, "\n");
        }
    }
    yk_text_format(pr->out, "    %s[%d] = %s_equations(%d, %d, %s);\n", name, (int)call->result_count - 1, pr->prefix,
                   (int)call->n, (int)call->m, name);
}

static void call_group(YkPrinter *pr, const YkCall *call, const char *name)
{
    YkRef known[KNOWN_MAX];
    size_t count = yk_printer_group_known(pr, (size_t)call->index, known, KNOWN_MAX);
    const char *given_name = unique(pr, yk_program_text(pr->program, "%s_known", call->name));
    pr->uses[YK_HELPER_SOLVE] = true;
    array(pr, name, call->arguments, call->argument_count, call->result_count);
    if (count == 0) {
        yk_text_format(pr->out, "    const %s %s[1] = {0};\n", real(pr), given_name);
    } else {
        yk_text_puts(pr->out, "    const");
        array(pr, given_name, known, count, count);
    }
    yk_text_format(pr->out, "    %s_solve_%s(m, %s, %s);\n", pr->prefix, call->name, given_name, name);
}

static void call_law(YkPrinter *pr, const YkCall *call, const char *name)
{
    pr->uses[YK_HELPER_LAW] = true;
    yk_text_format(pr->out, "    %s %s[3];\n    %s_law_%s(", real(pr), name, pr->prefix, call->name);
    expression(pr, call->arguments[0], RANK_SUM);
    yk_text_format(pr->out, ", %s);\n", name);
}

// The call before its first result.
static const char *ensure_call(YkPrinter *pr, int32_t index, const char **names)
{
    YkCall call = pr->program->graph.calls[index];
    if (names[index]) return names[index];
    names[index] = call_array(pr, &call);
    if (call.kind == YK_CALL_SOLVE)
        call_solve(pr, &call, names[index]);
    else if (call.kind == YK_CALL_GROUP)
        call_group(pr, &call, names[index]);
    else
        call_law(pr, &call, names[index]);
    return names[index];
}

static bool needs_variable(const YkPrinter *pr, YkRef value)
{
    const YkValue *v = value_of(pr, value);
    if (v->op == YK_VALUE_MINUS) return false;
    if (pr->count[value] > 1 || (v->name && pr->count[value] > 0)) return true;
    return weight(pr, value) > INLINE_MAX;
}

static void statement(YkPrinter *pr, YkRef value, const char **call_names)
{
    YkValue v = *value_of(pr, value);
    if (pr->local[value]) return;
    if ((v.op == YK_VALUE_SINE || v.op == YK_VALUE_COSINE) && !pr->in_machine) {
        heading(pr, v.section);
        declare_pair(pr, v.op == YK_VALUE_SINE ? value : v.b);
    } else if (v.op == YK_VALUE_RESULT) {
        if (!call_names[v.a]) heading(pr, pr->program->graph.calls[v.a].section);
        pr->local[value] = yk_program_text(pr->program, "%s[%d]", ensure_call(pr, v.a, call_names), (int)v.b);
    } else if (needs_variable(pr, value)) {
        heading(pr, v.section);
        declare(pr, value, unique(pr, v.name ? v.name : yk_program_text(pr->program, "t%d", (int)value)));
    }
}

void yk_printer_body(YkPrinter *pr, const YkRef *roots, size_t count)
{
    begin(pr, roots, count);
    const char **names = calloc(pr->program->graph.call_count + 1, sizeof *names);
    if (!names) {
        pr->failed = true;
        return;
    }
    for (size_t k = 0; k < pr->room - 1; k++)
        if (pr->marked[k]) statement(pr, (YkRef)k, names);
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
    begin(pr, pr->fields, pr->field_count);
    for (size_t k = 0; k < pr->field_count; k++) { // fields have their names already
        YkRef field = pr->fields[k];
        for (YkRef v = k == 0 ? 0 : pr->fields[k - 1] + 1; v < field; v++)
            if (pr->marked[v] && needs_variable(pr, v))
                declare(pr, v,
                        unique(pr, value_of(pr, v)->name ? value_of(pr, v)->name
                                                         : yk_program_text(pr->program, "t%d", (int)v)));
        size_t from = pr->out->length;
        yk_text_format(pr->out, "    machine.%s = ", pr->field[field]);
        written(pr, field);
        yk_text_puts(pr->out, ";");
        wrap(pr, from);
        yk_text_puts(pr->out, "\n");
        pr->local[field] = yk_program_text(pr->program, "machine.%s", pr->field[field]);
    }
    pr->in_machine = false;
}
