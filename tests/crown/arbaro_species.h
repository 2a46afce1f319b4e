#pragma once

#include <string>
#include <string_view>

namespace frond {

/// What decides how many stems and leaves a species of Arbaro has, as its file gives it, and how many Arbaro
/// makes of it on average over seeds.
struct KnownSpecies {
  std::string_view name, params;
  int stems, leaves;
};

inline constexpr KnownSpecies kKnownSpecies[] = {
    {"palm",
     "Shape 4 Levels 2 Scale 12 ScaleV 10 BaseSize .95 Ratio .015 RatioPower 2 Leaves 250 LeafDistrib 4 "
     "0Taper 2.1 0CurveRes 12 0Curve 20 0CurveBack -5 0CurveV 10 "
     "1DownAngle 70 1DownAngleV -80 1Rotate 120 1RotateV 60 1Branches 33 1Length .4 1LengthV .05 "
     "1CurveRes 9 1Curve 50 1CurveV 20 2DownAngle 50 2DownAngleV -50 2Rotate -120 2RotateV 20",
     34, 8147},
    {"quaking aspen",
     "Shape 7 Levels 3 Scale 13 ScaleV 3 BaseSize .4 Ratio .015 RatioPower 1.2 Leaves 25 AttractionUp .5 "
     "0CurveRes 3 0CurveV 20 1DownAngle 60 1DownAngleV -50 1Rotate 140 1Branches 50 1Length .3 "
     "1CurveRes 5 1Curve -40 1CurveV 50 2DownAngle 45 2DownAngleV 10 2Rotate 140 2Branches 30 2Length .6 "
     "2CurveRes 3 2Curve -40 2CurveV 75 3DownAngle 45 3DownAngleV 10 3Rotate 77",
     1224, 22000},
    {"sassafras",
     "Shape 2 Levels 4 Scale 23 ScaleV 7 BaseSize .2 Ratio .02 RatioPower 1.3 Leaves 15 AttractionUp .5 "
     "0Taper 1.05 0CurveRes 16 0CurveV 60 1DownAngle 90 1DownAngleV -10 1Rotate 140 1Branches 15 1Length .4 "
     "1CurveRes 15 1Curve -60 1CurveBack 30 1CurveV 200 2DownAngle 50 2DownAngleV 10 2Rotate 140 "
     "2Branches 20 2Length .7 2CurveRes 8 2Curve -40 2CurveV 300 3DownAngle 45 3DownAngleV 10 3Rotate 140 "
     "3Branches 30 3Length .4 3CurveRes 3 3CurveV 200",
     5106, 55000},
    {"european larch",
     "Shape 0 Levels 3 Scale 15 ScaleV 7 BaseSize .25 Ratio .015 RatioPower 1.3 Leaves 100 LeafQuality .5 "
     "LeafDistrib 3 AttractionUp -2 0CurveRes 20 0CurveV 20 1DownAngle 60 1DownAngleV -50 1Rotate 70 "
     "1RotateV 30 1Branches 60 1BranchDist .5 1Length .25 1LengthV .15 1CurveRes 17 1Curve 20 "
     "1CurveBack -100 1CurveV 120 2DownAngle 70 2DownAngleV 30 2Rotate 70 2RotateV 30 2Branches 50 "
     "2Length .3 2LengthV .1 2SegSplits .15 2SplitAngle 40 2SplitAngleV 10 2CurveRes 7 3DownAngle 30",
     4586, 162000},
    {"black tupelo",
     "Shape 4 Levels 4 Scale 23 ScaleV 5 BaseSize .2 Ratio .015 RatioPower 1.3 Leaves 6 AttractionUp .5 "
     "0Taper 1.1 0CurveRes 10 0CurveV 40 1DownAngle 60 1DownAngleV -40 1Rotate 140 1Branches 50 1Length .3 "
     "1LengthV .05 1CurveRes 10 1CurveV 90 2DownAngle 30 2DownAngleV 10 2Rotate 140 2Branches 25 2Length .6 "
     "2LengthV .1 2CurveRes 10 2Curve -10 2CurveV 150 3DownAngle 45 3DownAngleV 10 3Rotate 140 "
     "3Branches 12 3Length .4 3CurveRes 1",
     9314, 37200},
    {"eastern cottonwood",
     "Shape 3 Levels 3 Scale 25 ScaleV 5 BaseSize .2 Ratio .02 RatioPower 1.3 Leaves 40 AttractionUp .5 "
     "0BaseSplits 3 0Taper .95 0SplitAngle 20 0SplitAngleV 5 0CurveRes 8 0Curve 15 0CurveV 90 "
     "1DownAngle 45 1DownAngleV -35 1Rotate 140 1Branches 40 1Length .3 1SplitAngle 15 1SplitAngleV 30 "
     "1CurveRes 10 1Curve -10 1CurveV 200 2DownAngle 45 2DownAngleV 10 2Rotate 140 2Branches 30 2Length .7 "
     "2CurveRes 2 2CurveV 200 3DownAngle 45 3DownAngleV 10 3Rotate 140",
     1244, 36000},
    {"desert bush",
     "Shape 0 Levels 3 Scale 3 ScaleV 1 BaseSize .1 Ratio .03 RatioPower 1 Leaves 10 AttractionUp 2 "
     "0SegSplits .05 0SplitAngle 3 0CurveRes 17 0Curve 10 0CurveBack -90 0CurveV 360 1DownAngle 60 "
     "1DownAngleV 30 1Rotate -90 1RotateV 30 1Branches 9 1Length .8 1LengthV .4 1Taper 1.03 1SegSplits .25 "
     "1SplitAngle 5 1SplitAngleV 10 1CurveRes 17 1Curve 30 1CurveBack -20 1CurveV 480 2DownAngle 40 "
     "2DownAngleV -60 2Rotate -90 2RotateV 30 2Branches 40 2Length .3 2LengthV .2 2SegSplits .2 "
     "2SplitAngle 10 2SplitAngleV 10 2CurveRes 12 2CurveV 480 3DownAngle 20 3DownAngleV 10 3Rotate 140",
     1428, 4100},
    {"California black oak",
     "Shape 2 Levels 3 Scale 10 ScaleV 10 BaseSize .05 Ratio .018 RatioPower 1.3 Leaves 25 AttractionUp .8 "
     "0BaseSplits 2 0Taper .95 0SegSplits .4 0SplitAngle 10 0CurveRes 8 0CurveV 90 1DownAngle 30 "
     "1DownAngleV -30 1Rotate 80 1Branches 40 1Length .8 1LengthV .1 1SegSplits .2 1SplitAngle 10 "
     "1SplitAngleV 10 1CurveRes 10 1Curve 40 1CurveBack -70 1CurveV 150 2DownAngle 45 2DownAngleV 10 "
     "2Rotate 140 2Branches 120 2Length .2 2LengthV .05 2Taper .05 2SegSplits .1 2SplitAngle 10 "
     "2SplitAngleV 10 2CurveRes 3 2Curve -40 2CurveV 30 3DownAngle 45 3DownAngleV 10 3Rotate 140",
     4610, 73000},
    {"weeping willow",
     "Shape 3 Levels 4 Scale 15 ScaleV 5 BaseSize .05 Ratio .03 RatioPower 2 Leaves 10 LeafDistrib 3 "
     "AttractionUp -2 PruneRatio 1 PrunePowerLow .001 PruneWidth .4 PruneWidthPeak .6 0BaseSplits 2 "
     "0Length .8 0SegSplits .1 0SplitAngle 3 0CurveRes 8 0CurveBack 20 0CurveV 120 1DownAngle 20 "
     "1DownAngleV 10 1Rotate -120 1RotateV 30 1Branches 25 1Length .5 1LengthV .1 1SegSplits .2 "
     "1SplitAngle 30 1SplitAngleV 10 1CurveRes 16 1Curve 40 1CurveBack 80 1CurveV 90 2DownAngle 30 "
     "2DownAngleV 10 2Rotate -120 2RotateV 30 2Branches 10 2Length 1.5 2SegSplits .2 2SplitAngle 45 "
     "2SplitAngleV 20 2CurveRes 12 3DownAngle 20 3DownAngleV 10 3Rotate 140 3Branches 150 3Length .1 "
     "3CurveRes 1",
     26700, 250000},
    {"barley",
     "Shape 3 Levels 2 Scale .6 ScaleV .1 BaseSize .85 Ratio .002 RatioPower .5 Flare 0 Leaves -1 "
     "LeafScale .01 LeafStemLen -11 LeafDistrib 3 LeafBend 0 0DownAngleV 40 0RotateV 80 0Branches 19 "
     "0BranchDist .1 0Taper .5 0CurveRes 49 0Curve 20 0CurveBack 80 0CurveV 40 1DownAngle 10 1DownAngleV -5 "
     "1Rotate -90 1RotateV 20 1Branches 35 1Length .2 1CurveRes 1 2DownAngle 10 2Rotate 0",
     684, 665},
    {"wheat",
     "Shape 3 Levels 2 Scale .6 ScaleV .1 BaseSize .85 Ratio .002 RatioPower 0 Flare 0 Leaves -1 "
     "LeafScale .01 LeafStemLen -1.2 LeafDistrib 3 LeafBend 0 0DownAngleV 40 0RotateV 80 0Branches 49 "
     "0BranchDist .1 0Taper .5 0CurveRes 13 0CurveBack 30 0CurveV 20 1DownAngle 25 1DownAngleV -5 "
     "1Rotate 120 1RotateV 10 1Branches 35 1Length .025 1Taper .5 1CurveRes 3 1CurveBack 20 2DownAngle 0 "
     "2Rotate 0",
     1764, 1715},
    // Without its ScaleV: the shortest trees are too small for stems, with Arbaro as with us.
    {"rush",
     "Shape 3 Levels 3 Scale .39 BaseSize .875 Ratio .005 RatioPower .5 Flare 0 Leaves -1 "
     "LeafScale .002 LeafStemLen -1.1 0DownAngle 10 0DownAngleV 30 0Rotate 130 0RotateV 60 0Branches 19 "
     "0BranchDist .05 0CurveRes 8 0Curve -5 0CurveBack 20 0CurveV 40 1DownAngle 20 1Rotate 0 1Branches 1 "
     "1BranchDist 0 1Length .002 1Taper 0 1CurveRes 1 2DownAngle 40 2DownAngleV 35 2Rotate 140 2RotateV 40 "
     "2Branches 50 2Length 20 2LengthV 10 2Taper .3 2SegSplits .4 2SplitAngle 6 2SplitAngleV 2 2CurveRes 5 "
     "2Curve 30 2CurveBack -10 2CurveV 10 3DownAngle 0 3Rotate 0",
     4786, 4748},
};

}  // namespace frond
