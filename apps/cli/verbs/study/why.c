// Says why a design makes no machine: reads the model file with its values, as a user would with --param.
#include <string.h>
#include <yoke/builder.h>
#include "base/number.h"
#include "session.h"
#include "study.h"

// Reads and compiles the file with the values of a design; its problems go to `found`.
static void read_design(const YkStudyAnswer *a, char (*texts)[YK_NUMBER_SIZE], YkProblems *found)
{
    const YkSession *session = a->session;
    YkOverride *overrides = yk_session_alloc(a->session, a->axis_count + 1, sizeof *overrides);
    const char *text = yk_model_text(session->model);
    for (size_t k = 0; overrides && k < a->axis_count; k++) overrides[k] = (YkOverride){a->axes[k].name, texts[k]};
    YkLoadOptions options = {.parameters = overrides, .parameter_count = a->axis_count, .lock = session->request->lock};
    YkModel *model = NULL;
    if (overrides && text) model = yk_model_parse(text, strlen(text), session->request->file, &options, found);
    if (model) yk_mechanism_free(yk_mechanism_compile(model, NULL, found));
    yk_model_free(model);
}

static const YkProblem *first_error(const YkProblems *found)
{
    for (size_t k = 0; k < yk_problems_count(found); k++)
        if (yk_problems_get(found, k)->severity == YK_SEVERITY_ERROR) return yk_problems_get(found, k);
    return NULL;
}

void yk_study_tell_why(const YkStudyAnswer *a)
{
    const size_t design = a->sum.bad;
    const YkDesigns designs = yk_study_designs(a);
    if (design == YK_NOT_FOUND) return;
    double *own = yk_session_alloc(a->session, a->axis_count + 1, sizeof *own);
    char(*texts)[YK_NUMBER_SIZE] = yk_session_alloc(a->session, a->axis_count + 1, sizeof *texts);
    YkProblems *found = yk_problems_new();
    YkText values = {0};
    if (own) yk_designs_at(&designs, design, own);
    for (size_t k = 0; own && texts && k < a->axis_count; k++) {
        const char *name = a->axes[k].name;
        yk_number_write(own[k] / yk_model_parameter_unit(a->session->model, name), texts[k]);
        yk_text_format(&values, "%s%s = %s", k > 0 ? ", " : "", name, texts[k]);
    }
    if (own && texts && found) read_design(a, texts, found);
    const YkProblem *error = found ? first_error(found) : NULL;
    if (error)
        yk_problem_hint(a->session->problems, "design %z (%s) makes no machine: %s [E0%d]", design,
                        yk_text_get(&values), error->message, error->code);
    yk_text_free(&values);
    yk_problems_free(found);
}
