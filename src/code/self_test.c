// Writes the self-test at the end of the printed file: poses that the engine computed, compared value by value.
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <yoke/dynamics.h>
#include "code/file.h"
#include "loads/loads.h"

enum { POSES = 5, SOLVE = 1000 }; // SOLVE: work for each step of a pose with forces

// Returns a number between -1 and 1, the same on every machine.
static double random_number(uint64_t *seed)
{
    *seed = *seed * 6364136223846793005u + 1442695040888963407u;
    return (double)(int64_t)*seed * 0x1p-63;
}

// Sets the state's inputs near the start; member order: t, then position, rate, acceleration (and effort) of each.
static void set_inputs(YkFile *file, YkState *state, size_t pose, double reach, uint64_t seed, double *row)
{
    const YkMechanism *mech = file->program.mech;
    double time = file->inputs[0].value + (pose == 0 ? 0 : 0.01 * (double)pose);
    size_t at = 0;
    yk_state_set_time(state, time, NULL);
    row[at++] = time;
    for (size_t i = 0; i < mech->input_count; i++) {
        const YkTreeCoordinate *c = &mech->coordinates[mech->inputs[i]];
        double unit = c->is_distance ? mech->size : 1;
        YkMotion m = {file->inputs[at].value, file->inputs[at + 1].value, file->inputs[at + 2].value};
        if (pose > 0) {
            m.position += reach * unit * random_number(&seed);
            m.velocity += unit * random_number(&seed);
            m.acceleration += 2 * unit * random_number(&seed);
        }
        yk_state_set_input(state, i, m);
        row[at++] = m.position;
        row[at++] = m.velocity;
        row[at++] = m.acceleration;
        if (at < file->input_count && file->inputs[at].is_effort) row[at++] = 0;
    }
}

// Moves the state to a pose; one that does not close is too far away, and a nearer one is taken.
static void find_pose(YkFile *file, YkState *state, size_t pose, double *row)
{
    double reach = file->program.mech->has_groups ? 0.05 : 0.3;
    for (int k = 0; k < 8; k++, reach /= 4) {
        yk_state_copy(state, file->state);
        set_inputs(file, state, pose, reach, 77 * pose + 1, row);
        if (yk_state_solve(state) >= 0 && yk_state_has_rates(state)) return;
    }
    yk_state_copy(state, file->state);
    set_inputs(file, state, 0, 0, 1, row);
    yk_state_solve(state);
}

// Returns whether all joints with dry friction slide, clearly.
static bool slides(const YkFile *file, const YkState *state)
{
    const YkMechanism *mech = file->program.mech;
    bool all = true;
    for (size_t k = 0; k < file->forces.dry_count; k++) {
        const YkDryJoint *dry = &file->forces.dry[k];
        double rate = yk_joint_rate(mech, &state->space, dry->joint, dry->slides);
        all = all && fabs(rate) > 1e-6 * (dry->slides ? mech->size : 1);
    }
    return all;
}

// Finds the engine's values of a routine's results at the state's inputs. Returns false if it has no answer.
static bool wanted_at(YkFile *file, YkState *state, YkDynamics *dynamics, const YkRoutine *r, double *wanted)
{
    const YkMechanism *mech = file->program.mech;
    if (r->kind != YK_ROUTINE_MOTION) {
        for (size_t i = 0; i < mech->input_count; i++)
            yk_dynamics_prescribe(dynamics, i, r->kind == YK_ROUTINE_INVERSE || !file->forces.is_free[i]);
        YkStatus status = yk_dynamics_solve(dynamics, state, YK_METHOD_REDUCED);
        file->program.failed |= status == YK_NO_MEMORY;
        if ((status != YK_OK && status != YK_REDUNDANT) || !yk_state_has_rates(state)) return false;
        if (!slides(file, state)) return false;
    }
    for (size_t k = 0; k < r->count; k++) {
        YkChannel c = r->results[k].channel;
        if (r->kind == YK_ROUTINE_FORWARD)
            wanted[k] = yk_state_input(state, (size_t)mech->coordinates[c.index].input).acceleration;
        else
            wanted[k] =
                r->kind == YK_ROUTINE_MOTION ? yk_state_channel(state, c) : yk_dynamics_channel(dynamics, state, c);
    }
    return true;
}

// Finds the results again with the inputs moved by their last digit. Close to a dead point this changes them so much
// that two correct methods would differ by more than the test allows. Returns false if the pose has no results.
static bool wanted_beside(YkFile *file, YkState *state, YkDynamics *dynamics, const YkRoutine *r, double *moved)
{
    const YkMechanism *mech = file->program.mech;
    double digit = file->single ? 1e-7 : 1e-15;
    for (size_t i = 0; i < mech->input_count; i++) {
        YkMotion m = yk_state_input(state, i);
        m.position += digit * (mech->coordinates[mech->inputs[i]].is_distance ? mech->size : 1 + fabs(m.position));
        yk_state_set_input(state, i, m);
    }
    if (yk_state_solve(state) < 0 || !yk_state_has_rates(state)) return false;
    return wanted_at(file, state, dynamics, r, moved);
}

