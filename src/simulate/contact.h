// What the files about contacts share: contact.c what they exert, impact.c blows.
#ifndef SIMULATE_CONTACT_H
#define SIMULATE_CONTACT_H
#include "simulate/simulation.h"

// Accelerations of the contacts' coordinates without them (bias); what a unit effort at each does (response, matrix).
void yk_simulation_find_responses(YkSimulation *sim);
// lambda within bounds. False where it was not found: the dynamics' report says so.
bool yk_simulation_solve_contacts(YkSimulation *sim);
YkLoadItem *yk_simulation_item(const YkSimulation *sim, size_t contact);

void yk_simulation_rest_on_stop(YkSimulation *sim, size_t item);
void yk_simulation_stick(YkSimulation *sim, size_t item, double rate);
// direction: of the sliding that begins, or 0.
void yk_simulation_let_go(YkSimulation *sim, size_t contact, double direction);
double yk_simulation_rate_floor(const YkSimulation *sim); // rates below count as rest, rad/s or sizes a second
double yk_simulation_scale(const YkSimulation *sim, const YkLoadItem *item); // 1 rad, or the machine's size

#endif
