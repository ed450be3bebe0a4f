// Builds gradients of sums.
#include "equations/gradient.h"
#include "base/memory.h"

int32_t yk_column(YkGradientColumns *columns, int32_t unknown)
{
    if (unknown == 0) return YK_NONE;
    for (size_t k = 0; k < columns->count; k++)
        if (columns->unknown[k] == unknown) return (int32_t)k;
    if (!YK_ROOM(columns->unknown, columns->count, columns->capacity)) {
        columns->failed = true;
        return YK_NONE;
    }
    columns->unknown[columns->count] = unknown;
    return (int32_t)columns->count++;
}

YkGradient yk_gradient_begin(const YkElimination *e)
{
    return (YkGradient){.first_piece = (uint32_t)e->piece_count, .first_node = (uint32_t)e->node_count};
}

static int32_t only_column(const YkGradientPiece *piece)
{
    bool one = (piece->turn[0] == YK_NONE) != (piece->turn[1] == YK_NONE) && (piece->root == 0) != (piece->slot == 0);
    if (!one || piece->distance != YK_NONE) return YK_NONE;
    return piece->turn[0] == YK_NONE ? piece->turn[1] : piece->turn[0];
}

// Orders the pieces if each has a column to itself; they then take its place.
static bool make_plain(YkGradientPiece *pieces, uint32_t count)
{
    for (uint32_t k = 0; k < count; k++)
        if (only_column(&pieces[k]) == YK_NONE) return false;
    for (uint32_t k = 0; k < count; k++) {
        uint32_t at = (uint32_t)only_column(&pieces[k]);
        while (at != k && at < count) { // moves it to its place, and then the one found there
            YkGradientPiece other = pieces[at];
            if (only_column(&other) == (int32_t)at) return false; // two pieces share one column
            pieces[at] = pieces[k];
            pieces[k] = other;
            at = (uint32_t)only_column(&pieces[k]);
        }
    }
    for (uint32_t k = 0; k < count; k++) pieces[k].unit = pieces[k].root ? pieces[k].root : pieces[k].slot;
    return true;
}

void yk_gradient_end(YkElimination *e, const YkGradientColumns *columns, YkGradient *gradient)
{
    gradient->piece_count = (uint32_t)e->piece_count - gradient->first_piece;
    gradient->node_count = (uint32_t)e->node_count - gradient->first_node;
    gradient->columns = (uint32_t)columns->count;
    gradient->is_plain =
        gradient->node_count == 0 && gradient->piece_count == gradient->columns &&
        (gradient->piece_count == 0 || make_plain(e->pieces + gradient->first_piece, gradient->piece_count));
}

bool yk_gradient_add_term(YkElimination *e, YkGradientColumns *columns, YkTerm term, int32_t root, int32_t root_column,
                          int32_t row)
{
    if (!YK_ROOM(e->pieces, e->piece_count, e->piece_capacity)) return false;
    YkGradientPiece piece = {
        .root = root, .slot = term.slot, .distance = term.distance, .along = YK_NONE, .row = row, .v = term.v};
    piece.turn[0] = root_column;
    piece.turn[1] = yk_column(columns, yk_unknown_of_slot(term.slot));
    if (term.distance != YK_NONE) piece.along = yk_column(columns, yk_unknown_of_distance(e->mech, term.distance));
    e->pieces[e->piece_count++] = piece;
    return !columns->failed;
}

static bool add_node(YkElimination *e, YkGradientColumns *columns, int32_t node, double sign, int32_t row)
{
    if (node == YK_NONE) return true;
    if (!YK_ROOM(e->nodes, e->node_count, e->node_capacity)) return false;
    int32_t x = yk_unknown_of_node(e->mech, node), column = yk_column(columns, x);
    yk_column(columns, x + 1); // met together, so they are adjacent
    e->nodes[e->node_count++] = (YkNodePart){node, column, row, sign};
    return !columns->failed;
}

bool yk_gradient_add_sum(YkElimination *e, YkGradientColumns *columns, const YkSum *sum, int32_t root,
                         int32_t root_column, int32_t row)
{
    bool ok = add_node(e, columns, sum->plus, 1, row) && add_node(e, columns, sum->minus, -1, row);
    bool has_constant = root != 0 && (sum->constant.x != 0 || sum->constant.y != 0);
    if (has_constant)
        ok = ok && yk_gradient_add_term(e, columns, (YkTerm){0, YK_NONE, sum->constant}, root, root_column, row);
    for (uint32_t k = 0; ok && k < sum->count; k++)
        ok = yk_gradient_add_term(e, columns, e->mech->terms[sum->first + k], root, root_column, row);
    return ok;
}
