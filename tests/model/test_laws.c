// `laws:` motion programs and tables.
#include <stdlib.h>
#include "model/fixture.h"
#include "model/laws/laws.h"

#define MACHINE                                                                                                        \
    "bodies: {crank: {}, ram: {}}\n"                                                                                   \
    "joints: {O: {pin: [ground, crank], angle: theta}, R: {slide: [ground, ram], along: x, distance: d}}\n"
#define DEG (YK_PI / 180)

static const YkModelLaw *find_law(const YkModel *model, const char *name)
{
    for (size_t i = 0; i < model->law_count; i++) {
        if (strcmp(model->laws[i].name, name) == 0) return &model->laws[i];
    }
    fail_msg("no law %s", name);
    return NULL;
}

static double value(const YkModel *model, const char *name, double x, int order)
{
    double d[YK_LAW_ORDER + 1];
    yk_law_eval(find_law(model, name)->law, x, d);
    return d[order];
}

static char *read_example(const char *name)
{
    char path[500];
    snprintf(path, sizeof path, YOKE_ROOT "/examples/%s", name);
    FILE *file = fopen(path, "rb");
    assert_non_null(file);
    char *text = calloc(1, 20000);
    assert_true(fread(text, 1, 19999, file) > 0);
    fclose(file);
    return text;
}

// The cam of the format without its `cams:`, which belong to a later version.
static void the_laws_of_the_cep_cam_load(void **state)
{
    (void)state;
    char *text = read_example("cep-cam.yaml"), *cams = strstr(text, "cams:"), *bodies = strstr(text, "bodies:");
    assert_true(cams && bodies && cams < bodies);
    memmove(cams, bodies, strlen(bodies) + 1);
    YkModel *model = fixture_load(text);
    assert_int_equal(model->law_count, 1);
    for (double x = 0; x < 2 * YK_PI; x += 0.01) {
        double u = x / (4 * YK_PI / 3), s = u > 1 ? 0 : 0.2 * u * u * u * (64 - 192 * u + 192 * u * u - 64 * u * u * u);
        CHECK_NEAR(value(model, "lift", x, 0), s, 1e-14);
    }
    const YkModelLaw *law = find_law(model, "lift");
    assert_int_equal(law->of.angle, 1);
    assert_int_equal(law->value.length, 1);
    CHECK_NEAR(yk_law_range(law->law).period, 2 * YK_PI, 0);
    assert_int_equal(yk_law_segment(law->law, 0).condition_count, 7);
    assert_int_equal(law->source->parts[0].given_count, 3); // as the file gives them, for a derivation
    assert_non_null(law->source->parts[0].given[2].d[2].expr);
    yk_model_free(model);
    free(text);
}

static void every_segment_is_read_in_the_units_of_the_file(void **state)
{
    (void)state;
    YkModel *model = fixture_load(
        "units: {length: mm, angle: deg}\nparameters: {h: 20, beta: 90, slope: 0.1}\nlaws:\n  lift:\n    period: 360\n"
        "    segments:\n      - {rise: {to: beta, by: h, law: modified-sine}}\n      - {dwell: {to: beta + 10}}\n"
        "      - {constant-velocity: {to: 120, v: slope}}\n      - {dwell: {to: 150}}\n"
        "      - {fall: {to: 200, by: 2 mm, law: scca, scca: {b: 0.5, c: 0, d: 0.5}}}\n"
        "      - {spline: [{at: 200, s: h, v: 0, a: 0}, {at: 230, s: 15}, {at: 260, s: 8}, {at: 300, s: 0, v: 0, a: "
        "0}]}\n"
        "      - {dwell: {to: 2*pi}}\n" MACHINE);
    CHECK_NEAR(value(model, "lift", 45 * DEG, 0), 0.01, 1e-15);
    CHECK_NEAR(value(model, "lift", 95 * DEG, 0), 0.02, 1e-15);
    CHECK_NEAR(value(model, "lift", 110 * DEG, 1), 0.1e-3 / DEG, 1e-13);
    CHECK_NEAR(value(model, "lift", 130 * DEG, 0), 0.022, 1e-15);
    CHECK_NEAR(value(model, "lift", 175 * DEG, 0), 0.021, 1e-15);
    CHECK_NEAR(value(model, "lift", 230 * DEG, 0), 0.015, 1e-15);
    CHECK_NEAR(value(model, "lift", 260 * DEG, 0), 0.008, 1e-15);
    CHECK_NEAR(value(model, "lift", 330 * DEG, 0), 0, 1e-15);
    CHECK_NEAR(value(model, "lift", 405 * DEG, 0), 0.01, 1e-14);
    yk_model_free(model);
}

