// Names of bodies and meshes in the formats of `yoke gears`.
#include "verbs/gears/gears.h"

const char *yk_gears_body(const YkGearsAnswer *answer, size_t body)
{
    return yk_model_body_name(answer->session->model, body);
}

const char *yk_gears_kind(YkTrainKind kind)
{
    return kind == YK_TRAIN_KIND_GEARS ? "gears" : kind == YK_TRAIN_KIND_BELT ? "belt" : "rack";
}
