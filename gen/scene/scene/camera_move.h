#pragma once

#include "settings/scene_setup.h"

namespace frond {

/// The camera with its move (Camera::move) written as keyframes, as if somebody had set them, through a film
/// of that length: first along the rail, then round the orbit, then as a hand shakes it. Where a round is a
/// whole one at an even pace, and where the shaking repeats, the last frame is followed by the first without
/// a jump. Without a move, or in a still, it is as it was.
Camera keyed_move(const Camera& camera, const Film& film);

/// How far a hand turns a camera at a time in seconds: sideways and up, each at most `amplitude` radians. The
/// sum of three swings whose rates are no simple ratio; in a loop each fits a whole number of times into
/// `film_length` seconds.
Vec2 shaken(const Shake& shake, double time, double film_length);

}  // namespace frond
