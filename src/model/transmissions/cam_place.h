// The place of a cam relative to its follower: what follows from the points and directions of their joints.
#ifndef MODEL_TRANSMISSIONS_CAM_PLACE_H
#define MODEL_TRANSMISSIONS_CAM_PLACE_H
#include "law/law.h"
#include "model/model.h"

// Reasons why the follower cannot touch the cam.
typedef enum YkCamFault {
    YK_CAM_FITS,
    YK_CAM_OFFSET,     // of a slide: not less than base and roller together
    YK_CAM_LIFT,       // at its lowest, the follower reaches the cam's centre
    YK_CAM_CENTERS,    // both turn about the same point
    YK_CAM_FLAT_LARGE, // a flat face cannot touch the base circle
    YK_CAM_ARM,        // no arm
    YK_CAM_REACH       // the arm is too short or too long for base and roller
} YkCamFault;

// Sets what follows from the joints, in the carrier's axes; also offset, arm or centres that the file does not give.
void yk_cam_place(const YkModel *model, YkCam *cam);
// Returns whether the centres that the file gives agree with the pins' points.
bool yk_cam_centers_agree(const YkCam *cam);
// lowest: the law's least value; 0 if there is no law.
YkCamFault yk_cam_fault(const YkCam *cam, double lowest);
double yk_cam_lowest_lift(const YkLaw *law); // from samples

// Return where a follower that turns touches the cam at lift 0, in the carrier's axes: the angle of the arm, whose end
// is at `distance` from the cam's centre, and of the normal of a flat face at `distance`, seen from the pivot. Of two
// such places it is the one that the follower leaves by turning in the sense `away`. NAN: there is none.
double yk_cam_arm_angle(YkVec pivot, double arm, double distance, double away);
double yk_cam_face_angle(YkVec pivot, double distance, double away);
// The follower's axes are the carrier's at lift 0. Returns the arm, from the follower's pin to its roller or edge; of a
// flat face the unit normal. False: the pins lie on one point, so that the place of the contact is not known.
bool yk_cam_touch(const YkCam *cam, YkVec *touch);

// Returns whether the second of two rollers lies where the lift brings it nearer to the cam, so that the two hold the
// follower between them.
bool yk_cam_pair_holds(const YkCam *cam);

// Lists the expressions on which the place of a pair's second roller depends by numbers of the cam. Some may be NULL.
// Returns how many; 0 for cams without one.
enum { YK_CAM_EXPRS = 6 };
size_t yk_cam_pair_exprs(const YkModel *model, const YkCam *cam, const YkExpr *expr[YK_CAM_EXPRS]);

#endif
