#pragma once

#include "core/curve.h"
#include "core/vec.h"

namespace frond {

/// A change of colours, all of them alike: they are turned round the axis of greys, drawn out from the grey
/// of the same luminance, and made lighter or darker.
struct ColorShift {
  double hue = 0;         ///< radians
  double saturation = 1;  ///< factor
  double value = 1;       ///< factor

  bool plain() const { return hue == 0 && saturation == 1 && value == 1; }
};

/// A linear colour, or one of sRGB within its bounds, so changed.
Vec3 shifted(Vec3 light, const ColorShift& by);
Color shifted(const Color& color, const ColorShift& by);

/// By how much more light a colour of sRGB gives back when it is so changed, channel by channel: a filter
/// that changes a picture whose mean it is.
Vec3 shift_filter(const Color& color, const ColorShift& by);

/// Such a change over the film.
struct ColorCourse {
  Animated<double> hue{0.0};         ///< degrees
  Animated<double> saturation{1.0};  ///< factor
  Animated<double> value{1.0};       ///< factor

  bool constant() const { return hue.constant() && saturation.constant() && value.constant(); }
  /// Whether it never changes a colour.
  bool plain() const { return constant() && at(0).plain(); }
  ColorShift at(double time) const;
};

}  // namespace frond