static void rises_take_their_options(void **state)
{
    (void)state;
    YkModel *model = fixture_load(
        "laws:\n  a: {segments: [{rise: {to: 1, by: 1, law: constant-velocity, blend: 1/4}}]}\n"
        "  b: {from: 2, segments: [{rise: {to: 3, by: 1, law: cycloidal, half: first}}, "
        "{rise: {to: 4, by: 1, law: cycloidal, half: second}}]}\n"
        "  c: {segments: [{rise: {to: 2, by: 1, law: spline, through: [{at: 1, s: 0.7}], degree: 4}}]}\n" MACHINE);
    CHECK_NEAR(value(model, "a", 0.5, 1), 4.0 / 3, 1e-14);
    for (double x = 0; x < 1; x += 0.1) { // two halves are the whole: 2 (u - sin(2 pi u) / (2 pi)), u = x / 2
        CHECK_NEAR(value(model, "b", 2 + 2 * x, 0), 2 * (x - sin(2 * YK_PI * x) / (2 * YK_PI)), 1e-14);
    }
    CHECK_NEAR(value(model, "c", 1, 0), 0.7, 1e-14);
    CHECK_NEAR(value(model, "c", 0, 2), 0, 1e-12);
    yk_model_free(model);
}

static void tables_are_read(void **state)
{
    (void)state;
    YkModel *model = fixture_load("laws:\n  line: {table: [[0, 100 N], [10 mm, 50 N]], between: linear}\n"
                                  "  spline: {table: [[0, 0 N], [1 m, 1], [2, 0]], between: cubic}\n"
                                  "  usual: {table: [[0, 0 N], [1 m, 1], [2, 1], [3, 0]]}\n"
                                  "  round: {period: 4 m, table: [[0, 1 N], [2, 3]], between: linear}\n" MACHINE);
    CHECK_NEAR(value(model, "line", 0.005, 0), 75, 1e-13);
    CHECK_NEAR(value(model, "line", 1, 0), 50, 1e-13);
    CHECK_NEAR(value(model, "spline", 0.5, 0), 0.6875, 1e-15); // 3/2 x - x^3/2
    CHECK_NEAR(value(model, "usual", 1.5, 0), 1, 0);           // monotone: no overshoot, but no corners either
    CHECK_NEAR(value(model, "usual", nextafter(1, 0), 1), 0, 1e-12);
    CHECK_NEAR(value(model, "usual", 0.5, 1), 1.125, 1e-15);
    CHECK_NEAR(value(model, "round", 3, 0), 2, 1e-15);
    CHECK_NEAR(value(model, "round", 7, 0), 2, 1e-15);
    yk_model_free(model);
}

static void check_dimensions(const char *laws, const char *uses, YkDimension of, YkDimension gives)
{
    char text[1000];
    snprintf(text, sizeof text, "units: {length: mm, angle: deg}\n%s%s%s", laws, MACHINE, uses);
    YkModel *model = fixture_load(text);
    const YkModelLaw *law = &model->laws[0];
    bool is_right = yk_dimension_equal(law->of, of) && law->of.angle == of.angle &&
                    yk_dimension_equal(law->value, gives) && law->value.angle == gives.angle;
    if (!is_right) print_error("%s: %s -> %s\n", laws, yk_dimension_name(law->of), yk_dimension_name(law->value));
    assert_true(is_right);
    yk_model_free(model);
}

