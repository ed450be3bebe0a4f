// Saves a simulation as bytes, restores it from them, and clones it that way.
//
// The bytes are a mark, the format's version, their number, the machine's fingerprint, the data for remaking the
// machine, the rest, and a sum over everything before it.
#include "simulate/archive.h"
#include "simulate/fingerprint.h"
#include <stdlib.h>

static const uint64_t MARK = UINT64_C(0x0a0d4d49534b591b); // no text begins like this
enum { VERSION = 6 };                                      // of the bytes and their meaning: any change raises it

typedef struct Head {
    uint64_t mark, version, count, fingerprint;
} Head;

static void walk_head(YkArchive *a, Head *head)
{
    uint64_t *const all[] = {&head->mark, &head->version, &head->count, &head->fingerprint};
    for (size_t k = 0; k < sizeof all / sizeof *all; k++) yk_archive_whole(a, all[k]);
}

// The parts that exist, read first so that there is room for them.
typedef struct Parts {
    size_t chosen_count;
    bool has_efforts, has_commands, has_control;
} Parts;

static Parts parts_of(const YkSimulation *sim)
{
    return (Parts){sim->chosen_count, sim->has_effort && sim->effort, sim->commands != NULL,
                   sim->sampling.control != NULL};
}

static void walk_parts(YkArchive *a, Parts *parts)
{
    yk_archive_sizes(a, (size_t *const[]){&parts->chosen_count}, 1);
    yk_archive_flags(a, &parts->has_efforts, 1);
    yk_archive_flags(a, &parts->has_commands, 1);
    yk_archive_flags(a, &parts->has_control, 1);
}

static void walk_efforts(YkSimulation *sim, YkArchive *a, size_t coordinates)
{
    yk_archive_flags(a, sim->has_effort, 2 * coordinates);
    yk_archive_numbers(a, sim->effort, 2 * coordinates);
}

// --- writing --------------------------------------------------------------------------------------

static void write_all(YkSimulation *sim, YkArchive *a, Head *head)
{
    Parts parts = parts_of(sim);
    walk_head(a, head);
    yk_simulation_archive_options(sim, a);
    walk_parts(a, &parts);
    yk_simulation_archive_flights(sim, a);
    yk_simulation_archive_choice(a, sim->chosen, sim->chosen_count, sim->mech->coordinate_count);
    if (parts.has_efforts) walk_efforts(sim, a, sim->mech->coordinate_count);
    yk_simulation_archive_rest(sim, a);
}

size_t yk_simulation_save(YkSimulation *sim, void *bytes, size_t capacity)
{
    YkArchive counting = {0}, writing = {.bytes = bytes, .capacity = capacity};
    Head head = {MARK, VERSION, 0, yk_fingerprint(sim->model)};
    write_all(sim, &counting, &head);
    head.count = counting.at + 8;
    if (!bytes || capacity < head.count) return (size_t)head.count;
    write_all(sim, &writing, &head);
    uint64_t sum = yk_archive_sum(bytes, writing.at);
    yk_archive_whole(&writing, &sum);
    return writing.at;
}

// --- reading --------------------------------------------------------------------------------------

// Makes the machine as it was when it was saved, without a pose. Arrays of coordinates are as long as in any of its
// mechanisms.
static bool make(YkSimulation *sim, YkArchive *a, const Parts *parts, const YkMechanism *mech)
{
    size_t n = mech->coordinate_count, inputs = parts->chosen_count;
    int32_t *chosen = calloc(inputs + 1, sizeof *chosen);
    const char **names = calloc(inputs + 1, sizeof *names);
    YkProblems *quiet = yk_problems_new();
    yk_simulation_archive_flights(sim, a);
    if (parts->has_efforts) {
        sim->has_effort = calloc(2 * n, sizeof *sim->has_effort);
        sim->effort = calloc(2 * n, sizeof *sim->effort);
    }
    if (parts->has_commands) sim->commands = calloc(n, sizeof *sim->commands);
    bool ok = chosen && names && quiet && (!parts->has_efforts || (sim->has_effort && sim->effort)) &&
              (!parts->has_commands || sim->commands);
    if (ok) yk_simulation_archive_choice(a, chosen, inputs, n);
    for (size_t k = 0; ok && k < inputs; k++) names[k] = mech->coordinates[chosen[k]].name;
    if (ok && parts->has_efforts) walk_efforts(sim, a, n);
    ok = ok && !a->failed &&
         yk_simulation_build(sim, &(YkCompileOptions){.inputs = names, .input_count = inputs}, quiet) &&
         yk_simulation_stepper(sim);
    yk_problems_free(quiet);
    free(names);
    free(chosen);
    return ok;
}

static bool is_whole(const unsigned char *bytes, size_t count, Head *head)
{
    YkArchive a = {.bytes = (unsigned char *)bytes, .capacity = count, .is_reading = true};
    walk_head(&a, head);
    if (a.failed || head->mark != MARK || head->version != VERSION || head->count != count || count < 8) return false;
    uint64_t sum;
    a.at = count - 8;
    yk_archive_whole(&a, &sum);
    return sum == yk_archive_sum(bytes, count - 8);
}

static YkSimulation *read_all(const YkSimulation *like, YkArchive *a, YkStatus *status)
{
    YkSimulation head = {.options = like->options}, *sim = NULL;
    Parts parts = {0};
    yk_simulation_archive_options(&head, a);
    walk_parts(a, &parts);
    a->failed = a->failed || parts.chosen_count > like->mech->coordinate_count;
    bool ok = !a->failed && (sim = yk_simulation_blank(like->model, &head.options, NULL)) != NULL &&
              make(sim, a, &parts, like->mech);
    if (ok) {
        if (parts.has_control) sim->sampling = like->sampling;
        yk_simulation_archive_rest(sim, a);
        ok = !yk_arena_failed(sim->arena);
        a->failed = a->failed || (ok && a->at + 8 != a->capacity);
    }
    *status = a->failed ? YK_BAD_ARGUMENT : ok ? YK_OK : YK_NO_MEMORY;
    if (*status == YK_OK) return sim;
    yk_simulation_free(sim);
    return NULL;
}

YkStatus yk_simulation_restore(YkSimulation *sim, const void *bytes, size_t count)
{
    Head head = {0};
    if (sim->is_in_control || !bytes || !is_whole(bytes, count, &head)) return YK_BAD_ARGUMENT;
    if (head.fingerprint != yk_fingerprint(sim->model)) return YK_BAD_MODEL;
    YkArchive a = {.bytes = (unsigned char *)bytes, .capacity = count, .is_reading = true};
    walk_head(&a, &head);
    YkStatus status;
    YkSimulation *next = read_all(sim, &a, &status);
    if (!next) return status;
    yk_simulation_replace(sim, next);
    return YK_OK;
}

YkSimulation *yk_simulation_clone(YkSimulation *sim)
{
    size_t count = yk_simulation_save(sim, NULL, 0);
    unsigned char *bytes = malloc(count);
    YkSimulation *clone = NULL;
    YkStatus status;
    if (bytes && yk_simulation_save(sim, bytes, count) == count) {
        Head head;
        YkArchive a = {.bytes = bytes, .capacity = count, .is_reading = true};
        walk_head(&a, &head);
        clone = read_all(sim, &a, &status);
    }
    free(bytes);
    return clone;
}
