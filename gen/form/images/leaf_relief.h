#pragma once

#include "images/leaf.h"

namespace frond {

/// How high each place of leaf_picture() is raised, -1..1: veins are sunk in, and between the larger ones the
/// blade bulges. Nothing of a photograph is.
Grid leaf_heights(const LeafImage& leaf, int height, Seed seed);

}  // namespace frond