static void what_is_written_with_a_unit_decides_what_a_law_is(void **state)
{
    (void)state;
    const YkDimension length = {1, 0, 0, 0}, angle = {0, 0, 0, 1}, time = {0, 0, 1, 0}, force = {1, 1, -2, 0};
    check_dimensions("laws: {f: {segments: [{rise: {to: 90, by: 3, law: 3-4-5}}]}}\n", "", angle, length);
    check_dimensions("laws: {f: {segments: [{rise: {to: 90, by: 3 deg, law: 3-4-5}}]}}\n", "", angle, angle);
    check_dimensions("laws: {f: {segments: [{rise: {to: 2 s, by: -(-3 deg), law: 3-4-5}}]}}\n", "", time, angle);
    check_dimensions("laws: {f: {table: [[0, 0], [1 s, 2], [3, 2 N]]}}\n", "", time, force);
    check_dimensions(
        "parameters: {h: 3, T: 2 s, w: 3 deg}\n"
        "laws: {f: {segments: [{rise: {to: T/2, by: 2*h, law: 3-4-5}}, {fall: {to: T, by: w, law: 3-4-5}}]}}\n",
        "", time, angle);
    check_dimensions("parameters: {h: 3}\nlaws: {f: {segments: [{rise: {to: 2*pi, by: 2*h, law: 3-4-5}}]}}\n", "",
                     angle, length);
}

static void where_nothing_has_a_unit_the_use_decides(void **state)
{
    (void)state;
    const YkDimension length = {1, 0, 0, 0}, angle = {0, 0, 0, 1}, time = {0, 0, 1, 0};
    const YkDimension force = {1, 1, -2, 0}, torque = {2, 1, -2, 0};
    const char *bare = "laws: {f: {table: [[0, 1], [90, 2]]}}\n";
    check_dimensions(bare, "efforts: {d: {law: f, of: theta}}\n", angle, force);
    check_dimensions(bare, "efforts: {theta: {law: f, of: d}}\n", length, torque);
    check_dimensions(bare, "efforts: {O.angle: {law: f, of: R.distance}}\n", length, torque);
    check_dimensions(bare, "efforts: {d: {law: f, of: t}}\n", time, force);
    check_dimensions("laws: {f: {table: [[0, 1], [90 deg, 2]]}}\n", "efforts: {d: {law: f, of: theta}}\n", angle,
                     force);
}

static void a_bare_parameter_in_a_law_takes_the_files_unit(void **state)
{
    (void)state;
    YkModel *model = fixture_load("units: {length: mm, angle: deg}\nparameters: {h: 3, b: 60, n: 2}\n"
                                  "laws: {f: {segments: [{rise: {to: b, by: n*h, law: 3-4-5}}]}}\n" MACHINE);
    CHECK_NEAR(value(model, "f", 60 * DEG, 0), 0.006, 1e-17);
    CHECK_NEAR(yk_law_range(model->laws[0].law).to, 60 * DEG, 1e-15);
    yk_model_free(model);
}

// Loads with exactly one problem more than notes: this one, at this place of the law, which stands alone in line 1.
static void refused(const char *law, int code, unsigned column, const char *part)
{
    char text[1200];
    snprintf(text, sizeof text, "laws: {f: %s}\n%s", law, MACHINE);
    fixture_refused(text, code, 1, column, part);
}

