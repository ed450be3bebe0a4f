// yoke balance: counterweights and flywheel.
#include <math.h>
#include <string.h>
#include "answer.h"
#include "base/number.h"
#include "laws_left.h"
#include "reach.h"
#include "write/file_set.h"
#include "write/folder.h"
#include "write/table.h"

// --- text

// Returns what the input's effort is: a force along a distance, a torque about an angle.
static YkQuantity effort_of(const YkSession *session)
{
    const YkMechanism *mech = yk_state_mechanism(session->state);
    return yk_coordinate_info(mech, yk_input_coordinate(mech, 0)).is_distance ? YK_QUANTITY_FORCE : YK_QUANTITY_TORQUE;
}

static void add_peaks(const YkSession *session, YkTable *table, const char *name, YkShakingPeaks peaks)
{
    yk_table_word(table, name);
    yk_table_number(table, yk_shown(session, peaks.force, YK_QUANTITY_FORCE), YK_DIGITS);
    yk_table_number(table, yk_shown(session, peaks.moment, YK_QUANTITY_TORQUE), YK_DIGITS);
    yk_table_number(table, yk_shown(session, peaks.torque, effort_of(session)), YK_DIGITS);
}

static void write_shaking(YkSession *session, const YkBalancing *b)
{
    YkTable *table = yk_table_new(4);
    YkShakingPeaks before = yk_balancing_before(b);
    yk_scale_begin(session);
    yk_scale_add(session, before.force, YK_QUANTITY_FORCE);
    yk_table_head(table, "largest over the cycle", NULL);
    yk_table_head(table, "shaking force", yk_unit_of(session, YK_QUANTITY_FORCE));
    yk_table_head(table, "shaking moment", yk_unit_of(session, YK_QUANTITY_TORQUE));
    yk_table_head(table, "effort", yk_unit_of(session, effort_of(session)));
    add_peaks(session, table, "before", before);
    add_peaks(session, table, "with counterweights", yk_balancing_after(b));
    yk_table_show(table, NULL, &session->out);
    yk_text_puts(&session->out,
                 "\nShaking forces and moments are those of inertia alone. The effort is what the input needs "
                 "under everything\nin the file: weight, loads and friction as well.\n");
}

static void add_order(const YkSession *session, YkTable *table, const YkBalancing *b, size_t order)
{
    YkShakingOrder before = yk_balancing_order(b, order, false), after = yk_balancing_order(b, order, true);
    const double values[] = {before.with, before.against, after.with, after.against};
    yk_table_number(table, (double)order, YK_DIGITS);
    for (size_t k = 0; k < 4; k++) yk_table_number(table, yk_shown(session, values[k], YK_QUANTITY_FORCE), YK_DIGITS);
}

// The parts of the shaking force that are there, up to the last order of some size.
static void write_orders(YkSession *session, const YkBalancing *b)
{
    static const double small = 1e-4; // over the largest force
    size_t last = 0;
    for (size_t n = 1; n <= YK_SHAKING_ORDERS; n++) {
        YkShakingOrder o = yk_balancing_order(b, n, false), after = yk_balancing_order(b, n, true);
        double most = fmax(o.with + o.against, after.with + after.against);
        if (most > small * yk_balancing_before(b).force) last = n;
    }
    if (last == 0) return;
    YkTable *table = yk_table_new(5);
    const char *unit = yk_unit_of(session, YK_QUANTITY_FORCE);
    yk_table_head(table, "order", NULL);
    yk_table_head(table, "with the input", unit);
    yk_table_head(table, "against it", unit);
    yk_table_head(table, "then with", unit);
    yk_table_head(table, "against", unit);
    for (size_t n = 1; n <= last; n++) add_order(session, table, b, n);
    yk_table_show(table, NULL, &session->out);
    yk_text_puts(
        &session->out,
        "\nThe shaking force turns with the input and against it, at its rate and multiples of it. A "
        "counterweight on the input\nchanges the part that turns with it at its own rate. Others need weights on "
        "wheels that turn as fast as they do.\n");
}

