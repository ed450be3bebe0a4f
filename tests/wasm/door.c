// The page's door, compiled for this machine: goes through every example as walk.mjs does in WebAssembly, and prints
// a line for each: a hash of all numbers, statuses and pictures. Usage: door FILE...
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "core.h"
#include "exports.h"

static uint32_t hash;

static void add(const void *data, size_t size)
{
    const unsigned char *bytes = data;
    for (size_t k = 0; k < size; k++) hash = (hash ^ bytes[k]) * 16777619u;
}

static void add_all(int status)
{
    double number = status;
    add(&number, sizeof number);
    add(ys_numbers(), ys_number_count() * sizeof number);
    add(ys_text(), ys_text_length());
}

static void put(const char *text, size_t length)
{
    char *at = ys_input(length);
    if (at) memcpy(at, text, length);
}

// Returns the first coordinate that is an input, which the page knows as driven or free; NULL if there is none.
static const char *find_input(double *value)
{
    for (size_t k = 0; k < yk_coordinate_count(yk_core.mech); k++) {
        YkCoordinateInfo info = yk_coordinate_info(yk_core.mech, k);
        if (info.input < 0 || (info.is_held && !info.has_drive)) continue;
        *value = ys_numbers()[3 * yk_model_body_count(yk_core.model) + k];
        return info.name;
    }
    return NULL;
}

static void move(const char *name, double value)
{
    for (int k = 1; k <= 4; k++) {
        put(name, strlen(name) + 1);
        *ys_number_room(1) = value + 0.1 * k;
        add_all(ys_at(1));
    }
}

static void draw_curves(void)
{
    YkText names = {0};
    yk_text_add(&names, "t", 2);
    for (size_t k = 0; k < yk_coordinate_count(yk_core.mech); k++) {
        const char *name = yk_coordinate_info(yk_core.mech, k).name;
        yk_text_add(&names, name, strlen(name) + 1);
    }
    put(yk_text_get(&names), names.length);
    add_all(ys_curves(0, 1, 12));
    yk_text_free(&names);
    put("t", 2);
    add_all(ys_trace(yk_model_body_count(yk_core.model) - 1, 0.01, 0.02, 0, 1, 12));
}

static void go_through(const char *text, size_t length)
{
    YkText both = {0};
    double value = 0;
    yk_text_add(&both, text, length);
    yk_text_add(&both, "\0machine.yaml", 13);
    put(yk_text_get(&both), both.length);
    yk_text_free(&both);
    int opened = ys_open(length);
    if (opened != 1) return;
    if (ys_scene() == 1) add(ys_text(), ys_text_length());
    int posed = ys_pose();
    add_all(posed);
    if (ys_number_count() == 0) return;
    const char *input = find_input(&value);
    size_t last = yk_model_body_count(yk_core.model) - 1;
    if (input) move(input, value);
    add_all(ys_move_time(0.3));
    double x = ys_numbers()[3 * last], y = ys_numbers()[3 * last + 1];
    add_all(ys_drag(last, 0, 0, x + 0.01, y - 0.01));
    draw_curves();
    int ghosts = ys_ghosts();
    for (int k = 0; k < ghosts; k++) add_all(ys_ghost((size_t)k));
    add_all(ys_release());
    for (int k = 0; k < 4; k++) {
        if (k == 1) ys_pull(last, 0, 0, x, y, 50);
        add_all(ys_step(0.01));
    }
    add_all(ys_hold());
}

static char *read_file(const char *path, size_t *length)
{
    FILE *file = fopen(path, "rb");
    char *text = malloc(1 << 20);
    *length = file && text ? fread(text, 1, 1 << 20, file) : 0;
    if (file) fclose(file);
    return text;
}

int main(int argc, char **argv)
{
    for (int k = 1; k < argc; k++) {
        size_t length;
        char *text = read_file(argv[k], &length);
        const char *slash = strrchr(argv[k], '/');
        hash = 2166136261u;
        if (text) go_through(text, length);
        printf("%08x %s\n", hash, slash ? slash + 1 : argv[k]);
        fflush(stdout);
        free(text);
    }
    ys_close();
    return 0;
}
