// yoke cognates: other machines with the same coupler curve.
#include "answer.h"
#include "reach.h"
#include "write/file_set.h"
#include "write/folder.h"
#include "write/table.h"

static const char *const link_names[] = {"ground", "input", "coupler", "output"};

static void add_point(const YkSession *session, const YkCognates *cognates, YkText *text)
{
    size_t point = yk_cognates_point(cognates), body = yk_model_point_body(session->model, point);
    yk_text_format(text, "%s.%s", yk_model_body_name(session->model, body), yk_model_point_name(session->model, point));
}

// --- text

static void add_row(const YkSession *session, YkTable *table, const char *name, const YkCandidate *c)
{
    yk_table_word(table, name);
    yk_table_word(table, c->type);
    for (size_t k = 0; k < 4; k++) {
        if (c->lengths[k] > 0)
            yk_table_number(table, yk_shown(session, c->lengths[k], YK_QUANTITY_LENGTH), YK_DIGITS);
        else
            yk_table_word(table, "-");
    }
    for (size_t k = 0; k < 2; k++)
        yk_table_number(table, yk_shown(session, c->point[k], YK_QUANTITY_LENGTH), YK_DIGITS);
    if (c->file)
        yk_table_number(table, c->worst / yk_mechanism_size(session->mech), 2);
    else
        yk_table_word(table, "");
}

static void write_text(YkSession *session, const YkCognates *cognates)
{
    const char *unit = yk_unit_of(session, YK_QUANTITY_LENGTH);
    YkCandidate own = yk_cognates_at(cognates, YK_NOT_FOUND);
    yk_text_format(&session->out, "%s: %z cognate%s with the curve of ", yk_model_name(session->model),
                   yk_cognates_count(cognates), yk_cognates_count(cognates) == 1 ? "" : "s");
    add_point(session, cognates, &session->out);
    yk_text_puts(&session->out, "\n\n");
    YkTable *table = yk_table_new(9);
    yk_table_head(table, "machine", NULL);
    yk_table_head(table, "type", NULL);
    for (size_t k = 0; k < 4; k++) yk_table_head(table, link_names[k], unit);
    yk_table_head(table, "point x", unit);
    yk_table_head(table, "y", unit);
    yk_table_head(table, "curves apart / size", NULL);
    add_row(session, table, "this", &own);
    for (size_t k = 0; k < yk_cognates_count(cognates); k++) {
        YkCandidate c = yk_cognates_at(cognates, k);
        add_row(session, table, c.file, &c);
    }
    yk_table_write(table, 2, &session->out);
    yk_table_free(table);
}

// --- JSON

static void add_cognate(YkJson *json, const YkCandidate *c)
{
    yk_json_object(json, NULL, YK_JSON_LINES);
    yk_json_string(json, "file", c->file);
    yk_json_string(json, "model", c->model);
    yk_json_string(json, "mechanism", c->mechanism);
    yk_json_string(json, "type", c->type);
    yk_json_list(json, "pivots", YK_JSON_INLINE);
    yk_json_numbers(json, NULL, c->pivots[0], 2);
    if (c->lengths[0] > 0) yk_json_numbers(json, NULL, c->pivots[1], 2);
    yk_json_end(json);
    yk_json_object(json, "lengths", YK_JSON_INLINE);
    for (size_t k = 0; k < 4; k++)
        if (c->lengths[k] > 0) yk_json_number(json, link_names[k], c->lengths[k]);
    yk_json_end(json);
    yk_json_numbers(json, "point", c->point, 2);
    yk_json_number(json, "apart", c->worst);
    yk_json_end(json);
}

static void write_json(YkSession *session, const YkCognates *cognates, YkText *text)
{
    YkText point = {0};
    YkJson json = {.text = text};
    yk_json_object(&json, NULL, YK_JSON_LINES);
    yk_json_string(&json, "model", yk_model_name(session->model));
    yk_json_string(&json, "status", "ok");
    add_point(session, cognates, &point);
    yk_json_string(&json, "of", yk_text_get(&point));
    yk_text_free(&point);
    yk_json_list(&json, "cognates", YK_JSON_LINES);
    for (size_t k = 0; k < yk_cognates_count(cognates); k++) {
        YkCandidate c = yk_cognates_at(cognates, k);
        add_cognate(&json, &c);
    }
    yk_json_end(&json);
    yk_json_end(&json);
}

// --- files

static bool write_files(YkSession *session, YkCognates *cognates)
{
    enum { MOST = 4 };
    YkFileEntry files[MOST] = {{.name = "cognates.svg"}, {.name = "cognates.json"}};
    size_t count = 2;
    const char *picture = yk_cognates_picture(cognates);
    bool good = picture != NULL;
    if (good) yk_text_puts(&files[0].text, picture);
    write_json(session, cognates, &files[1].text);
    for (size_t k = 0; k < yk_cognates_count(cognates) && count < MOST; k++) {
        YkCandidate c = yk_cognates_at(cognates, k);
        files[count].name = c.file;
        yk_text_puts(&files[count++].text, c.model);
    }
    for (size_t k = 0; k < count; k++) good = good && !files[k].text.failed;
    if (!good) yk_session_refuse_for_memory(session);
    good = good && yk_files_write(session->request->output, files, count, session->problems);
    for (size_t k = 0; k < count; k++) yk_text_free(&files[k].text);
    return good;
}

static int write_answer(YkSession *session, YkCognates *cognates)
{
    const YkRequest *request = session->request;
    YkRequest own = *request;
    if (request->output && !write_files(session, cognates)) return YK_EXIT_WRONG;
    if (request->format == YK_FORMAT_JSON)
        write_json(session, cognates, &session->out);
    else
        write_text(session, cognates);
    own.output = NULL; // it named the folder
    session->request = &own;
    int exit_code = yk_session_finish(session, YK_EXIT_DONE);
    session->request = request;
    return exit_code;
}

static bool is_asked_well(YkSession *session)
{
    const YkRequest *request = session->request;
    if (request->format == YK_FORMAT_CSV)
        return yk_session_refuse(session, YK_CODE_OPTION_VALUE, "--format takes text or json here, not %q", "csv");
    if (request->trace.count > 1)
        return yk_session_refuse(session, YK_CODE_OPTION_VALUE, "one --trace at a time: %q is one too many",
                                 request->trace.items[1]);
    return !request->output || yk_folder_is_free(request->output, session->problems);
}

int yk_run_cognates(YkSession *session)
{
    size_t point = YK_NOT_FOUND;
    if (!is_asked_well(session) || !yk_session_load(session, NULL) || !yk_session_inputs(session)) return YK_EXIT_WRONG;
    if (session->request->trace.count > 0 && !yk_session_points(session, &session->request->trace, &point))
        return YK_EXIT_WRONG;
    YkStatus status = yk_session_reach(session, NULL);
    if (status < 0) {
        yk_reach_tell(session, status);
        return yk_status_exit(status);
    }
    YkCognates *cognates = yk_cognates_new(session->state, point, session->problems);
    if (!cognates) return yk_ran_out(session->problems) ? YK_EXIT_WRONG : YK_EXIT_NO_ANSWER;
    int exit_code = write_answer(session, cognates);
    yk_cognates_free(cognates);
    return exit_code;
}
