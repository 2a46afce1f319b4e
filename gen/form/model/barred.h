#pragma once

namespace frond {

/// The grey of a surface's paint where nothing may creep; anything below 0 says so.
inline constexpr float kBarred = -1;

}  // namespace frond