static void write_weights(YkSession *session, const YkBalancing *b)
{
    YkTable *table = yk_table_new(6);
    yk_table_head(table, "counterweight on", NULL);
    yk_table_head(table, "about", NULL);
    yk_table_head(table, "mass x radius", yk_unit_of(session, YK_QUANTITY_UNBALANCE));
    yk_table_head(table, "angle", yk_unit_of(session, YK_QUANTITY_ANGLE));
    yk_table_head(table, "as mass", yk_unit_of(session, YK_QUANTITY_MASS));
    yk_table_head(table, "at radius", yk_unit_of(session, YK_QUANTITY_LENGTH));
    for (size_t k = 0; k < yk_balancing_count(b); k++) {
        YkCounterweight w = yk_balancing_at(b, k);
        yk_table_word(table, yk_model_body_name(session->model, w.body));
        yk_table_word(table, yk_model_joint_name(session->model, w.joint));
        yk_table_number(table, yk_shown(session, w.product, YK_QUANTITY_UNBALANCE), YK_DIGITS);
        yk_table_number(table, yk_shown(session, w.angle, YK_QUANTITY_ANGLE), YK_DIGITS);
        yk_table_number(table, yk_shown(session, w.mass, YK_QUANTITY_MASS), YK_DIGITS);
        yk_table_number(table, yk_shown(session, w.radius, YK_QUANTITY_LENGTH), YK_DIGITS);
    }
    yk_table_show(table, NULL, &session->out);
}

static void write_text(YkSession *session, const YkBalancing *b, double fluctuation)
{
    YkText *out = &session->out;
    double flywheel = yk_balancing_flywheel(b);
    yk_text_format(out, "%s: %s\n", yk_model_name(session->model),
                   session->request->weights ? "a compromise of shaking force, shaking moment and input effort"
                   : yk_balancing_is_full(b) ? "counterweights keep the centre of mass still"
                                             : "no counterweights keep the centre of mass still; these move it least");
    if (yk_balancing_count(b) > 0) write_weights(session, b);
    write_shaking(session, b);
    write_orders(session, b);
    if (isfinite(flywheel)) {
        yk_text_puts(out, "\nWithout counterweights, a flywheel of ");
        yk_add_value(session, out, flywheel, YK_QUANTITY_INERTIA, YK_DIGITS);
        yk_text_format(out, " on the input keeps its speed within %e of the mean.\n", fluctuation);
    }
    if (yk_balancing_turns(b) > 1)
        yk_text_format(out, "The machine and its efforts repeat after %z turns of the input.\n", yk_balancing_turns(b));
}

// --- JSON

static void add_peaks_json(YkJson *json, const char *key, YkShakingPeaks peaks)
{
    yk_json_object(json, key, YK_JSON_INLINE);
    yk_json_number(json, "force", peaks.force);
    yk_json_number(json, "moment", peaks.moment);
    yk_json_number(json, "torque", peaks.torque);
    yk_json_end(json);
}

static void add_orders_json(YkJson *json, const YkBalancing *b)
{
    yk_json_list(json, "orders", YK_JSON_LINES);
    for (size_t n = 1; n <= YK_SHAKING_ORDERS && isfinite(yk_balancing_order(b, n, false).with); n++) {
        yk_json_object(json, NULL, YK_JSON_INLINE);
        yk_json_number(json, "order", (double)n);
        for (int after = 0; after < 2; after++) {
            YkShakingOrder o = yk_balancing_order(b, n, after);
            yk_json_object(json, after ? "after" : "before", YK_JSON_INLINE);
            yk_json_number(json, "with", o.with);
            yk_json_number(json, "against", o.against);
            yk_json_number(json, "direction", o.direction);
            yk_json_end(json);
        }
        yk_json_end(json);
    }
    yk_json_end(json);
}

static void write_json(const YkSession *session, const YkBalancing *b, const YkBalancingOptions *options, YkText *text)
{
    YkJson json = {.text = text};
    yk_json_object(&json, NULL, YK_JSON_LINES);
    yk_json_string(&json, "model", yk_model_name(session->model));
    yk_json_string(&json, "status", "ok");
    yk_json_bool(&json, "full", yk_balancing_is_full(b));
    add_peaks_json(&json, "before", yk_balancing_before(b));
    add_peaks_json(&json, "after", yk_balancing_after(b));
    add_orders_json(&json, b);
    if (yk_balancing_turns(b) > 0)
        yk_json_number(&json, "turns", (double)yk_balancing_turns(b));
    else
        yk_json_number(&json, "turns", (double)NAN); // null
    yk_json_list(&json, "counterweights", YK_JSON_LINES);
    for (size_t k = 0; k < yk_balancing_count(b); k++) {
        YkCounterweight w = yk_balancing_at(b, k);
        yk_json_object(&json, NULL, YK_JSON_INLINE);
        yk_json_string(&json, "on", yk_model_body_name(session->model, w.body));
        yk_json_string(&json, "at", yk_model_joint_name(session->model, w.joint));
        yk_json_number(&json, "product", w.product);
        yk_json_number(&json, "angle", w.angle);
        yk_json_number(&json, "mass", w.mass);
        yk_json_number(&json, "radius", w.radius);
        yk_json_end(&json);
    }
    yk_json_end(&json);
    yk_json_object(&json, "flywheel", YK_JSON_INLINE);
    yk_json_number(&json, "inertia", yk_balancing_flywheel(b));
    yk_json_number(&json, "fluctuation", options->fluctuation);
    yk_json_end(&json);
    yk_add_laws_json(&json, options->laws, true);
    yk_json_string(&json, "balanced", yk_balancing_model(b));
    yk_json_end(&json);
}

