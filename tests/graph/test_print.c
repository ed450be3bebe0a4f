// The printed C of random graphs, read back and computed, has the bits of the graph's own values, and does each
// operation once.
#include "graph/printed_c.h"
#include "graph/print.h"

enum { LEAVES = 5, PARAMETERS = 3, GIVEN = LEAVES + PARAMETERS, VALUES = 70, ROOTS = 6 };

typedef struct Case {
    YkArena *arena;
    YkGraph graph;
    YkRef given[GIVEN], roots[ROOTS];
    double is[GIVEN];
} Case;

static YkRef combine(YkGraph *g, uint64_t *seed, YkRef a, YkRef b, YkRef c)
{
    static const YkFunction functions[] = {YK_SIN, YK_ATAN, YK_ABS, YK_SIGN, YK_TANH};
    YkRef size = yk_graph_unary(g, YK_VALUE_NONZERO, b);
    switch (check_random(seed) % 20) {
    case 0:
        return yk_graph_add(g, a, yk_graph_multiply(g, b, c));
    case 1:
        return yk_graph_subtract(g, a, yk_graph_subtract(g, b, c));
    case 2:
        return yk_graph_subtract(g, yk_graph_multiply(g, a, b), c);
    case 3:
        return yk_graph_multiply(g, yk_graph_add(g, a, b), yk_graph_subtract(g, a, c));
    case 4:
        return yk_graph_divide(g, a, yk_graph_multiply(g, size, yk_graph_number(g, 3)));
    case 5:
        return yk_graph_divide(g, yk_graph_divide(g, a, size), yk_graph_divide(g, size, yk_graph_number(g, 7)));
    case 6:
        return yk_graph_minus(g, yk_graph_multiply(g, a, yk_graph_minus(g, b)));
    case 7:
        return yk_graph_choose(g, a, b, c);
    case 8:
        return yk_graph_unit(g, a).x;
    case 9:
        return yk_graph_unit(g, b).y;
    case 10:
        return yk_graph_function(g, functions[check_random(seed) % 5], a, YK_NONE);
    case 11:
        return yk_graph_function(g, check_random(seed) % 2 ? YK_MIN : YK_MAX, a, b);
    case 12:
        return yk_graph_function(g, YK_ATAN2, a, b);
    case 13:
        return yk_graph_unary(g, check_random(seed) % 2 ? YK_VALUE_ROOT : YK_VALUE_PER_ROOT, a);
    case 14:
        return yk_graph_binary(g, check_random(seed) % 2 ? YK_VALUE_LEAST : YK_VALUE_LARGEST, a, b);
    case 15:
        return yk_graph_binary(g, check_random(seed) % 2 ? YK_VALUE_ANGLE : YK_VALUE_NEAREST, a, b);
    case 16:
        return yk_graph_power(g, size, yk_graph_number(g, 0.3));
    case 17:
        return yk_graph_multiply(g, yk_graph_number(g, -2.5), a);
    case 18:
        return yk_graph_unary(g, YK_VALUE_SIZE, a);
    default: {
        YkRef *argument = YK_NEW(g->arena, YkRef, 1);
        assert_non_null(argument);
        *argument = a;
        YkCall call = {
            .kind = YK_CALL_LAW, .arguments = argument, .argument_count = 1, .result_count = 3, .name = "law"};
        int32_t law = yk_graph_call(g, call);
        return yk_graph_result(g, law, check_random(seed) % 3);
    }
    }
}

static void start(Case *c, uint64_t *seed)
{
    YkRef values[GIVEN + VALUES];
    c->arena = yk_arena_new();
    assert_true(c->arena && yk_graph_start(&c->graph, c->arena));
    for (int k = 0; k < GIVEN; k++) {
        const char *name = yk_graph_text(&c->graph, "%s%d", k < LEAVES ? "x" : "p", k);
        values[k] = c->given[k] = yk_graph_leaf(&c->graph, k < LEAVES ? YK_LEAF_POSE : YK_LEAF_PARAMETER, name);
        c->is[k] = check_uniform(seed, -1.5, 1.5);
    }
    for (int k = GIVEN; k < GIVEN + VALUES; k++) {
        size_t n = k < GIVEN + 12 ? 3 : (size_t)k; // the first ones of parameters alone
        size_t low = k < GIVEN + 12 ? LEAVES : 0;
        if (k == GIVEN + 20) yk_graph_section(&c->graph, "the second part");
        values[k] = combine(&c->graph, seed, values[low + check_random(seed) % n], values[low + check_random(seed) % n],
                            values[low + check_random(seed) % n]);
        if (check_random(seed) % 5 == 0) yk_graph_name(&c->graph, values[k], "v%d", k % 7); // some names twice
    }
    for (int k = 0; k < ROOTS; k++) c->roots[k] = values[GIVEN + VALUES - 1 - check_random(seed) % (VALUES / 2)];
}

