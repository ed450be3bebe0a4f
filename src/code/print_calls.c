// Calls in the printed functions: equations, Newton's method for a group, laws.
#include "code/file.h"

static const char *call_array(YkPrinter *pr, const YkCall *call)
{
    static const char *const endings[] = {"system", "solution", "law", "friction", "system"};
    return yk_printer_unique(pr, yk_graph_text(pr->graph, "%s_%s", call->name, endings[call->kind]));
}

// Writes the entries of equations that are not zero, in an array with as many places as given.
static void write_system(YkPrinter *pr, const YkCall *call, const char *name, size_t places)
{
    if (call->argument_count <= 24) {
        yk_printer_array(pr, name, call->arguments, call->argument_count, places);
    } else {
        yk_text_format(pr->out, "    %s %s[%d] = {0};\n", yk_printer_real(pr), name, (int)places);
        for (size_t k = 0; k < call->argument_count; k++) {
            if (yk_graph_is_number(pr->graph, call->arguments[k], 0)) continue;
            size_t from = pr->out->length;
            yk_text_format(pr->out, "    %s[%d] = ", name, (int)k);
            yk_printer_value(pr, call->arguments[k]);
            yk_text_puts(pr->out, ";");
            yk_printer_wrap(pr, from);
            yk_text_puts(pr->out, "\n");
        }
    }
}

static void call_solve(YkPrinter *pr, const YkCall *call, const char *name)
{
    int n = (int)call->n, m = (int)call->m, last = n * (n + m);
    bool is_large = n > YK_FILE_SMALL_SYSTEM;
    pr->uses[YK_HELPER_SOLVE] = true;
    pr->uses[YK_HELPER_SINE] |= is_large;
    write_system(pr, call, name, (size_t)(last + 1 + (is_large ? n : 0)));
    yk_text_format(pr->out, "    %s[%d] = %s_equations(%d, %d, %s);\n", name, last, pr->prefix, n, m, name);
    if (!is_large) return;
    yk_text_format(pr->out, "    %s[%d] = %s_sine(%d, %d, %s, %s + %d, %s[%d]);\n", name, last, pr->prefix, n, n + m,
                   name, name, last + 1, name, last);
}

static void call_motion(YkPrinter *pr, const YkCall *call, const char *name)
{
    pr->uses[YK_HELPER_MOTION] = true;
    write_system(pr, call, name, call->result_count + (size_t)call->n);
    yk_text_format(pr->out, "    %s[%d] = %s_motion(%d, %s);\n", name, (int)call->argument_count, pr->prefix,
                   (int)call->n, name);
}

static void call_group(YkPrinter *pr, const YkCall *call, const char *name)
{
    YkRef known[YK_PRINTER_KNOWN_MAX];
    size_t count = yk_call_known(pr, call, known, YK_PRINTER_KNOWN_MAX);
    const char *given_name = yk_printer_unique(pr, yk_graph_text(pr->graph, "%s_known", call->name));
    pr->uses[YK_HELPER_SOLVE] = true;
    pr->uses[YK_HELPER_SINE] |= call->n > YK_FILE_SMALL_SYSTEM;
    yk_printer_array(pr, name, call->arguments, call->argument_count, call->result_count);
    if (count == 0) {
        yk_text_format(pr->out, "    const %s %s[1] = {0};\n", yk_printer_real(pr), given_name);
    } else {
        yk_text_puts(pr->out, "    const");
        yk_printer_array(pr, given_name, known, count, count);
    }
    yk_text_format(pr->out, "    %s_solve_%s(m, %s, %s);\n", pr->prefix, call->name, given_name, name);
}

static void call_law(YkPrinter *pr, const YkCall *call, const char *name)
{
    pr->uses[YK_HELPER_LAW] = true;
    yk_text_format(pr->out, "    %s %s[3];\n    %s_law_%s(", yk_printer_real(pr), name, pr->prefix, call->name);
    yk_printer_value(pr, call->arguments[0]);
    yk_text_format(pr->out, ", %s);\n", name);
}

static void call_friction(YkPrinter *pr, const YkCall *call, const char *name)
{
    int at = (int)call->argument_count, n = (int)call->n;
    pr->uses[YK_HELPER_FRICTION] = true;
    yk_printer_array(pr, name, call->arguments, call->argument_count, call->result_count);
    yk_text_format(pr->out, "    %s[%d] = %s_friction(%d, %d, %s, %s + %d);\n", name, at + 2 * n, pr->prefix, n,
                   (int)call->m, name, name, at);
}

const char *yk_call_print(YkPrinter *pr, const YkCall *call)
{
    const char *name = call_array(pr, call);
    if (call->kind == YK_CALL_SOLVE)
        call_solve(pr, call, name);
    else if (call->kind == YK_CALL_MOTION)
        call_motion(pr, call, name);
    else if (call->kind == YK_CALL_GROUP)
        call_group(pr, call, name);
    else if (call->kind == YK_CALL_FRICTION)
        call_friction(pr, call, name);
    else
        call_law(pr, call, name);
    return name;
}
