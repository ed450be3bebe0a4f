// The pieces of a search, computed one by one for whoever distributes them.
#include <stdlib.h>
#include <string.h>
#include "synthesis/machines/machine_fit.h"
#include "synthesis/paths/path_search.h"
#include <yoke/version.h>

struct YkPieces {
    const YkTask *task;
    YkArena *arena;
    YkPace pace;
    uint64_t seed;
    size_t width, count, exact;           // exact: pieces of the exact search, which come first
    YkPathBatches *path[YK_DESIGN_KINDS]; // of the kinds that are sought, whose pieces take turns
    size_t kinds;
    YkMachineFit fit;
    bool has_fit;
};

static bool prepare_paths(YkPieces *p)
{
    YkDesignKind kind[YK_DESIGN_KINDS];
    p->kinds = yk_path_kinds(p->task, kind);
    p->width = yk_path_width(p->task);
    p->exact = yk_path_exact_pieces(p->task);
    p->count = p->exact + p->kinds * YK_PATH_BATCHES;
    for (size_t k = 0; k < p->kinds; k++) {
        p->path[k] = YK_NEW(p->arena, YkPathBatches, 1);
        if (!p->path[k] || !yk_path_batches_new(p->arena, p->task, kind[k], p->seed, p->path[k])) return false;
    }
    return true;
}

static bool prepare_machine(YkPieces *p, YkProblems *problems)
{
    p->width = yk_machine_width(p->task);
    p->count = YK_MACHINE_BATCHES;
    p->has_fit = true;
    bool good = yk_machine_fit_new(p->task, p->arena, &p->fit, problems);
    p->fit.pace = &p->pace;
    return good;
}

YkPieces *yk_pieces_new(const YkTask *task, const YkSynthesisOptions *options, YkProblems *problems)
{
    const YkSynthesisOptions own = options ? *options : yk_default_synthesis_options();
    YkPieces *p = task ? calloc(1, sizeof *p) : NULL;
    if (!task) return NULL;
    if (p) p->arena = yk_arena_new();
    size_t before = yk_problems_count(problems);
    bool good = p && p->arena;
    if (good) {
        p->task = task;
        p->seed = own.seed;
        yk_pace_begin(&p->pace, own.progress);
        if (task->kind == YK_TASK_PATH) good = prepare_paths(p);
        if (task->kind == YK_TASK_MACHINE) good = prepare_machine(p, problems);
    }
    if (good) return p;
    if (yk_problems_count(problems) == before)
        yk_problem(problems, YK_CODE_OUT_OF_MEMORY, (YkPlace){0}, "out of memory during the synthesis");
    yk_pieces_free(p);
    return NULL;
}

void yk_pieces_free(YkPieces *p)
{
    if (!p) return;
    if (p->has_fit) yk_machine_fit_free(&p->fit);
    yk_arena_free(p->arena);
    free(p);
}

size_t yk_pieces_width(const YkPieces *p)
{
    return p ? p->width : 0;
}

size_t yk_pieces_count(const YkPieces *p)
{
    return p ? p->count : 0;
}

// FNV-1a.
static uint64_t add(uint64_t hash, const void *bytes, size_t length)
{
    const unsigned char *at = bytes;
    for (size_t k = 0; k < length; k++) hash = (hash ^ at[k]) * 0x100000001b3u;
    return (hash ^ 0xff) * 0x100000001b3u;
}

uint64_t yk_pieces_signature(const YkPieces *p)
{
    if (!p) return 0;
    const YkModel *sheet = p->task->sheet, *machine = p->task->kind == YK_TASK_MACHINE ? p->task->machine.model : NULL;
    uint64_t hash = add(0xcbf29ce484222325u, yk_version(), strlen(yk_version()));
    hash = add(hash, sheet->source, sheet->source_length);
    if (machine) hash = add(hash, machine->source, machine->source_length);
    return add(hash, &p->seed, sizeof p->seed);
}

static size_t work_of(const YkPieces *p, size_t piece)
{
    if (p->task->kind == YK_TASK_MACHINE) return yk_machine_batch_work(p->task);
    if (piece < p->exact) return 1; // a path counts its own steps
    return yk_path_batch_work(p->path[(piece - p->exact) % p->kinds]);
}

static void compute(YkPieces *p, size_t piece, double *numbers)
{
    if (p->task->kind == YK_TASK_MACHINE) {
        YkMachineTry best;
        bool is_found = yk_machine_batch(&p->fit, p->seed, piece, &best);
        yk_machine_pack(p->task, &best, is_found, numbers);
        return;
    }
    if (piece < p->exact) {
        yk_path_exact_piece(p->task, p->seed, piece, &p->pace, numbers);
        return;
    }
    YkPathBatches *batches = p->path[(piece - p->exact) % p->kinds];
    bool closes = yk_path_batch(batches, (piece - p->exact) / p->kinds);
    yk_path_pack(batches, closes, numbers);
}

YkStatus yk_pieces_compute(YkPieces *p, size_t piece, double *numbers)
{
    if (!p || !numbers || piece >= p->count) return YK_BAD_ARGUMENT;
    if (!yk_pace_spend(&p->pace, 1000 * (uint64_t)work_of(p, piece))) return YK_STOPPED;
    compute(p, piece, numbers);
    return yk_pace_is_stopped(&p->pace) ? YK_STOPPED : YK_OK;
}
