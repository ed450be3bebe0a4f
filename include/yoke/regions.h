// The map of a machine over two freedoms: regions of the plane of two inputs in which it has equally many
// configurations, bounded by curves on which configurations meet.
//
// The plane is divided into squares, and these again, until it is proved that a square has the same number of
// configurations everywhere, or until it is as small as the tolerance asks. What remains lies along the curves, which
// are then located between the centres of squares. docs/configurations.md has the mathematics.
#ifndef YOKE_REGIONS_H
#define YOKE_REGIONS_H

#include <yoke/state.h>
#include <yoke/sweep.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct YkRegions YkRegions;

// The plane that is divided: from low to high, into squares x squares.
typedef struct YkTilePlane {
    double low[2], high[2]; // rad or m
    size_t squares;         // a side
    bool has_curves;        // whether the curves are sought too
} YkTilePlane;

// Where a map gets its tiles (yk_tiles_new) if it does not compute them itself. `get` gives tile `tile` of the `count`
// that a plane has, as yk_tiles_compute gives it: words that stay until its next call. It is called for the tiles of
// one plane after the other, and of each in ascending order. It returns YK_OK, or an error, with which the map ends.
typedef struct YkTileSource {
    YkStatus (*get)(void *context, const YkTilePlane *plane, size_t tile, size_t count, const uint32_t **words,
                    size_t *word_count);
    void *context;
} YkTileSource;

typedef struct YkRegionsOptions {
    // How wide a square may stay unproved, over the larger extent of the map: from 1e-4 to 0.1. A region, or a part of
    // one, that is narrower may be missing. Default 1e-3.
    double tolerance;
    YkTileSource tiles; // {NULL}: the map computes them itself
} YkRegionsOptions;
YK_API YkRegionsOptions yk_default_regions_options(void);

// Maps two coordinates that are inputs of the state's mechanism; other inputs keep the state's values. `start` is
// assembled. An angle is mapped over the whole turns after which everything repeats, a distance over all values for
// which the machine can close, as long as its loops limit them. Progress of the state watches it. options may be NULL.
// Returns NULL with a problem if the machine has a part that cannot be mapped (the message names it), for two equal
// coordinates or one that is not an input, or when out of memory or stopped.
// Cost: some 20 squares for each tolerance's length of the curves, each a proof for every configuration; 3 bytes for
// each square of the tolerance, so 0.8 GB at 1e-4, and what the curves take.
YK_API YkRegions *yk_regions_new(YkState *start, size_t first, size_t second, const YkRegionsOptions *options,
                                 YkProblems *problems);
YK_API void yk_regions_free(YkRegions *regions);

// The tiles of a map, for programs that distribute it over threads, processes or machines. A tile is a square of the
// plane, of which there are some hundreds; it depends only on the machine, the plane and its number, so it does not
// matter who computes it, or when.
typedef struct YkTiles YkTiles;
// Prepares to compute tiles, with arguments, progress and errors as for yk_regions_new. The state must outlive them.
YK_API YkTiles *yk_tiles_new(YkState *start, size_t first, size_t second, YkProblems *problems);
YK_API void yk_tiles_free(YkTiles *tiles);
// Computes a tile of a plane: words that stay until the next call. Returns YK_OK, YK_STOPPED, YK_NO_MEMORY, or
// YK_BAD_ARGUMENT for a tile or a plane that does not exist. Cost: some hundred squares; and for each new plane some
// thousand.
YK_API YkStatus yk_tiles_compute(YkTiles *tiles, const YkTilePlane *plane, size_t tile, const uint32_t **words,
                                 size_t *word_count);

// Returns whether all that is not proved lies along the curves that were found, and at single places where a dyad of
// equal links turns freely, which the message names.
YK_API bool yk_regions_are_complete(const YkRegions *regions);
YK_API const char *yk_regions_message(const YkRegions *regions); // what is proved, or what is not, in one sentence
YK_API size_t yk_regions_coordinate(const YkRegions *regions, int axis); // 0 or 1
YK_API YkRange yk_regions_domain(const YkRegions *regions, int axis);    // rad or m
YK_API double yk_regions_tolerance(const YkRegions *regions, int axis);  // how wide squares may stay unproved, rad or m
// Returns which part of the domain's area is proved, from 0 to 1.
YK_API double yk_regions_proved(const YkRegions *regions);
// Returns the number of configurations at a pose within the domain, read from the map, or -1 outside the domain.
// *proved (may be NULL) becomes whether it is proved there.
YK_API int yk_regions_at(const YkRegions *regions, double first, double second, bool *proved);

// The regions in which the machine closes, the one that contains the start first, then the largest first. Regions that
// touch along the edge of the domain of an angle are two.
YK_API size_t yk_regions_count(const YkRegions *regions);
typedef struct YkRegion {
    int configurations;
    bool contains_start;
    double area; // in rad^2, rad m or m^2
    YkRange range[2];
    size_t outlines; // the first is around it, the others around its holes
    size_t bounds;
} YkRegion;
YK_API YkRegion yk_regions_region(const YkRegions *regions, size_t region); // all 0 beyond the last
// Returns an outline as a closed polygon, [count][2], counter-clockwise around the region and clockwise around holes.
// Its corners lie on the curves to about 1e-5 of the tolerance, except where curves meet: there, to the tolerance.
// Neighbours share their corners. NULL for a wrong index.
YK_API const double *yk_regions_outline(const YkRegions *regions, size_t region, size_t outline, size_t *count);
// A bound of a region: a block, whose configurations meet there, or the domain's edge; and its part of the region's
// outlines. The largest comes first.
typedef struct YkRegionBound {
    int block; // -1: the domain's edge
    double part;
} YkRegionBound;
YK_API YkRegionBound yk_regions_bound(const YkRegions *regions, size_t region, size_t bound);

// A drawing: the regions in colours, darker where there are more configurations, and the curves.
typedef struct YkRegionsPicture {
    const char *names[2], *units[2]; // for the axes; a name may be NULL: the coordinate's own
    double scale[2];                 // what 1 rad or 1 m is in the unit
} YkRegionsPicture;
// Returns the drawing as SVG, valid until the next call; NULL when out of memory.
YK_API const char *yk_regions_picture(YkRegions *regions, const YkRegionsPicture *options);

#ifdef __cplusplus
}
#endif

#endif
