// Writes a gear train's torques for people.
#include <math.h>
#include "answer.h"
#include "verbs/gears/gears.h"
#include "write/table.h"

static double shown(const YkGearsAnswer *answer, double torque)
{
    return yk_shown(answer->session, torque, YK_QUANTITY_TORQUE);
}

static void add_torques(const YkGearsAnswer *answer)
{
    static const char *const heads[] = {"from outside", "as", "on", "against"};
    YkTable *table = yk_table_new(6);
    for (size_t i = 0; i < 4; i++) yk_table_head(table, heads[i], NULL);
    yk_table_head(table, "torque", yk_unit_of(answer->session, YK_QUANTITY_TORQUE));
    yk_table_head(table, "power", "W");
    for (size_t i = 0; i < yk_train_torque_count(answer->train); i++) {
        YkTrainTorque torque = yk_train_torque(answer->train, i);
        yk_table_word(table, torque.name);
        yk_table_word(table, torque.role);
        yk_table_word(table, yk_gears_body(answer, torque.on));
        yk_table_word(table, yk_gears_body(answer, torque.from));
        yk_table_number(table, shown(answer, torque.torque), 6);
        yk_table_number(table, torque.power, 6);
    }
    yk_table_show(table, "Torques on the train (a rack's: its force)", &answer->session->out);
}

static void add_meshes(const YkGearsAnswer *answer)
{
    const char *unit = yk_unit_of(answer->session, YK_QUANTITY_TORQUE);
    YkTable *table = yk_table_new(7);
    yk_table_head(table, "mesh", NULL);
    yk_table_head(table, "torque on first", unit);
    yk_table_head(table, "on second", unit);
    yk_table_head(table, "on carrier", unit);
    yk_table_head(table, "driven by", NULL);
    yk_table_head(table, "rolling power", "W");
    yk_table_head(table, "loss", "W");
    for (size_t m = 0; m < yk_train_mesh_count(answer->train); m++) {
        YkTrainMesh mesh = yk_train_mesh(answer->train, m);
        yk_table_word(table, mesh.name);
        for (int k = 0; k < 2; k++) yk_table_number(table, mesh.has_power ? shown(answer, mesh.torque[k]) : NAN, 6);
        yk_table_number(table, mesh.has_power ? shown(answer, mesh.carrier_torque) : NAN, 6);
        yk_table_word(table, mesh.driver < 0 ? "-" : yk_gears_body(answer, mesh.body[mesh.driver]));
        yk_table_number(table, mesh.has_power ? mesh.rolling_power : NAN, 6);
        yk_table_number(table, mesh.has_power ? mesh.loss : NAN, 6);
    }
    yk_table_show(table, "Meshes (rolling power as seen from the carrier)", &answer->session->out);
}

static void add_power(const YkGearsAnswer *answer)
{
    YkText *out = &answer->session->out;
    YkTrainPower power = yk_train_power(answer->train);
    if (!power.is_known) return;
    yk_text_format(out, "\nPower: %e W in, %e W out, %e W lost", power.in, power.out, power.loss);
    if (power.in > 0) yk_text_format(out, "; efficiency %e", power.efficiency);
    yk_text_puts(out, "\n");
    if (power.mesh)
        yk_text_format(out, "  power circulates: %e W more than comes in goes through %s\n", power.circulating,
                       power.mesh);
}

void yk_gears_power_text(const YkGearsAnswer *answer)
{
    if (yk_train_torque_count(answer->train) == 0) return;
    add_torques(answer);
    add_meshes(answer);
    add_power(answer);
}
