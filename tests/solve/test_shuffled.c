// The examples with their bodies and joints in other orders: the same freedoms, as many loops and redundant
// constraints, and the same motion of every point.
#include "../examples.h"
#include "compile/mechanism.h"
#include "solve/machine.h"

enum { TEXT_MAX = 20000, LINES_MAX = 60 };

static Machine machine_of(const char *text)
{
    Machine m = {.problems = yk_problems_new()};
    m.model = yk_model_parse(text, strlen(text), "test.yaml", NULL, m.problems);
    m.mech = m.model ? yk_mechanism_compile(m.model, NULL, m.problems) : NULL;
    m.state = m.mech ? yk_state_new(m.mech) : NULL;
    return m;
}

// Shuffles the lines of a section whose entries take one line each. Returns whether there are any.
static bool shuffle(char *text, const char *section, uint64_t *seed)
{
    static char copy[TEXT_MAX];
    const char *line[LINES_MAX], *start = strstr(text, section), *at;
    size_t length[LINES_MAX], count = 0;
    if (!start) return false;
    start += strlen(section);
    for (at = start; strncmp(at, "  ", 2) == 0 && count < LINES_MAX; at += length[count++]) {
        if (at[2] == ' ' || at[2] == '#') return false; // the one before goes on
        line[count] = at;
        length[count] = strcspn(at, "\n") + 1;
        if (!memchr(at, '}', length[count])) return false;
    }
    for (size_t k = count; k > 1; k--) {
        size_t other = check_random(seed) % k, own = length[k - 1];
        const char *kept = line[k - 1];
        line[k - 1] = line[other], length[k - 1] = length[other];
        line[other] = kept, length[other] = own;
    }
    char *out = copy;
    for (size_t k = 0; k < count; out += length[k++]) memcpy(out, line[k], length[k]);
    memcpy(text + (start - text), copy, (size_t)(out - copy));
    return count > 1;
}

static bool have_same_inputs(const Machine *a, const Machine *b)
{
    for (size_t k = 0; k < yk_input_count(a->mech); k++) {
        const char *name = yk_coordinate_info(a->mech, yk_input_coordinate(a->mech, k)).name;
        size_t found = yk_coordinate_find(b->mech, name);
        if (found == YK_NOT_FOUND || yk_coordinate_info(b->mech, found).input < 0) return false;
    }
    return true;
}

// Compares rates and accelerations too, over the largest of them.
static void check_points(const Machine *a, const Machine *b, const char *file)
{
    double most[3] = {yk_mechanism_size(a->mech), 0, 0};
    for (int pass = 0; pass < 2; pass++)
        for (size_t k = 0; k < yk_model_point_count(a->model); k++) {
            char name[128];
            snprintf(name, sizeof name, "%s.%s", yk_model_body_name(a->model, yk_model_point_body(a->model, k)),
                     yk_model_point_name(a->model, k));
            size_t other = yk_model_find_point(b->model, name);
            assert_true(other != YK_NOT_FOUND);
            YkPointMotion p = yk_state_point(a->state, k), q = yk_state_point(b->state, other);
            const double *own[] = {p.position, p.velocity, p.acceleration};
            const double *found[] = {q.position, q.velocity, q.acceleration};
            for (int order = 0; order < 3; order++)
                for (int axis = 0; axis < 2; axis++) {
                    if (pass == 0) most[order] = fmax(most[order], fabs(own[order][axis]));
                    double off = fabs(own[order][axis] - found[order][axis]);
                    if (pass == 1 && off > 1e-8 * most[order]) {
                        print_error("%s: %s, order %d: %.17g, not %.17g\n", file, name, order, found[order][axis],
                                    own[order][axis]);
                        fail();
                    }
                }
        }
}

// Returns whether motion was compared.
static bool check_motion(const Machine *a, const Machine *b, const char *file)
{
    if (!have_same_inputs(a, b) || yk_state_set_time(a->state, 0, a->problems) < 0) return false;
    assert_int_equal(yk_state_set_time(b->state, 0, b->problems), YK_OK);
    if (yk_state_assemble(a->state) != YK_OK) return false;
    assert_int_equal(yk_state_assemble(b->state), YK_OK);
    if (yk_state_set_time(a->state, 0.01, a->problems) < 0) return false;
    assert_int_equal(yk_state_set_time(b->state, 0.01, b->problems), YK_OK);
    if (yk_state_solve(a->state) != YK_OK) return false;
    assert_int_equal(yk_state_solve(b->state), YK_OK);
    check_points(a, b, file);
    return true;
}

