// Shared by the files about contacts: contact.c finds their efforts, impact.c impacts.
#ifndef SIMULATE_CONTACT_H
#define SIMULATE_CONTACT_H
#include "simulate/simulation.h"

// Finds the accelerations of the contacts' coordinates without contacts (bias), and those caused by unit efforts
// (response, matrix).
void yk_simulation_find_responses(YkSimulation *sim);
// Finds lambda within bounds. Returns false if there is no answer: the dynamics' report says so.
bool yk_simulation_solve_contacts(YkSimulation *sim);
// A contact exerts its effort along a sum of factors times differences of two unknowns of the reduced equations.
typedef struct YkContactTerm {
    int32_t b, a;
    double factor;
} YkContactTerm;
size_t yk_simulation_cam_terms(const YkSimulation *sim, size_t cam, YkContactTerm term[2]); // cam_gap.c
double yk_simulation_contact_rate(const YkSimulation *sim, size_t contact);
void yk_simulation_touch_cam(YkSimulation *sim, size_t cam); // adds a cam to the contacts, for an impact
void yk_simulation_leave_cams(YkSimulation *sim);            // and takes all of them out again
YkLoadItem *yk_simulation_item(const YkSimulation *sim, size_t contact);

void yk_simulation_rest_on_stop(YkSimulation *sim, size_t item);
void yk_simulation_stick(YkSimulation *sim, size_t item, double rate);
// direction: of the sliding that begins, or 0.
void yk_simulation_let_go(YkSimulation *sim, size_t contact, double direction);
double yk_simulation_scale(const YkSimulation *sim, const YkLoadItem *item); // 1 rad, or the machine's size

#endif
