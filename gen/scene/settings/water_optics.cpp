#include "settings/water_optics.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace frond {

namespace {

constexpr std::size_t kWavelengths = 13;  // from 400 to 700 nm, 25 nm apart
constexpr double kFirst = 400, kStep = 25;

/// Coefficients of a water at those wavelengths, 1/m.
struct WaterSpectrum {
  std::array<double, kWavelengths> scattering, attenuation, diffuse;
};

// IB to 5C: measured (Williamson and Hollins 2022). For I and IA nobody has measured them: the diffuse
// attenuation is that of Austin and Petzold (1984), the scattering that of 0.01 and 0.05 mg/m3 of chlorophyll
// (Gordon and Morel 1983; which type has how much: Morel 1988) and of sea water itself (Morel 1974), and
// absorption is 0.9 of the diffuse attenuation.
constexpr WaterSpectrum kSpectra[] = {
    // I
    {{0.031, 0.028, 0.026, 0.024, 0.022, 0.020, 0.019, 0.018, 0.017, 0.016, 0.016, 0.015, 0.014},
     {0.051, 0.045, 0.042, 0.040, 0.047, 0.066, 0.077, 0.102, 0.234, 0.302, 0.336, 0.408, 0.600},
     {0.022, 0.018, 0.018, 0.018, 0.028, 0.050, 0.064, 0.093, 0.241, 0.317, 0.356, 0.437, 0.651}},
    // IA
    {{0.072, 0.066, 0.062, 0.058, 0.054, 0.051, 0.049, 0.046, 0.044, 0.042, 0.041, 0.039, 0.037},
     {0.100, 0.092, 0.085, 0.080, 0.084, 0.100, 0.109, 0.133, 0.264, 0.331, 0.365, 0.436, 0.625},
     {0.032, 0.028, 0.026, 0.025, 0.033, 0.054, 0.067, 0.096, 0.244, 0.321, 0.360, 0.441, 0.653}},
    // IB
    {{0.144, 0.139, 0.135, 0.131, 0.128, 0.124, 0.122, 0.120, 0.118, 0.116, 0.114, 0.113, 0.111},
     {0.189, 0.182, 0.175, 0.168, 0.169, 0.176, 0.188, 0.212, 0.332, 0.408, 0.455, 0.542, 0.684},
     {0.051, 0.042, 0.036, 0.034, 0.042, 0.054, 0.073, 0.105, 0.235, 0.314, 0.375, 0.448, 0.580}},
    // II
    {{0.209, 0.202, 0.195, 0.190, 0.185, 0.180, 0.176, 0.173, 0.170, 0.167, 0.164, 0.162, 0.159},
     {0.283, 0.270, 0.258, 0.245, 0.239, 0.241, 0.248, 0.271, 0.387, 0.462, 0.508, 0.595, 0.734},
     {0.096, 0.082, 0.068, 0.064, 0.070, 0.077, 0.091, 0.121, 0.250, 0.334, 0.400, 0.477, 0.610}},
    // III
    {{0.324, 0.317, 0.309, 0.303, 0.297, 0.292, 0.287, 0.282, 0.278, 0.275, 0.271, 0.267, 0.264},
     {0.454, 0.442, 0.421, 0.397, 0.381, 0.374, 0.374, 0.391, 0.507, 0.581, 0.629, 0.721, 0.845},
     {0.185, 0.160, 0.136, 0.118, 0.115, 0.116, 0.124, 0.154, 0.286, 0.373, 0.446, 0.530, 0.660}},
    // 1C
    {{0.474, 0.465, 0.455, 0.447, 0.440, 0.433, 0.427, 0.421, 0.415, 0.410, 0.405, 0.401, 0.396},
     {0.660, 0.637, 0.604, 0.568, 0.545, 0.531, 0.526, 0.538, 0.651, 0.724, 0.772, 0.869, 0.981},
     {0.510, 0.366, 0.253, 0.176, 0.143, 0.130, 0.126, 0.155, 0.289, 0.371, 0.448, 0.522, 0.650}},
    // 3C
    {{0.713, 0.699, 0.686, 0.675, 0.664, 0.654, 0.645, 0.636, 0.627, 0.620, 0.612, 0.605, 0.599},
     {0.949, 0.929, 0.888, 0.841, 0.809, 0.785, 0.772, 0.775, 0.883, 0.955, 0.999, 1.101, 1.197},
     {0.780, 0.554, 0.394, 0.293, 0.227, 0.200, 0.195, 0.215, 0.323, 0.399, 0.464, 0.568, 0.710}},
    // 5C
    {{1.320, 1.295, 1.270, 1.245, 1.230, 1.211, 1.194, 1.175, 1.163, 1.148, 1.132, 1.120, 1.110},
     {1.789, 1.696, 1.587, 1.488, 1.430, 1.385, 1.352, 1.336, 1.437, 1.506, 1.545, 1.662, 1.724},
     {1.100, 0.795, 0.568, 0.437, 0.363, 0.311, 0.306, 0.332, 0.402, 0.477, 0.545, 0.656, 0.800}},
};
static_assert(std::size(kSpectra) == std::size(kWaterTypes));

// The light of all of a spectrum is a colour as the eye sees it, since pictures are: the CIE's colour
// matching functions of 1931 at those wavelengths.
constexpr std::array<double, kWavelengths> kX{0.01431, 0.2148, 0.3362, 0.1421, 0.0049, 0.1096, 0.43345,
                                              0.8425,  1.0622, 0.7514, 0.2835, 0.0636, 0.01136};
constexpr std::array<double, kWavelengths> kY{0.000396, 0.0073, 0.038, 0.1126, 0.323,  0.7932, 0.99495,
                                              0.9154,   0.631,  0.321, 0.107,  0.0232, 0.0041};
constexpr std::array<double, kWavelengths> kZ{0.06785, 1.0391, 1.77211, 1.0419, 0.272, 0.0573, 0.00875,
                                              0.0018,  0.0008, 0.0001,  0,      0,     0};
constexpr double kLinear[3][3] = {  // from XYZ to the primaries of sRGB (IEC 61966-2-1)
    {3.2406, -1.5372, -0.4986},
    {-0.9689, 1.8758, 0.0415},
    {0.0557, -0.2040, 1.0570}};

// What a colour loses with distance is that of the band which a camera's red, green and blue see.
constexpr double kBands[] = {600, 540, 460};  // nm, about (Jiang and others 2013)
constexpr double kBandwidth = 30;             // nm, standard deviation of each
constexpr double kRange = 3;                  // metres over which the coefficients hold on average

using Spectrum = std::array<double, kWavelengths>;

/// A spectrum as a linear colour, white where it is 1 everywhere. No screen shows a deeper blue than that
/// with a fiftieth of red.
Vec3 color_of(const Spectrum& spectrum) {
  constexpr float kLeast = 0.02f;
  Vec3 color(0);
  for (int c = 0; c < 3; ++c) {
    double sum = 0, all = 0;
    for (std::size_t i = 0; i < kWavelengths; ++i) {
      double part = kLinear[c][0] * kX[i] + kLinear[c][1] * kY[i] + kLinear[c][2] * kZ[i];
      sum += part * spectrum[i], all += part;
    }
    color[c] = static_cast<float>(sum / all);
  }
  return glm::max(color, Vec3(kLeast * std::max({color.r, color.g, color.b})));
}

/// What each band sees of a spectrum.
Vec3 seen_of(const Spectrum& spectrum) {
  Vec3 seen(0);
  for (int c = 0; c < 3; ++c) {
    double sum = 0, all = 0;
    for (std::size_t i = 0; i < kWavelengths; ++i) {
      double off = (kFirst + kStep * static_cast<double>(i) - kBands[c]) / kBandwidth;
      double sensitivity = std::exp(-off * off / 2);
      sum += sensitivity * spectrum[i], all += sensitivity;
    }
    seen[c] = static_cast<float>(sum / all);
  }
  return seen;
}

/// Attenuation of light of a spectrum by a water, as each band sees it on average over kRange.
Vec3 attenuation_of(const Spectrum& spectrum, const WaterSpectrum& water) {
  Spectrum after;
  for (std::size_t i = 0; i < kWavelengths; ++i)
    after[i] = spectrum[i] * std::exp(-water.attenuation[i] * kRange);
  return glm::log(seen_of(spectrum) / seen_of(after)) / static_cast<float>(kRange);
}

}  // namespace

WaterOptics water_optics(WaterType type, double depth) {
  const WaterSpectrum& water = kSpectra[static_cast<std::size_t>(type)];
  Spectrum daylight, veil;
  for (std::size_t i = 0; i < kWavelengths; ++i) {
    daylight[i] = std::exp(-water.diffuse[i] * depth);
    veil[i] = daylight[i] * water.scattering[i] / water.attenuation[i];
  }
  constexpr std::size_t kGreen = 6;  // 550 nm
  return {.direct = attenuation_of(daylight, water),
          .backscatter = attenuation_of(veil, water),
          .veil = color_of(veil),
          .passed = color_of(daylight),
          .metered = seen_of(daylight),
          .scattering = water.scattering[kGreen]};
}

}  // namespace frond
