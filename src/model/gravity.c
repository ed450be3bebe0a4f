// `gravity: [gx, gy]` in the world's axes.
#include "model/load.h"

void yk_load_gravity(YkLoader *loader)
{
    const YkNode *node = yk_node_get(loader->root, "gravity");
    YkModel *model = loader->model;
    if (!node) return;
    YkWant want = {.dimension = YK_DIM_ACCELERATION, .subject = {.noun = "gravity"}};
    YkExpr *expr[2] = {NULL, NULL};
    model->has_gravity = yk_load_pair(loader, node, &want, expr, &model->gravity);
    model->gravity_x = expr[0];
    model->gravity_y = expr[1];
}