static void end(Case *c)
{
    yk_graph_end(&c->graph);
    yk_arena_free(c->arena);
}

static YkRef printed_laws[VALUES]; // the arguments of those that were printed
static size_t printed_law_count;

static const char *print_law(YkPrinter *printer, const YkCall *call)
{
    printed_laws[printed_law_count++] = call->arguments[0];
    const char *name = yk_printer_unique(printer, call->name);
    yk_text_format(printer->out, "    square %s = ", name);
    yk_printer_value(printer, call->arguments[0]);
    yk_text_puts(printer->out, ";\n");
    return name;
}

static size_t know_nothing(YkPrinter *printer, const YkCall *call, YkRef *known, size_t capacity)
{
    (void)printer, (void)call, (void)known, (void)capacity;
    return 0;
}

static const YkPrinterFile file = {
    .parameter = "m->", .own_parameter = "m->", .machine = "m->", .call = print_law, .call_known = know_nothing};

// Values of the graph; results of the law 3 x^2 too.
static double *evaluate(const Case *c)
{
    const YkGraph *g = &c->graph;
    double *numbers = calloc(g->count, sizeof *numbers);
    assert_non_null(numbers);
    for (int k = 0; k < GIVEN; k++) numbers[c->given[k]] = c->is[k];
    for (size_t k = 0; k < g->count; k++) {
        const YkValue *v = &g->values[k];
        if (v->op == YK_VALUE_LEAF) continue;
        if (v->op == YK_VALUE_RESULT) {
            double x = numbers[g->calls[v->a].arguments[0]];
            numbers[k] = v->b == 0 ? 3 * x * x : v->b == 1 ? 6 * x : 6;
            continue;
        }
        numbers[k] = graph_operate(v, v->a >= 0 ? numbers[v->a] : 0, v->b >= 0 ? numbers[v->b] : 0,
                                   v->c >= 0 ? numbers[v->c] : 0);
    }
    return numbers;
}

static Printed *read_given(const Case *c)
{
    Printed *p = calloc(1, sizeof *p);
    assert_non_null(p);
    for (int k = 0; k < GIVEN; k++) {
        char name[PRINTED_LENGTH];
        snprintf(name, sizeof name, "%s%s%d", k < LEAVES ? "" : "m->", k < LEAVES ? "x" : "p", k);
        printed_declare(p, name, c->is[k], 0);
    }
    return p;
}

static void check_lines(const char *text)
{
    for (const char *line = text, *end; line; line = end ? end + 1 : NULL) {
        end = strchr(line, '\n');
        size_t length = strcspn(line, "\n");
        if (length > 120) print_error("a line of %zu columns: %.*s\n", length, (int)length, line);
        assert_true(length <= 120);
    }
}

// Each variable saves something: it has a name of its own, is used twice, or its expression would be long. Together
// they do each operation once.
static void check_savings(const Case *c, const Printed *p, size_t from)
{
    size_t operations = p->operations;
    bool is_cosine = false;
    for (size_t k = from; k < p->count; k++) {
        const char *name = p->names[k].name;
        bool is_result = strchr(name, '['), is_named = name[0] != 't';
        bool is_pair = p->names[k].is_pair, is_sine = is_pair && k + 1 < p->count && !is_cosine;
        is_cosine = is_sine;                                             // the next one
        operations += is_sine && p->names[k + 1].uses > 0 ? 2 : is_sine; // a cosine comes with its sine
        if (is_result || is_pair) continue;
        assert_true(p->names[k].uses > (is_named || p->names[k].weight > 9 ? 0 : 1));
    }
    YkRef all[ROOTS + VALUES];
    size_t count = ROOTS;
    memcpy(all, c->roots, sizeof c->roots);
    for (size_t k = 0; k < printed_law_count; k++) all[count++] = printed_laws[k];
    assert_int_equal(operations, yk_graph_cost(&c->graph, all, count));
}