// Freedoms by Gruebler's count with the constraints of each kind of joint; nothing is told beyond the last of anything.
static void check_counts(const Machine *m, const char *file)
{
    const YkMechanism *mech = m->mech;
    YkFreedom f = yk_mechanism_freedom(mech);
    size_t driven = 0, blocks = yk_block_count(mech);
    int gruebler = 3 * ((int)yk_model_body_count(m->model) - 1);
    for (size_t k = 0; k < yk_coordinate_count(mech); k++) driven += yk_coordinate_info(mech, k).has_drive;
    for (size_t k = 0; k < yk_model_joint_count(m->model); k++) {
        const char *kind = yk_model_joint_kind(m->model, k);
        gruebler -= !strcmp(kind, "weld") ? 3 : !strcmp(kind, "pin-slot") ? 1 : !strcmp(kind, "free") ? 0 : 2;
    }
    bool is_plain = yk_contact_count(mech) == 0 && m->model->follow_count == 0 && m->model->lock_count == 0;
    if (is_plain && f.gruebler != gruebler) print_error("%s: %d freedoms, not %d\n", file, f.gruebler, gruebler);
    if (is_plain) assert_int_equal(f.gruebler, gruebler);
    assert_int_equal(f.driven, driven);
    assert_int_equal(f.by_rank, yk_input_count(mech));
    assert_int_equal((int)f.redundant, f.by_rank - f.gruebler);
    for (size_t b = 0; b <= blocks; b++) {
        YkBlockInfo info = yk_block_info(mech, b);
        assert_int_equal(info.label == NULL, b == blocks);
        for (size_t k = 0; k < info.joint_count; k++)
            assert_true(yk_block_joint(mech, b, k) < yk_model_joint_count(m->model));
        for (size_t k = 0; k < info.body_count; k++)
            assert_true(yk_block_body(mech, b, k) < yk_model_body_count(m->model));
        for (size_t k = 0; k < info.relation_count; k++) assert_non_null(yk_block_relation(mech, b, k));
        assert_true(yk_block_joint(mech, b, info.joint_count) == YK_NOT_FOUND);
        assert_true(yk_block_body(mech, b, info.body_count) == YK_NOT_FOUND);
        assert_null(yk_block_relation(mech, b, info.relation_count));
        if (info.kind == YK_BLOCK_RRR && info.label) assert_in_range(info.body_count, 1, 20);
    }
    assert_true(yk_loop_joint(mech, yk_loop_count(mech)) == YK_NOT_FOUND);
    assert_true(yk_input_coordinate(mech, yk_input_count(mech)) == YK_NOT_FOUND);
    assert_true(yk_redundant_joint(mech, yk_redundant_count(mech)) == YK_NOT_FOUND);
}

static size_t check_file(const char *file, size_t number)
{
    uint64_t seed = number;
    static char text[TEXT_MAX], other[TEXT_MAX];
    FILE *in = fopen(file, "rb");
    assert_non_null(in);
    size_t length = fread(text, 1, sizeof text - 1, in), moved = 0;
    text[length] = 0;
    fclose(in);
    Machine a = machine_of(text);
    if (a.mech) check_counts(&a, file);
    for (int k = 0; k < 3 && a.mech; k++) {
        strcpy(other, text);
        bool has_other = shuffle(other, "\nbodies:\n", &seed);
        has_other |= shuffle(other, "\njoints:\n", &seed);
        if (!has_other) break;
        Machine b = machine_of(other);
        if (!b.mech) print_error("%s\n%s", file, yk_problems_text(b.problems, 0));
        assert_non_null(b.mech);
        YkFreedom f = yk_mechanism_freedom(a.mech), g = yk_mechanism_freedom(b.mech);
        if (memcmp(&f, &g, sizeof f) != 0)
            print_error("%s: %d %d %zu %zu, then %d %d %zu %zu\n", file, f.gruebler, f.by_rank, f.redundant, f.driven,
                        g.gruebler, g.by_rank, g.redundant, g.driven);
        assert_memory_equal(&f, &g, sizeof f);
        assert_int_equal(yk_loop_count(a.mech), yk_loop_count(b.mech));
        assert_int_equal(yk_redundant_count(a.mech) > 0, yk_redundant_count(b.mech) > 0);
        CHECK_NEAR(yk_mechanism_size(a.mech), yk_mechanism_size(b.mech), 1e-15 * yk_mechanism_size(a.mech));
        moved += check_motion(&a, &b, file);
        machine_free(&b);
    }
    machine_free(&a);
    return moved;
}

static void examples_in_other_orders(void **unused)
{
    (void)unused;
    assert_true(each_example(check_file) > 60);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(examples_in_other_orders),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