static void mistakes_of_form_are_told_with_their_place(void **state)
{
    (void)state;
    refused("3", YK_CODE_WRONG_KIND, 11, "law `f`");
    refused("{}", YK_CODE_LAW_KIND, 8, "`segments` or a `table`");
    refused("{segments: [{dwell: {to: 1}}], table: [[0, 1], [1, 2]]}", YK_CODE_LAW_KIND, 8, "both");
    refused("{segments: []}", YK_CODE_LAW_KIND, 22, "no segments");
    refused("{segments: [{dwell: {to: 1}}], between: cubic}", YK_CODE_LAW_KIND, 42, "between");
    refused("{segments: [{dwell: {to: 1}}], perod: 3}", YK_CODE_UNKNOWN_KEY, 42, "did you mean `period`");
    refused("{segments: [{dwel: {to: 1}}]}", YK_CODE_UNKNOWN_KEY, 24, "did you mean `dwell`");
    refused("{segments: [{degree: 3}]}", YK_CODE_LAW_SEGMENT, 23, "does not say");
    refused("{segments: [{}]}", YK_CODE_LAW_SEGMENT, 23, "does not say");
    refused("{segments: [3]}", YK_CODE_WRONG_KIND, 23, "segment");
    refused("{segments: [{dwell: {}}]}", YK_CODE_MISSING_KEY, 31, "`to`");
    refused("{segments: [{constant-velocity: {to: 1}}]}", YK_CODE_MISSING_KEY, 43, "`v`");
    refused("{segments: [{rise: {to: 1, by: 1}}]}", YK_CODE_MISSING_KEY, 30, "`law`");
    refused("{segments: [{rise: {to: 1, by: 1, law: cyclodial}}]}", YK_CODE_WRONG_WORD, 50, "did you mean `cycloidal`");
    refused("{segments: [{rise: {to: 1, by: 1, law: harmonic, half: third}}]}", YK_CODE_WRONG_WORD, 66, "third");
    refused("{segments: [{rise: {to: 1, by: 1, law: scca}}]}", YK_CODE_MISSING_KEY, 30, "`scca`");
    refused("{segments: [{rise: {to: 1, by: 1, law: harmonic, blend: 0.2}}]}", YK_CODE_LAW_SHAPE, 60,
            "constant-velocity");
    refused("{segments: [{rise: {to: 1, by: 1, law: harmonic, through: []}}]}", YK_CODE_LAW_SHAPE, 60, "spline");
    refused("{segments: [{polynomial: [{at: 0, s: 0}, {at: 1, s: 0}], degree: 3}]}", YK_CODE_LAW_SEGMENT, 68, "degree");
    refused("{segments: [{polynomial: [{at: 0}, {at: 1, s: 0}]}]}", YK_CODE_LAW_CONDITIONS, 37, "gives only its place");
    refused("{segments: [{polynomial: [{s: 0}, {at: 1, s: 0}]}]}", YK_CODE_MISSING_KEY, 37, "`at`");
    refused("{table: [[0, 1], [1, 2, 3]]}", YK_CODE_COMPONENTS, 28, "[argument, value]");
    refused("{table: [[0, 1], [1, 2]], between: curve}", YK_CODE_WRONG_WORD, 46, "monotone");
    refused("{table: [[0, 1 mm], [1, 2 kg]]}", YK_CODE_WRONG_DIMENSION, 35, "a length");
    refused("{segments: [{dwell: {to: theta}}]}", YK_CODE_NAME_NOT_HERE, 36, "coordinate");
    refused("{segments: [{dwell: {to: nowhere}}]}", YK_CODE_UNKNOWN_NAME, 36, "nowhere");
}

