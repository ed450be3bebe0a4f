// Coordinates: named at their joint, or referred to as JOINT.angle and JOINT.distance.
#include <string.h>
#include "model/load.h"

static bool is_taken(YkLoader *loader, const char *name, YkPlace place)
{
    const YkModel *model = loader->model;
    int32_t parameter = yk_names_find(&model->parameter_names, name);
    int32_t coordinate = yk_names_find(&model->coordinate_names, name);
    if (parameter == YK_NONE && coordinate == YK_NONE) return false;
    YkPlace first = parameter == YK_NONE ? model->coordinates[coordinate].place : model->parameters[parameter].place;
    yk_problem(loader->problems, YK_CODE_REPEATED_NAME, place, "%q is already the name of a %s", name,
               parameter == YK_NONE ? "coordinate" : "parameter");
    yk_problem_hint(loader->problems, "the first is on line %u", (unsigned)first.line);
    return true;
}

int32_t yk_load_declare(YkLoader *loader, const char *name, YkPlace place, int32_t joint, bool is_distance)
{
    YkModel *model = loader->model;
    if (is_taken(loader, name, place)) return YK_NONE;
    if (!YK_ROOM_IN(loader->arena, model->coordinates, model->coordinate_count, loader->coordinate_capacity))
        return YK_NONE;
    int32_t index = (int32_t)model->coordinate_count, existing;
    if (!yk_names_add(&model->coordinate_names, name, index, &existing)) {
        loader->failed = true;
        return YK_NONE;
    }
    model->coordinates[model->coordinate_count++] =
        (YkCoordinate){.name = name, .place = place, .joint = joint, .is_distance = is_distance, .drive = YK_NONE};
    return index;
}

// Returns the coordinate JOINT.angle or JOINT.distance; declares it now if it has no name yet.
static int32_t joint_coordinate(YkLoader *loader, const char *name, YkPlace place)
{
    const char *dot = strrchr(name, '.');
    if (!dot) return YK_NONE;
    bool is_distance = strcmp(dot, ".distance") == 0;
    if (!is_distance && strcmp(dot, ".angle") != 0) return YK_NONE;
    const char *joint_name = yk_arena_copy(loader->arena, name, (size_t)(dot - name));
    int32_t index = joint_name ? yk_names_find(&loader->model->joint_names, joint_name) : YK_NONE;
    if (index == YK_NONE) return YK_NONE;
    YkJoint *joint = &loader->model->joints[index];
    const YkPart *part = yk_part(joint->is_free ? YK_FREE : joint->kind);
    if (!part) return YK_REPORTED;
    if (joint->is_free ? is_distance : is_distance ? !part->slides : !part->turns) {
        yk_problem(loader->problems, YK_CODE_COORDINATE_KIND, place, "a %s has no %s", part->key, dot + 1);
        return YK_REPORTED;
    }
    int32_t *coordinate = is_distance ? &joint->distance : &joint->angle;
    if (*coordinate == YK_NONE) *coordinate = yk_load_declare(loader, name, place, index, is_distance);
    return *coordinate;
}

int32_t yk_load_coordinate(YkLoader *loader, const char *text, YkPlace place, bool *is_rate)
{
    static const char ending[] = ".rate";
    size_t length = strlen(text), cut = sizeof ending - 1;
    *is_rate = length > cut && strcmp(text + length - cut, ending) == 0;
    const char *name = *is_rate ? yk_arena_copy(loader->arena, text, length - cut) : text;
    if (!name) return YK_NONE;
    int32_t found = yk_names_find(&loader->model->coordinate_names, name);
    return found == YK_NONE ? joint_coordinate(loader, name, place) : found;
}

const char *yk_load_rate_name(YkLoader *loader, const char *coordinate)
{
    yk_text_clear(&loader->text);
    yk_text_format(&loader->text, "%s.rate", coordinate);
    const char *name = yk_arena_copy(loader->arena, yk_text_get(&loader->text), strlen(coordinate) + 5);
    return name ? name : "";
}

int32_t yk_load_coordinate_key(YkLoader *loader, const YkNode *key, bool *is_rate)
{
    bool rate = false;
    int32_t found = yk_load_coordinate(loader, key->text, key->place, &rate);
    if (found == YK_NONE) {
        const YkModel *model = loader->model;
        yk_problem(loader->problems, YK_CODE_UNKNOWN_COORDINATE, key->place, "no joint has a coordinate %q", key->text);
        if (!yk_load_hint_nearest(loader->problems, key->text, model->coordinates, model->coordinate_count,
                                  sizeof *model->coordinates)) {
            yk_problem_hint(loader->problems, "name it at its joint by `angle:` or `distance:`");
        }
    } else if (found >= 0 && rate && !is_rate) {
        yk_problem(loader->problems, YK_CODE_RATE_NOT_HERE, key->place,
                   "%q is a rate; the coordinate itself is expected", key->text);
        found = YK_REPORTED;
    }
    if (is_rate) *is_rate = rate;
    return found;
}

unsigned char *yk_load_new_seen(YkLoader *loader, const YkNode *section)
{
    return YK_NEW(loader->arena, unsigned char, loader->model->coordinate_count + section->count + 1);
}

static bool is_first_time(YkLoader *loader, unsigned char *seen, int32_t coordinate, unsigned char bit,
                          const YkNode *key)
{
    bool is_first = !(seen[coordinate] & bit);
    seen[coordinate] |= bit;
    if (!is_first) {
        yk_problem(loader->problems, YK_CODE_GIVEN_TWICE, key->place,
                   "%q is given here a second time, under another name", loader->model->coordinates[coordinate].name);
    }
    return is_first;
}

int32_t yk_load_coordinate_once(YkLoader *loader, const YkNode *key, unsigned char *seen, bool *is_rate)
{
    int32_t coordinate = yk_load_coordinate_key(loader, key, is_rate);
    if (coordinate < 0) return coordinate;
    unsigned char bit = is_rate && *is_rate ? 2 : 1;
    return is_first_time(loader, seen, coordinate, bit, key) ? coordinate : YK_REPORTED;
}
