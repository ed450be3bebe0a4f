// yoke new: a machine to start from, from the gallery.
#include <string.h>
#include "base/names.h"
#include "session.h"
#include "verbs/new/gallery.h"
#include "verbs/new/tasks.h"

static void list_gallery(YkText *text)
{
    size_t widest = 0;
    for (size_t k = 0; k < yk_gallery_count; k++)
        if (strlen(yk_gallery[k].name) > widest) widest = strlen(yk_gallery[k].name);
    for (size_t k = 0; k < yk_gallery_count; k++) {
        const YkExample *example = &yk_gallery[k];
        bool is_first = k == 0 || strcmp(example->family, yk_gallery[k - 1].family) != 0;
        if (is_first) yk_text_format(text, "%s%s\n", k == 0 ? "" : "\n", example->family);
        yk_text_format(text, "  %s", example->name);
        for (size_t pad = strlen(example->name); pad < widest + 2; pad++) yk_text_puts(text, " ");
        yk_text_format(text, "%s: %s\n", example->machine, example->shows);
    }
    yk_text_puts(
        text,
        "\n`yoke new NAME > my.yaml` starts from one of them; `yoke new NAME | yoke check -` looks at it first.\n");
}

static const YkExample *find(const char *name)
{
    for (size_t k = 0; k < yk_gallery_count; k++)
        if (strcmp(yk_gallery[k].name, name) == 0) return &yk_gallery[k];
    return NULL;
}

static int refuse(YkSession *session, const char *name)
{
    enum { MOST = 256 };
    const char *names[MOST], *nearest;
    size_t count = 0;
    for (; count < yk_gallery_count && count < MOST; count++) names[count] = yk_gallery[count].name;
    yk_session_refuse(session, YK_CODE_UNKNOWN_EXAMPLE, "there is no machine %q in the gallery", name);
    nearest = yk_nearest(name, names, count);
    if (nearest)
        yk_problem_hint(session->problems, "did you mean %q? `yoke new` alone lists them all", nearest);
    else
        yk_problem_hint(session->problems, "`yoke new` alone lists them all");
    return YK_EXIT_WRONG;
}

// The module for browsers has the gallery's list, and one of its files.
static int refuse_here(YkSession *session, const char *name)
{
    yk_session_refuse(session, YK_CODE_UNKNOWN_EXAMPLE, "this module lists %q, but does not contain its file", name);
    yk_problem_hint(session->problems, "the page has it: press Examples");
    return YK_EXIT_WRONG;
}

// Writes a task file of a kind; refuses kinds that are not there.
static int new_task(YkSession *session, const char *kind)
{
    for (size_t k = 0; k < yk_task_example_count; k++) {
        if (strcmp(yk_task_examples[k].kind, kind) != 0) continue;
        yk_text_puts(&session->out, yk_task_examples[k].text);
        return yk_session_finish(session, YK_EXIT_DONE);
    }
    yk_session_refuse(session, YK_CODE_OPTION_VALUE, "--task takes path, motion, function, stroke or machine, not %q",
                      kind);
    return YK_EXIT_WRONG;
}

int yk_run_new(YkSession *session)
{
    if (session->request->task) return new_task(session, session->request->task);
    const char *name = session->request->file;
    const YkExample *example = name ? find(name) : NULL;
    if (name && !example) return refuse(session, name);
    if (example && !example->text) return refuse_here(session, name);
    if (example)
        yk_text_add(&session->out, (const char *)example->text, example->size);
    else
        list_gallery(&session->out);
    return yk_session_finish(session, YK_EXIT_DONE);
}