// Returns the largest value with the unit of result k, over all poses.
static double scale_of(const YkRoutine *r, const double *wanted, size_t poses, size_t k)
{
    double largest = 0;
    for (size_t i = 0; i < r->count; i++) {
        if (strcmp(r->results[i].comment, r->results[k].comment) != 0) continue;
        for (size_t pose = 0; pose < poses; pose++) largest = fmax(largest, fabs(wanted[pose * r->count + i]));
    }
    return largest;
}

// Returns the first pose at which the last digit of the inputs matters to a tenth of the test's tolerance; `poses` if
// there is none.
static size_t unsteady_pose(const YkFile *file, const YkRoutine *r, const double *wanted, const double *moved,
                            size_t poses)
{
    double tolerance = file->single ? 2e-4 : 1e-11;
    size_t first = poses;
    for (size_t k = 0; k < r->count; k++) {
        double allowed = tolerance * (scale_of(r, wanted, poses, k) + 1e-2);
        for (size_t pose = 0; pose < first; pose++)
            if (!(fabs(moved[pose * r->count + k] - wanted[pose * r->count + k]) <= allowed)) first = pose;
    }
    return first;
}

enum { NUMBER = 200 }; // work of printing one

static void write_row(YkFile *file, const double *values, size_t count)
{
    yk_text_puts(&file->text, "        {");
    for (size_t k = 0; k < count && yk_file_goes_on(file, NUMBER); k++) {
        yk_text_puts(&file->text, k == 0 ? "" : k % 5 == 0 ? ",\n         " : ", ");
        yk_printer_number(&file->printer, values[k]);
    }
    yk_text_puts(&file->text, "},\n");
}

static void write_tables(YkFile *file, const YkRoutine *r, const double *rows, size_t members, const double *wanted,
                         size_t poses)
{
    YkText *out = &file->text;
    const char *real = yk_file_real(file);
    yk_text_format(out, "static int %s_test_%s(void)\n{\n    static const %s rows[%d][%d] = {\n", file->prefix, r->name,
                   real, (int)poses, (int)members);
    for (size_t k = 0; k < poses; k++) write_row(file, rows + k * members, members);
    yk_text_format(out, "    };\n    static const %s wanted[%d][%d] = {\n", real, (int)poses, (int)r->count);
    for (size_t k = 0; k < poses; k++) write_row(file, wanted + k * r->count, r->count);
    yk_text_puts(out, "    };\n");
}

// Writes the scale of each value's error: the largest value with its unit.
static void write_scales(YkFile *file, const YkRoutine *r, const double *wanted, size_t poses)
{
    yk_text_format(&file->text, "    static const %s scale[%d] = {\n        ", yk_file_real(file), (int)r->count);
    for (size_t k = 0; k < r->count && yk_file_goes_on(file, 20 * r->count); k++) {
        yk_text_puts(&file->text, k == 0 ? "" : k % 8 == 0 ? ",\n        " : ", ");
        yk_printer_number(&file->printer, scale_of(r, wanted, poses, k));
    }
    yk_text_puts(&file->text, "};\n");
}

// Writes runs of one pose a call, then of all of them at once.
static void write_runs(YkFile *file, const YkRoutine *r, size_t poses)
{
    YkText *out = &file->text;
    const char *p = file->prefix, *real = yk_file_real(file);
    int count = (int)r->count, members = (int)file->input_count;
    yk_text_format(out, "    static %s columns[%d][%d], many[%d][%d], got[%d][%d];\n", real, members, (int)poses, count,
                   (int)poses, (int)poses, count);
    yk_text_format(out, "    static signed char status[%d];\n", (int)poses);
    yk_file_template(
        file, "    const @_parameters parameters = @_defaults();\n    const @_machine m = @_prepare(&parameters);\n"
              "    const @_configuration c = @_start();\n    int failures = 0;\n");
    yk_text_format(out, "    for (int k = 0; k < %d; k++) {\n        %s_inputs in;\n        %s_%s out;\n", (int)poses,
                   p, p, r->name);
    for (int k = 0; k < members; k++)
        yk_text_format(out, "        in.%s = columns[%d][k] = rows[k][%d];\n", file->inputs[k].name, k, k);
    yk_text_format(out, "        failures += %s_find_%s(&m, &c, &in, &out) != %s_OK;\n", p, r->name, p);
    for (int k = 0; k < count; k++) yk_text_format(out, "        got[k][%d] = out.%s;\n", k, r->results[k].name);
    yk_text_puts(out, "    }\n");
    yk_text_format(out, "    const %s_inputs_arrays all = {", p);
    for (int k = 0; k < members; k++) yk_text_format(out, "%scolumns[%d]", k ? ", " : "", k);
    yk_text_format(out, "};\n    const %s_%s_arrays answers = {", p, r->name);
    for (int k = 0; k < count; k++) yk_text_format(out, "%smany[%d]", k ? ", " : "", k);
    yk_text_format(out, "};\n    %s_find_%s_batch(%d, &m, &c, &all, &answers, status);\n", p, r->name, (int)poses);
    yk_text_format(out,
                   "    for (int i = 0; i < %d; i++) {\n"
                   "        for (int k = 0; k < %d; k++) {\n"
                   "            failures += status[k] != %s_OK;\n"
                   "            failures += %s_differ(\"%s\", i, k, got[k][i], wanted[k][i], scale[i]);\n"
                   "            failures += %s_differ(\"%s (batch)\", i, k, many[i][k], got[k][i], scale[i]);\n"
                   "        }\n    }\n    return failures;\n}\n\n",
                   count, (int)poses, p, p, r->name, p, r->name);
}

