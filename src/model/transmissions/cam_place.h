// Where a cam stands to its follower: what follows from the points and directions of their joints.
#ifndef MODEL_TRANSMISSIONS_CAM_PLACE_H
#define MODEL_TRANSMISSIONS_CAM_PLACE_H
#include "law/law.h"
#include "model/model.h"

// Why the follower cannot touch the cam.
typedef enum YkCamFault {
    YK_CAM_FITS,
    YK_CAM_OFFSET,     // of a slide: not less than base and roller together
    YK_CAM_LIFT,       // where it is lowest, the follower reaches the cam's centre
    YK_CAM_CENTERS,    // both turn about the same place
    YK_CAM_FLAT_LARGE, // a flat face cannot touch the base circle
    YK_CAM_ARM,        // no arm
    YK_CAM_REACH       // the arm is too short or too long for base and roller
} YkCamFault;

// Sets what follows from the joints, in the carrier's axes; where the file gives no offset, arm or centres, these too.
void yk_cam_place(const YkModel *model, YkCam *cam);
// Do the centres that the file gives agree with the pins' points?
bool yk_cam_centers_agree(const YkCam *cam);
// lowest: of the law; 0 where there is none.
YkCamFault yk_cam_fault(const YkCam *cam, double lowest);
double yk_cam_lowest_lift(const YkLaw *law); // by samples

#endif
