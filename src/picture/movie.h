// Drawings that move, as files: SVG by itself, GIF, MP4 and WebM by rsvg-convert and ffmpeg.
#ifndef PICTURE_MOVIE_H
#define PICTURE_MOVIE_H
#include <yoke/draw.h>
#include <yoke/problem.h>
#include "base/text.h"

typedef enum YkMovieKind { YK_MOVIE_SVG, YK_MOVIE_GIF, YK_MOVIE_MP4, YK_MOVIE_WEBM, YK_MOVIE_OTHER } YkMovieKind;
YkMovieKind yk_movie_kind(const char *path); // by its ending
// Returns the number of poses per second of a movie of this kind.
double yk_movie_rate(YkMovieKind kind);

// Adds the movie of a drawing's poses (options.moving), which take `seconds`, in a loop; to_and_fro: it goes
// back as well. Returns false with a problem added: E0710 if a program is missing, E0711 if it fails.
// Cost: a run of rsvg-convert per pose.
bool yk_movie_write(YkDrawing *drawing, YkMovieKind kind, double seconds, bool to_and_fro, YkText *output,
                    YkProblems *problems);

#endif
