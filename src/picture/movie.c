// Makes movies of drawings, by rsvg-convert and ffmpeg.
#include "picture/movie.h"
#include <stdlib.h>
#include <string.h>
#include "base/problems.h"
#include "picture/drawing/drawing.h"
#include "write/process.h"

typedef struct Kind {
    const char *ending;
    double rate; // poses a second
} Kind;

static const Kind kinds[] = {{".svg", 20}, {".gif", 20}, {".mp4", 30}, {".webm", 30}};

YkMovieKind yk_movie_kind(const char *path)
{
    size_t length = strlen(path), k = 0;
    for (; k < YK_MOVIE_OTHER; k++) {
        size_t n = strlen(kinds[k].ending);
        if (length > n && strcmp(path + length - n, kinds[k].ending) == 0) break;
    }
    return (YkMovieKind)k;
}

double yk_movie_rate(YkMovieKind kind)
{
    return kind < YK_MOVIE_OTHER ? kinds[kind].rate : 0;
}

static bool run_out(YkProblems *problems)
{
    yk_problem(problems, YK_CODE_OUT_OF_MEMORY, (YkPlace){0}, "out of memory");
    return false;
}

// --- Pictures

// Adds one pose as PNG.
static bool add_picture(YkDrawing *drawing, size_t pose, YkText *pictures, YkProblems *problems)
{
    static const char *const convert[] = {"rsvg-convert", "--format=png", NULL};
    const char *svg = yk_drawing_frame(drawing, pose);
    YkText input = {0};
    if (svg) yk_text_puts(&input, svg);
    bool good = svg && !input.failed;
    if (!good) {
        run_out(problems);
    } else if (!yk_process_filter(convert, "drawing the poses of a movie", &input, pictures, problems)) {
        yk_problem_hint(problems, "write the movie as .svg, or install librsvg2-bin");
        good = false;
    }
    yk_text_free(&input);
    return good;
}

// Adds all poses in order; the way back leaves out both ends, which are already there.
static bool add_pictures(YkDrawing *drawing, bool to_and_fro, YkText *pictures, YkProblems *problems)
{
    size_t count = drawing->pose_count;
    size_t *starts = calloc(count + 1, sizeof *starts);
    bool good = starts || run_out(problems);
    for (size_t pose = 0; good && pose < count; pose++) {
        good = add_picture(drawing, pose, pictures, problems);
        starts[pose + 1] = pictures->length;
    }
    for (size_t pose = count > 1 ? count - 1 : 1; good && to_and_fro && --pose > 0;) {
        YkText copy = {0}; // the text may move while it grows
        yk_text_add(&copy, pictures->data + starts[pose], starts[pose + 1] - starts[pose]);
        yk_text_add(pictures, yk_text_get(&copy), copy.length);
        good = (!copy.failed && !pictures->failed) || run_out(problems);
        yk_text_free(&copy);
    }
    free(starts);
    return good;
}

// --- Movies

// Standard output is a file here, with a name, so that ffmpeg can seek in it, as MP4 requires.
static bool encode(const YkText *pictures, YkMovieKind kind, double rate, YkText *output, YkProblems *problems)
{
    static const char even[] = "pad=ceil(iw/2)*2:ceil(ih/2)*2";
    static const char *const ends[][16] = {
        [YK_MOVIE_GIF] = {"-vf", "split[a][b];[a]palettegen[p];[b][p]paletteuse", "-f", "gif"},
        [YK_MOVIE_MP4] = {"-vf", even, "-c:v", "libx264", "-crf", "20", "-pix_fmt", "yuv420p", "-movflags",
                          "+faststart", "-f", "mp4"},
        [YK_MOVIE_WEBM] = {"-vf", even, "-c:v", "libvpx-vp9", "-crf", "30", "-b:v", "0", "-pix_fmt", "yuv420p",
                           "-row-mt", "1", "-f", "webm"}};
    const char *words[40] = {"ffmpeg", "-hide_banner", "-loglevel", "error", "-nostdin",  "-y",
                             "-f",     "image2pipe",   "-c:v",      "png",   "-framerate"};
    YkText frequency = {0};
    size_t count = 0;
    while (words[count]) count++;
    yk_text_format(&frequency, "%e", rate);
    words[count++] = yk_text_get(&frequency);
    words[count++] = "-i";
    words[count++] = "pipe:0";
    for (size_t k = 0; ends[kind][k]; k++) words[count++] = ends[kind][k];
    words[count] = "file:/dev/stdout";
    bool good = !frequency.failed && yk_process_filter(words, "making a movie", pictures, output, problems);
    if (!good) yk_problem_hint(problems, "write the movie as .svg, or install ffmpeg");
    yk_text_free(&frequency);
    return good;
}

bool yk_movie_write(YkDrawing *drawing, YkMovieKind kind, double seconds, bool to_and_fro, YkText *output,
                    YkProblems *problems)
{
    YkText pictures = {0};
    bool good = false;
    if (kind == YK_MOVIE_SVG) {
        const char *svg = yk_drawing_animation(drawing, seconds, to_and_fro);
        if (svg) yk_text_puts(output, svg);
        good = (svg && !output->failed) || run_out(problems);
    } else if (add_pictures(drawing, to_and_fro, &pictures, problems)) {
        double rate = drawing->pose_count > 1 ? (double)(drawing->pose_count - 1) / seconds : 1;
        good = encode(&pictures, kind, rate, output, problems);
    }
    yk_text_free(&pictures);
    return good;
}
