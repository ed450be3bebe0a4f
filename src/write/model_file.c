// A model as a file.
#include <yoke/builder.h>
#include "base/problems.h"
#include "model/model.h"
#include "write/file.h"

YkStatus yk_model_write(const YkModel *model, const char *path, YkProblems *problems)
{
    YkProblems *found = yk_problems_new();
    if (!found) return YK_NO_MEMORY;
    bool good = yk_file_write(path, model->source, model->source_length, found);
    YkStatus status = good ? YK_OK : yk_problems_ran_out(found) ? YK_NO_MEMORY : YK_IO;
    yk_problems_pass_on(problems, found, NULL);
    yk_problems_free(found);
    return status;
}