// --- the verb

static bool write_files(YkSession *session, const YkBalancing *b, const YkBalancingOptions *options)
{
    YkFileEntry files[2] = {{.name = "balanced.yaml"}, {.name = "balance.json"}};
    yk_text_puts(&files[0].text, yk_balancing_model(b));
    write_json(session, b, options, &files[1].text);
    bool good = yk_files_write(session->request->output, files, 2, session->problems);
    for (size_t k = 0; k < 2; k++) yk_text_free(&files[k].text);
    return good;
}

// Reads --weights F,M,T: three numbers, none below 0 and one above.
static bool read_weights(YkSession *session, double weight[3])
{
    const char *at = session->request->weights;
    bool good = true;
    if (!at) return true;
    for (size_t k = 0; k < 3 && good; k++) {
        size_t length = strcspn(at, ",");
        good = length > 0 && yk_number_read(at, length, &weight[k]) == length && weight[k] >= 0 && weight[k] <= 1e6;
        good = good && (at[length] == ',') == (k < 2);
        at += length + (k < 2);
    }
    if (good && weight[0] + weight[1] + weight[2] > 0) return true;
    return yk_session_refuse(
        session, YK_CODE_OPTION_VALUE,
        "--weights takes three numbers from 0, as in 1,0.5,0.5, for force, moment and effort, not %q",
        session->request->weights);
}

static bool read_options(YkSession *session, YkBalancingOptions *options)
{
    enum { STEPS_MAX = 20000 };
    const YkRequest *request = session->request;
    const char *word = request->fluctuation;
    *options = yk_default_balancing_options();
    if (request->format == YK_FORMAT_CSV)
        return yk_session_refuse(session, YK_CODE_OPTION_VALUE, "--format takes text or json here, not %q", "csv");
    if (word && (yk_number_read(word, strlen(word), &options->fluctuation) != strlen(word) ||
                 !(options->fluctuation > 0) || options->fluctuation >= 2))
        return yk_session_refuse(session, YK_CODE_OPTION_VALUE, "--fluctuation takes a number between 0 and 2, not %q",
                                 word);
    if (!read_weights(session, options->weight)) return false;
    if (!yk_session_count(session, "--steps", request->steps, STEPS_MAX, options->steps, &options->steps)) return false;
    return !request->output || yk_folder_is_free(request->output, session->problems);
}

static int write_answer(YkSession *session, const YkBalancing *b, const YkBalancingOptions *options)
{
    const YkRequest *request = session->request;
    YkRequest own = *request;
    if (request->output && !write_files(session, b, options)) return YK_EXIT_WRONG;
    if (request->format == YK_FORMAT_JSON)
        write_json(session, b, options, &session->out);
    else
        write_text(session, b, options->fluctuation);
    own.output = NULL; // it named the folder
    session->request = &own;
    int exit_code = yk_session_finish(session, YK_EXIT_DONE);
    session->request = request;
    return exit_code;
}

static void warn_of_laws(YkSession *session, const YkLawWatch *laws)
{
    const YkMechanism *mech = yk_state_mechanism(session->state);
    YkCoordinateInfo input = yk_coordinate_info(mech, yk_input_coordinate(mech, 0));
    yk_warn_of_laws(session, laws, input.name, yk_quantity_of(input.is_distance, 0), "");
}

int yk_run_balance(YkSession *session)
{
    YkBalancingOptions options;
    if (!read_options(session, &options) || !yk_session_load(session, NULL) || !yk_session_inputs(session))
        return YK_EXIT_WRONG;
    YkStatus status = yk_session_reach(session, NULL);
    if (status < 0) {
        yk_reach_tell(session, status);
        return yk_status_exit(status);
    }
    options.laws = yk_session_watch_laws(session);
    YkBalancing *b = options.laws ? yk_balancing_new(session->state, &options, session->problems) : NULL;
    int exit_code = options.laws && !yk_ran_out(session->problems) ? YK_EXIT_NO_ANSWER : YK_EXIT_WRONG;
    if (b) {
        warn_of_laws(session, options.laws);
        exit_code = write_answer(session, b, &options);
    }
    yk_balancing_free(b);
    yk_law_watch_free(options.laws);
    return exit_code;
}
