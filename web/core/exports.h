// The flat functions that a page calls (engine.ts); each is described where it is defined.
#ifndef CORE_EXPORTS_H
#define CORE_EXPORTS_H
#include <stddef.h>

#if defined(__wasm__)
#define YK_DOOR(name) __attribute__((export_name(#name)))
#else
#define YK_DOOR(name)
#endif

char *ys_input(size_t length);
double *ys_numbers(void);
size_t ys_number_count(void);
double *ys_number_room(size_t count);
const char *ys_text(void);
size_t ys_text_length(void);
const char *ys_message(void);
const char *ys_status_name(int status);
const char *ys_version(void);
int ys_curves(double from, double to, size_t steps);
int ys_trace(size_t body, double x, double y, double from, double to, size_t steps);
int ys_ghosts(void);
int ys_ghost(size_t index);
int ys_choose(size_t index);
double ys_time(void);
int ys_at(size_t count);
int ys_move_time(double time);
int ys_drag(size_t body, double x, double y, double to_x, double to_y);
int ys_look(double scale);
int ys_open(size_t length);
int ys_parameter(double value);
int ys_release(void);
int ys_pull(size_t body, double x, double y, double to_x, double to_y, double stiffness);
int ys_step(double seconds);
int ys_hold(void);
int ys_rates(void);
int ys_forces(void);
int ys_turn(size_t coordinate);
int ys_save(void);
int ys_restore(size_t length);
int ys_scene(void);
int ys_pose(void);
void ys_close(void);

#endif
