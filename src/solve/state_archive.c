// Writes and reads a state as bytes: the pose and everything on which the next pose depends.
#include "solve/state.h"

void yk_report_archive(YkReport *report, const YkMechanism *mech, YkArchive *a)
{
    int64_t status = report->status, block = report->block, joint = report->joint;
    yk_archive_choice(a, &status, YK_STOPPED, YK_SINGULAR);
    int64_t blocks = (int64_t)mech->block_count, joints = (int64_t)mech->model->joint_count;
    yk_archive_choice(a, &block, -1, blocks > 0 ? blocks - 1 : 0); // 0 before there is a report
    yk_archive_choice(a, &joint, -1, joints > 0 ? joints - 1 : 0);
    report->status = (YkStatus)status;
    report->block = (int)block;
    report->joint = (int)joint;
    yk_archive_numbers(a, &report->gap, 1);
    yk_archive_numbers(a, &report->determinant, 1);
    yk_archive_bytes(a, report->message, sizeof report->message);
    report->message[sizeof report->message - 1] = 0;
}

static void walk_inputs(YkState *s, YkArchive *a)
{
    size_t n = s->mech->input_count;
    yk_archive_numbers(a, s->input, 3 * n);
    yk_archive_numbers(a, s->valid_input, 3 * n);
    yk_archive_numbers(a, s->held, 3 * n);
    yk_archive_flags(a, s->is_held, 3 * n);
    yk_archive_numbers(a, s->arrival, n); // exactly at a change point they decide which way the machine goes on
    yk_archive_numbers(a, s->heading, n);
    yk_archive_numbers(a, &s->arrival_time, 1);
    yk_archive_numbers(a, &s->time_heading, 1);
    for (size_t i = 0; i < n; i++) {
        yk_archive_numbers(a, &s->phases[i].value, 1);
        yk_archive_numbers(a, &s->phases[i].angle, 1);
    }
    yk_archive_flags(a, &s->has_phases, 1);
}

void yk_state_archive(YkState *s, YkArchive *a)
{
    const YkMechanism *mech = s->mech;
    yk_archive_numbers(a, s->space.data, yk_space_number_count(&s->space));
    yk_archive_numbers(a, s->spare.data, yk_space_number_count(&s->spare));
    walk_inputs(s, a);
    yk_archive_numbers(a, s->reference, mech->coordinate_count);
    yk_archive_numbers(a, s->slot_reference, mech->reference_count);
    yk_archive_numbers(a, s->guess, mech->coordinate_count);
    yk_archive_flags(a, s->is_guessed, mech->coordinate_count);
    yk_archive_signs(a, s->branch, mech->block_count);
    yk_archive_numbers(a, s->valid_x, mech->column_count);
    if (mech->column_count > 0) yk_archive_numbers(a, s->groups.x, mech->column_count);
    yk_archive_numbers(a, &s->time, 1);
    yk_archive_flags(a, &s->has_pose, 1);
    yk_archive_flags(a, &s->has_rates, 1);
    yk_archive_flags(a, &s->is_regular, 1);
    yk_archive_flags(a, &s->is_clear, 1);
    yk_archive_flags(a, &s->is_kept, 1);
    yk_report_archive(&s->report, mech, a);
}