// Takes the rows from row k + 1 on one place down.
static void drop_row(double *rows, size_t width, size_t k, size_t count)
{
    memmove(rows + k * width, rows + (k + 1) * width, (count - k - 1) * width * sizeof *rows);
}

static bool write_test(YkFile *file, YkState *state, YkDynamics *dynamics, const YkRoutine *r)
{
    size_t members = file->input_count, poses = 0, n = r->count;
    double *rows = malloc((POSES * members + 1) * sizeof *rows), *wanted = malloc((POSES * n + 1) * sizeof *wanted),
           *moved = malloc((POSES * n + 1) * sizeof *moved);
    bool ok = rows && wanted && moved;
    for (size_t k = 0; ok && k < POSES && yk_file_goes_on(file, SOLVE * file->program.mech->step_count); k++) {
        find_pose(file, state, k, rows + poses * members);
        if (!wanted_at(file, state, dynamics, r, wanted + poses * n)) continue;
        if (wanted_beside(file, state, dynamics, r, moved + poses * n)) poses++;
    }
    for (size_t k; ok && (k = unsteady_pose(file, r, wanted, moved, poses)) < poses; poses--) {
        drop_row(rows, members, k, poses);
        drop_row(wanted, n, k, poses);
        drop_row(moved, n, k, poses);
    }
    bool any = ok && poses > 0;
    if (any) {
        write_tables(file, r, rows, members, wanted, poses);
        write_scales(file, r, wanted, poses);
        write_runs(file, r, poses);
    }
    free(rows);
    free(wanted);
    free(moved);
    if (!ok) file->program.failed = true;
    return any;
}

void yk_file_write_test(YkFile *file)
{
    YkState *state = yk_state_new(file->program.mech);
    YkDynamics *dynamics = yk_dynamics_new(file->program.mech, NULL);
    bool has[YK_ROUTINES_MAX] = {false};
    if (state && dynamics) {
        yk_file_template(
            file, "#ifdef @_TEST\n#include <stdio.h>\n\n#ifndef @_TOLERANCE /* of the largest value of its kind */\n");
        yk_file_template(file, file->single ? "#define @_TOLERANCE 2e-3f\n#endif\n\n"
                                            : "#define @_TOLERANCE 1e-10\n#endif\n\n");
        yk_file_template(file,
                         "static int @_differ(const char *what, int value, int pose, $ got, $ wanted, $ largest)\n{\n");
        yk_file_template(file,
                         file->single
                             ? "    if (fabsf(got - wanted) <= @_TOLERANCE * largest + 1e-2f * @_TOLERANCE) return 0;\n"
                             : "    if (fabs(got - wanted) <= @_TOLERANCE * largest + 1e-2 * @_TOLERANCE) return 0;\n");
        yk_file_template(
            file, "    printf(\"%s: value %d at pose %d is %.17g, not %.17g\\n\", what, value, pose, (double)got, "
                  "(double)wanted);\n    return 1;\n}\n\n");
        YkText head = file->text;
        file->text = (YkText){0};
        for (size_t k = 0; k < file->routine_count; k++) has[k] = write_test(file, state, dynamics, &file->routines[k]);
        YkText tests = file->text;
        file->text = head;
        yk_file_template(file, yk_text_get(&tests));
        yk_text_free(&tests);
        yk_text_puts(&file->text, "int main(void)\n{\n    int failures = 0;\n");
        for (size_t k = 0; k < file->routine_count; k++)
            if (has[k])
                yk_text_format(&file->text, "    failures += %s_test_%s();\n", file->prefix, file->routines[k].name);
        yk_file_template(file, "    if (failures) printf(\"@: %d failures\\n\", failures);\n    else printf(\"@: "
                               "well\\n\");\n    return failures != 0;\n}\n#endif\n");
    } else {
        file->program.failed = true;
    }
    yk_dynamics_free(dynamics);
    yk_state_free(state);
}