static void mistakes_of_value_are_told_with_their_place(void **state)
{
    (void)state;
    refused("{period: 0, segments: [{dwell: {to: 1}}]}", YK_CODE_LAW_PERIOD, 20, "positive");
    refused("{period: 2, segments: [{dwell: {to: 1}}]}", YK_CODE_LAW_PERIOD, 20, "end at 1 rad");
    refused("{period: 2, segments: [{dwell: {to: 3}}]}", YK_CODE_LAW_PERIOD, 20, "continue to 3 rad");
    refused("{segments: [{dwell: {to: 1}}, {dwell: {to: 1}}]}", YK_CODE_LAW_ORDER, 54, "begins at 1 rad");
    refused("{segments: [{dwell: {to: 2}}, {polynomial: [{at: 1, s: 0}, {at: 3, s: 0}]}]}", YK_CODE_LAW_ORDER, 42,
            "later");
    refused("{from: 1, segments: [{polynomial: [{at: 2, s: 0}, {at: 3, s: 0}]}]}", YK_CODE_LAW_ORDER, 33, "earlier");
    refused("{from: 1, table: [[0, 1], [1, 2]]}", YK_CODE_LAW_ORDER, 18, "begins");
    refused("{table: [[0, 1], [1, 2], [1, 3]]}", YK_CODE_LAW_ORDER, 37,
            "1 rad (57.2958 deg) follows 1 rad (57.2958 deg)");
    refused("{table: [[0, 1]]}", YK_CODE_LAW_CONDITIONS, 8, "two points");
    refused("{table: []}", YK_CODE_LAW_CONDITIONS, 8, "two points");
    refused("{period: 2, table: [[0, 1], [3, 1]]}", YK_CODE_LAW_PERIOD, 20, "one period");
    refused("{period: 3, table: [[0, 1], [3, 2]]}", YK_CODE_LAW_JUMP, 8, "jumps by -1 m");
    refused("{segments: [{rise: {to: 1, by: -1, law: harmonic}}]}", YK_CODE_LAW_SHAPE, 42, "`by`");
    refused("{segments: [{rise: {to: 1, by: 1, law: constant-velocity, blend: 0.6}}]}", YK_CODE_LAW_SHAPE, 76, "0.5");
    refused("{segments: [{spline: [{at: 0, s: 0}, {at: 1, s: 1}], degree: 1.5}]}", YK_CODE_LAW_SHAPE, 72, "whole");
    refused("{segments: [{spline: [{at: 0, s: 0}, {at: 1, s: 1}]}]}", YK_CODE_LAW_CONDITIONS, 24, "too few");
    refused("{segments: [{rise: {to: 1, by: 1, law: spline, half: first}}]}", YK_CODE_LAW_SHAPE, 35, "halves");
    refused("{segments: [{polynomial: [{at: 0, s: 0}, {at: 1, s: 1}, {at: 0, s: 0}]}]}", YK_CODE_LAW_CONDITIONS, 78,
            "second time");
    refused("{segments: [{polynomial: [{at: 0, s: 0}, {at: 2, s: 1}, {at: 1, v: 3}]}]}", YK_CODE_LAW_CONTRADICTION, 78,
            "v at 1 rad (57.2958 deg) contradicts");
    refused("{segments: [{polynomial: [{at: 0, s: 0}, {at: 2, s: 4}, {at: 1, v: 2}]}]}", YK_CODE_LAW_UNDETERMINED, 78,
            "follows from the other");
    refused("{period: 2, segments: [{rise: {to: 2, by: 1, law: 3-4-5}}]}", YK_CODE_LAW_JUMP, 8, "does not return");
    refused("{segments: [{dwell: {to: 1}}, {polynomial: [{at: 1, s: 0.2}, {at: 3, s: 0}]}]}", YK_CODE_LAW_JUMP, 42,
            "jumps by 0.2 m at 1 rad (57.2958 deg)");
}

static void find_notes(const char *law, int code, size_t count, const char *part)
{
    char text[1000];
    snprintf(text, sizeof text, "units: {length: mm, angle: deg}\nlaws: {f: %s}\n%s", law, MACHINE);
    YkProblems *problems = yk_problems_new();
    YkModel *model = yk_model_parse(text, strlen(text), "test", NULL, problems);
    size_t found = 0;
    for (size_t i = 0; i < yk_problems_count(problems); i++) {
        const YkProblem *problem = yk_problems_get(problems, i);
        found += problem->code == code && strstr(problem->message, part);
    }
    if (found != count || yk_problems_count(problems) != count) print_error("%s\n", yk_problems_text(problems, 0));
    assert_non_null(model);
    assert_int_equal(found, count);
    assert_int_equal(yk_problems_count(problems), count);
    yk_model_free(model);
    yk_problems_free(problems);
}

static void broken_fundamental_laws_are_noted_with_their_size(void **state)
{
    (void)state;
    find_notes("{period: 20, segments: [{rise: {to: 10, by: 3, law: constant-velocity}}, {fall: {to: 20, by: 3, law: "
               "constant-velocity}}]}",
               YK_CODE_LAW_JUMP_VELOCITY, 2, "0.6 mm/deg");
    find_notes(
        "{period: 20, segments: [{rise: {to: 10, by: 5, law: parabolic}}, {dwell: {to: 12}}, {fall: {to: 20, by: "
        "5, law: cycloidal}}]}",
        YK_CODE_LAW_JUMP_ACCELERATION, 3, "mm/deg^2");
    find_notes(
        "{period: 20, segments: [{rise: {to: 10, by: 5, law: modified-sine}}, {fall: {to: 20, by: 5, law: 4-5-6-7}}]}",
        0, 0, "");
    find_notes("{table: [[0, 1 N], [5, 7 N], [9, 1 N]], between: linear}", 0, 0, ""); // a force may have corners
    find_notes("{table: [[0, 1], [5, 7], [9, 1]], between: linear}", 0, 0, "");       // and so may any table
    find_notes("{segments: [{constant-velocity: {to: 9, v: 3 N}}, {rise: {to: 12, by: 2 N, law: parabolic}}]}", 0, 0,
               "");
}

