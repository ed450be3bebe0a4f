// A chain: the blocks of a machine up to its last group, along a straight way of the inputs.
//
// Tubes (tube.h) follow one configuration from the beginning of the way to its end, each with exactly one solution in
// it, and each with the enclosed end of the one before.
#ifndef MAP_CHAIN_H
#define MAP_CHAIN_H
#include "map/tube.h"
#include "solve/state.h"

typedef struct YkChainPose { // of all pieces
    YkVec *x;
    double *within, *radius; // [piece]: of x; the configuration is within the first, and alone within the second
} YkChainPose;

typedef struct YkChain {
    const YkMechanism *mech;
    YkPiece *pieces;
    size_t piece_count;
    size_t *first; // [piece]: of its unknowns
    size_t unknowns;
    YkDiscs discs, over; // in the middle of an interval, and over it
    YkDiscCoefficients coefficients[2];
    double *from, *way;     // [input]: the way, which is gone from 0 to 1
    YkChainPose now, trial; // where the tubes have come to; the next place
    YkTube *tubes;          // [piece]: the last ones
    double stride;          // of the last tubes, in units of the inputs' way
    const char *outside;    // why nothing can be proved, or NULL
    size_t level;           // the piece at which the last proof failed
    size_t outside_block;   // the block because of which nothing can be proved; YK_NOT_FOUND: none
    void *memory;
} YkChain;

typedef enum YkVerdict { YK_WAY_OPEN, YK_WAY_PROVED, YK_WAY_REFUTED } YkVerdict;

// Reads the blocks of a mechanism, which must outlive the chain. Returns false when out of memory; yk_chain_end frees
// it in any case.
bool yk_chain_start(YkChain *chain, const YkMechanism *mech);
void yk_chain_end(YkChain *chain);
// Returns the memory of a pose that x, [unknowns], and the rest, [2][pieces], need in all, in numbers.
size_t yk_chain_pose_size(const YkChain *chain);
YkChainPose yk_chain_pose_in(const YkChain *chain, double *memory); // of that size
void yk_chain_copy(const YkChain *chain, const YkChainPose *to, const YkChainPose *from);
// Reads the unknowns of a pose.
void yk_chain_read(const YkChain *chain, const YkState *state, YkChainPose *pose);
// Improves a pose at a place on the way and encloses it. Returns false unless exactly one solution is proved to lie
// there, no farther away than `near`.
bool yk_chain_enclose(YkChain *chain, double at, YkChainPose *pose, double near);
// Returns whether an enclosed pose is certainly the one that another one stands for at the same inputs, which are known
// to `off` in every angle and distance.
bool yk_chain_is_same(const YkChain *chain, const YkChainPose *pose, const YkChainPose *other, double off);
// Returns whether two enclosed poses are certainly different.
bool yk_chain_is_other(const YkChain *chain, const YkChainPose *pose, const YkChainPose *other);
// Follows the configuration of `chain->now` along the way to the pose `there`; NULL: to the end of the way, where
// chain->now stands then.
YkVerdict yk_chain_follow(YkChain *chain, const YkChainPose *there);

#endif