static void check_case(Case *c)
{
    YkPrinter printer;
    YkText out = {0};
    double *numbers = evaluate(c);
    Printed *p = read_given(c);
    assert_true(yk_printer_start(&printer, &c->graph, &file, "P", false, &out));
    yk_printer_need(&printer, c->roots, ROOTS);
    for (size_t k = 0; k < printer.field_count; k++)
        printer.field[printer.fields[k]] = yk_graph_text(&c->graph, "constant[%z]", k);
    yk_printer_machine(&printer);
    check_lines(yk_text_get(&out));
    printed_run(p, out.data, "double");
    for (size_t k = 0; k < printer.field_count; k++) {
        char name[PRINTED_LENGTH];
        snprintf(name, sizeof name, "m->constant[%zu]", k);
        double found = printed_value(p, name);
        assert_memory_equal(&found, &numbers[printer.fields[k]], sizeof found);
    }
    size_t given = GIVEN; // what the other function declared for itself is not known here
    for (size_t k = GIVEN; k < p->count; k++)
        if (strncmp(p->names[k].name, "m->", 3) == 0) p->names[given++] = p->names[k];
    p->count = given;
    p->operations = printed_law_count = 0;
    yk_text_clear(&out);
    yk_printer_body(&printer, c->roots, ROOTS);
    check_lines(yk_text_get(&out));
    printed_run(p, out.data, "double");
    for (int k = 0; k < ROOTS; k++) {
        yk_text_clear(&out);
        yk_printer_value(&printer, c->roots[k]);
        double found = printed_value(p, yk_text_get(&out));
        if (memcmp(&found, &numbers[c->roots[k]], sizeof found) != 0 &&
            !(isnan(found) && isnan(numbers[c->roots[k]]))) {
            print_error("%s is %.17g, not %.17g\n", yk_text_get(&out), found, numbers[c->roots[k]]);
            fail();
        }
    }
    check_savings(c, p, given);
    assert_false(printer.failed);
    yk_printer_end(&printer);
    yk_text_free(&out);
    free(numbers);
    free(p);
}

static void random_graphs_are_printed(void **state)
{
    (void)state;
    for (uint64_t k = 0; k < check_cases(300); k++) {
        Case c = {0};
        uint64_t seed = 100 + k;
        start(&c, &seed);
        check_case(&c);
        end(&c);
    }
}

// Numbers are literals of their type, which read back to the same bits; functions of the single type have own names.
static void numbers_read_back(void **state)
{
    (void)state;
    Case c = {0};
    uint64_t seed = 7;
    start(&c, &seed);
    for (int single = 0; single < 2; single++) {
        YkPrinter printer;
        YkText out = {0};
        assert_true(yk_printer_start(&printer, &c.graph, &file, "P", single == 1, &out));
        yk_printer_begin(&printer, c.given, GIVEN);
        for (int k = 0; k < 200; k++) {
            double number = k < 3 ? k : ldexp(check_uniform(&seed, -1, 1), (int)(check_random(&seed) % 80) - 40);
            char *end;
            if (single) number = (double)(float)number;
            yk_text_clear(&out);
            yk_printer_number(&printer, number);
            const char *text = yk_text_get(&out);
            assert_true(strpbrk(text, ".e") != NULL);
            if (single)
                assert_true(strtof(text, &end) == (float)number);
            else
                assert_true(strtod(text, &end) == number);
            assert_string_equal(end, single ? "f" : "");
        }
        yk_text_clear(&out);
        yk_printer_value(&printer, yk_graph_function(&c.graph, YK_ATAN2, c.given[0], c.given[1]));
        assert_string_equal(yk_text_get(&out), single ? "atan2f(x0, x1)" : "atan2(x0, x1)");
        yk_printer_end(&printer);
        yk_text_free(&out);
    }
    end(&c);
}

// An array begins with its values, in their order, in lines of the usual length.
static void arrays_are_declared_with_their_values(void **state)
{
    (void)state;
    Case c = {0};
    YkPrinter printer;
    YkText out = {0};
    uint64_t seed = 9;
    start(&c, &seed);
    assert_true(yk_printer_start(&printer, &c.graph, &file, "P", false, &out));
    yk_printer_begin(&printer, c.given, GIVEN);
    YkRef values[40];
    for (int k = 0; k < 40; k++) values[k] = c.given[k % GIVEN];
    yk_printer_array(&printer, "row", values, 3, 7);
    assert_string_equal(yk_text_get(&out), "    double row[7] = {x0, x1, x2};\n");
    yk_text_clear(&out);
    yk_printer_array(&printer, "row", values, 40, 40);
    check_lines(yk_text_get(&out));
    printed_join(out.data);
    size_t commas = 0;
    for (const char *at = out.data; *at; at++) commas += *at == ',';
    assert_int_equal(commas, 39);
    assert_non_null(strstr(out.data, " m->p7, x0, x1, x2, x3, x4, m->p5, m->p6, m->p7};"));
    yk_printer_end(&printer);
    yk_text_free(&out);
    end(&c);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(random_graphs_are_printed),
        cmocka_unit_test(numbers_read_back),
        cmocka_unit_test(arrays_are_declared_with_their_values),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