static void overrides_reach_the_laws(void **state)
{
    (void)state;
    const YkOverride override = {"h", "7 mm"};
    const YkLoadOptions options = {&override, 1};
    YkModel *model = fixture_load_with(
        "parameters: {h: 3 mm}\nlaws: {f: {segments: [{rise: {to: 2, by: h, law: 3-4-5}}]}}\n" MACHINE, &options);
    CHECK_NEAR(value(model, "f", 1, 0), 0.0035, 1e-17);
    yk_model_free(model);
}

// Random damage: words of the format dropped into a sound file, bytes taken out.
static void a_damaged_law_is_loaded_or_refused(void **state)
{
    (void)state;
    static const char sound[] =
        "units: {angle: deg}\nparameters: {h: 0.02, b: 0.25}\nlaws:\n  lift:\n    period: 360\n    segments:\n"
        "      - {polynomial: [{at: 0, s: 0, v: 0, a: 0}, {at: 90, s: h, v: 0, j: 0}]}\n"
        "      - {dwell: {to: 100}}\n      - {fall: {to: 150, by: h/2, law: scca, scca: {b: b, c: 0.5, d: b}}}\n"
        "      - {spline: [{at: 150, s: h/2}, {at: 190, s: h}, {at: 250, s: 0}], degree: 2}\n      - {dwell: {to: "
        "360}}\n"
        "  cut: {period: 1 m, table: [[0, 1 N], [0.2, 3], [0.5, 2]], between: cubic}\n" MACHINE;
    static const char *const words[] = {"{", "}",    "[",      "]",  ": ",   ", ",  "-1",    "1e9",
                                        "0", "nan",  "at",     "s",  "v",    "to",  "by",    "dwell",
                                        "x", "rise", "1e-300", "pi", "1e90", "deg", "law: ", "'"};
    for (uint64_t round = 0; round < 2000; round++) {
        char text[sizeof sound + 100];
        uint64_t seed = round;
        size_t length = sizeof sound - 1;
        memcpy(text, sound, sizeof sound);
        for (int i = 0; i < 2; i++) {
            const char *word = words[check_random(&seed) % (sizeof words / sizeof *words)];
            size_t at = check_random(&seed) % (length + 1), size = strlen(word), cut = check_random(&seed) % 4;
            if (at + cut > length) cut = length - at;
            memmove(text + at + size, text + at + cut, length - at - cut);
            memcpy(text + at, word, size);
            length = length - cut + size;
        }
        YkProblems *problems = yk_problems_new();
        YkModel *model = yk_model_parse(text, length, "damaged", NULL, problems);
        if ((model == NULL) != (yk_problems_error_count(problems) > 0)) print_error("seed %d\n", (int)round);
        assert_int_equal(model == NULL, yk_problems_error_count(problems) > 0);
        for (size_t i = 0; model && i < model->law_count; i++)
            assert_true(isfinite(value(model, model->laws[i].name, 0.7, 0)));
        yk_model_free(model);
        yk_problems_free(problems);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_laws_of_the_cep_cam_load),
        cmocka_unit_test(every_segment_is_read_in_the_units_of_the_file),
        cmocka_unit_test(rises_take_their_options),
        cmocka_unit_test(tables_are_read),
        cmocka_unit_test(what_is_written_with_a_unit_decides_what_a_law_is),
        cmocka_unit_test(where_nothing_has_a_unit_the_use_decides),
        cmocka_unit_test(a_bare_parameter_in_a_law_takes_the_files_unit),
        cmocka_unit_test(mistakes_of_form_are_told_with_their_place),
        cmocka_unit_test(mistakes_of_value_are_told_with_their_place),
        cmocka_unit_test(broken_fundamental_laws_are_noted_with_their_size),
        cmocka_unit_test(overrides_reach_the_laws),
        cmocka_unit_test(a_damaged_law_is_loaded_or_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
