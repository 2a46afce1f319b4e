#include "motion/wind.h"

#include <cmath>

#include "core/loop.h"
#include "model/drag.h"

namespace frond {

namespace {

constexpr int kMostGusts = 16;
constexpr double kSlowest = 0.03, kFastest = 4;  // gusts a second
constexpr double kScale = 40;                    // metres, of the gusts that hold most of the energy
constexpr double kSlant = 0.6;   // of the wave number along the wind: the one across it, at most
constexpr double kLightAir = 1;  // metres a second: what carries gusts where there is no wind

/// n S(n) of a wind of deviation 1.
double karman(double frequency, double speed) {
  double x = frequency * kScale / speed;
  return 4 * x / std::pow(1 + 70.8 * x * x, 5.0 / 6);
}

}  // namespace

double WindField::mean(double time) const {
  double most = speed;
  for (const Gale& gale : gales) {
    double past = (time - gale.time) / gale.lasts;
    most = std::max(most, speed + (gale.speed - speed) * std::exp(-past * past));
  }
  return most;
}

double WindField::gust(Vec3 place, double time) const {
  double sum = 0;
  for (const Gust& g : gusts)
    sum += g.share *
           std::cos(g.rate * time - glm::dot(glm::dvec2(g.wave), glm::dvec2(place.x, place.z)) + g.phase);
  return sum;
}

double WindField::carried(Vec3 place, double time) const {
  double sum = 0;
  for (const Gust& g : gusts)
    sum += g.share / g.rate *
           std::sin(g.rate * time - glm::dot(glm::dvec2(g.wave), glm::dvec2(place.x, place.z)) + g.phase);
  return sum;
}

WindField wind_field(const Wind& wind, double film_length, Seed seed, std::vector<Gale> gales) {
  WindField field;
  Vec3 flat(wind.direction.x, 0, wind.direction.z);
  if (glm::dot(flat, flat) > 0) field.along = glm::normalize(flat);
  field.speed = wind.speed;
  field.film_length = wind.loop ? film_length : 0;
  double carried = std::max(wind.speed, kLightAir);
  for (const Gale& gale : gales) carried = std::max(carried, gale.speed / 2);
  field.gales = std::move(gales);
  double slowest = field.film_length > 0 ? std::max(kSlowest, 1 / field.film_length) : kSlowest;
  double step = std::pow(kFastest / slowest, 1.0 / (kMostGusts - 1)), sum = 0;
  for (int k = 0; k < kMostGusts; ++k) {
    double frequency = looping_rate(slowest * std::pow(step, k), field.film_length);
    Seed own = seed.child(k);
    double variance = karman(frequency, carried);  // of a band as wide as the step, which all share
    sum += variance;
    double number = 2 * kPi * frequency / carried, across = number * own.child(0).range(-kSlant, kSlant);
    Vec2 wave(field.along.x * number - field.along.z * across,
              field.along.z * number + field.along.x * across);
    field.gusts.push_back({2 * kPi * frequency, wave, own.child(1).range(0, 2 * kPi), variance});
  }
  for (Gust& g : field.gusts) g.share = wind.gusts * std::sqrt(2 * g.share / sum);
  return field;
}

double drag_pressure(double speed) {
  double folding = 1 + speed * speed / (kCalm * kCalm);
  return 0.5 * kAir * speed * speed * std::pow(folding, -0.5 * kGiving);
}

double drag_power(double speed) {
  double faster = speed * speed / (kCalm * kCalm);
  return 2 - kGiving * faster / (1 + faster);
}

}  // namespace frond
