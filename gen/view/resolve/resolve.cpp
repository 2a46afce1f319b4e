#include "resolve/resolve.h"

#include <algorithm>
#include <cassert>

#include "core/parallel.h"
#include "draw/eyes.h"
#include "resolve/air.h"
#include "resolve/gather.h"

namespace frond {

/// A raw frame, and which spot each of its samples shows.
struct Resolver::Raw {
  LightPicture light;
  std::vector<SurfaceSpot> spot;
  std::vector<char> lit;
};

namespace {

/// The spot of a ray that meets nothing: its direction stands in `own`.
SurfaceSpot backdrop(Vec3 direction) {
  SurfaceSpot spot;
  spot.own = direction;
  return spot;
}

/// Adds a sample of a raw frame where it lies in this one.
void add_moved(std::vector<RawSample>& samples, const TracedFrame& now, const SurfaceSpot& spot, bool lit,
               Vec3 light, int age, Vec2 size) {
  RawSample sample;
  sample.surface = surface_of(spot.thing);
  sample.lit = lit;
  sample.age = age;
  sample.light = light;
  if (spot.thing.kind == ThingKind::nothing) {
    sample.at = now.eye.at + kBackdropAway * spot.own;
    sample.normal = -spot.own;
  } else if (std::optional<PlaceNormal> here = now.where(spot)) {
    sample.at = here->at;
    sample.normal = here->normal;
    if (glm::dot(sample.normal, sample.at - now.eye.at) > 0) sample.normal = -sample.normal;
    if (lit) sample.facing = spot.facing;
  } else {
    return;
  }
  std::optional<Vec2> place = picture_place(now.eye, sample.at);
  if (!place) return;
  sample.place = *place * size;
  sample.away = glm::distance(sample.at, now.eye.at);
  if (glm::all(glm::greaterThanEqual(sample.place, Vec2(0))) && glm::all(glm::lessThan(sample.place, size)))
    samples.push_back(sample);
}

/// The rays through a lens are few, so what is far out of focus is grainy. There no detail is finer than the
/// circle by which a point is blurred: each pixel takes from those around it that are as much out of focus.
LightPicture smoothed(const LightPicture& picture, const std::vector<float>& blur, int width) {
  constexpr float kOfBlur = 0.125f, kMost = 2.5f;  // standard deviation, of the blur and in pixels
  constexpr float kLeast = 0.25f;                  // below which nothing changes
  constexpr float kAsMuch = 0.5f;                  // of the blur, what those around have at least
  auto height = static_cast<int>(picture.size()) / width;
  LightPicture made(picture.size());
  parallel_for(static_cast<std::size_t>(height), [&](std::size_t row) {
    for (int x = 0, y = static_cast<int>(row); x < width; ++x) {
      std::size_t own = row * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
      float sigma = std::min(kOfBlur * blur[own], kMost);
      made[own] = picture[own];
      if (sigma < kLeast) continue;
      int reach = static_cast<int>(std::ceil(2 * sigma));
      Vec3 sum(0);
      float weight = 0;
      for (int j = std::max(0, y - reach); j <= std::min(height - 1, y + reach); ++j)
        for (int i = std::max(0, x - reach); i <= std::min(width - 1, x + reach); ++i) {
          auto k = static_cast<std::size_t>(j * width + i);
          if (blur[k] < kAsMuch * blur[own]) continue;
          auto away = static_cast<float>((i - x) * (i - x) + (j - y) * (j - y));
          float w = std::exp(-away / (2 * sigma * sigma));
          sum += w * picture[k], weight += w;
        }
      made[own] = sum / weight;
    }
  });
  return made;
}

/// The pixels of a band of rows.
LightPicture gathered(const SampleGrid& grid, const TracedFrame& now, const ResolveOptions& options,
                      RowBand band) {
  auto wide = static_cast<std::size_t>(grid.width()), high = static_cast<std::size_t>(band.count());
  LightPicture picture(wide * high);
  std::vector<float> blur(picture.size());
  parallel_for(high, [&](std::size_t row) {
    Gatherer gatherer(grid, now, options);
    for (std::size_t x = 0; x < wide; ++x) {
      std::size_t i = row * wide + x;
      picture[i] = gatherer.pixel(static_cast<int>(x), band.first + static_cast<int>(row));
      blur[i] = gatherer.blur();
    }
  });
  return now.lens > 0 ? smoothed(picture, blur, grid.width()) : picture;
}

}  // namespace

Resolver::Resolver(const Scene& scene, const TracedFilm& film, Source source, const ResolveOptions& options)
    : scene_(scene), film_(film), source_(std::move(source)), options_(options) {}
Resolver::~Resolver() = default;

Result<const TracedFrame*> Resolver::traced(int number) {
  auto kept = traced_.find(number);
  if (kept == traced_.end()) {
    Result<TracedFrame> made = film_.at(scene_.film.time(number));
    if (!made) return made.errors();
    kept = traced_.emplace(number, std::move(*made)).first;
  }
  return &kept->second;
}

Result<const Resolver::Raw*> Resolver::raw(int number) {
  std::unique_ptr<Raw>& kept = raws_[number];
  if (kept) return kept.get();
  Result<LightPicture> light = source_(number);
  if (!light) return light.errors();
  Result<const TracedFrame*> found = traced(number);
  if (!found) return found.errors();
  kept = found_spots(number, **found, std::move(*light), 0);
  return kept.get();
}

std::unique_ptr<Resolver::Raw> Resolver::found_spots(int number, const TracedFrame& now, LightPicture light,
                                                     int first) const {
  auto [width, height] = scene_.film.drawn_size();
  Vec2 shift = sample_shift(scene_.film, number), size(width, height);
  auto made = std::make_unique<Raw>();
  made->light = std::move(light);
  made->spot.resize(made->light.size());
  made->lit.resize(made->light.size());
  parallel_for(made->light.size() / static_cast<std::size_t>(width), [&](std::size_t row) {
    int y = first + static_cast<int>(row);
    for (int x = 0; x < width; ++x) {
      std::size_t i = row * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
      Vec3 direction = picture_ray(now.eye, (Vec2(x, y) + 0.5f + shift) / size);
      std::optional<PassHit> hit = now.trace(now.eye.at, direction);
      made->spot[i] = hit ? hit->spot : backdrop(direction);
      made->lit[i] = hit && now.lit(*hit);
    }
  });
  return made;
}

Result<LightPicture> Resolver::frame(int number) {
  int first = std::max(number - options_.window, 1),
      last = std::min(number + options_.window, scene_.film.frames);
  std::erase_if(raws_, [&](const auto& one) { return one.first < first || one.first > last; });
  std::erase_if(traced_, [&](const auto& one) { return one.first < number || one.first > last; });
  Film sharp = scene_.film;  // as if each exposure were a scene of its own
  sharp.raw = false;
  const Camera& camera = scene_.setup.camera;
  int moments = exposures(sharp, camera);
  if (moments == 1) {
    Result<const TracedFrame*> now = traced(number);
    return now ? at_moment(number, **now, options_) : now.errors();
  }
  ResolveOptions options = options_;
  options.side = std::max(2, options.side / 2);
  LightPicture sum;
  for (int moment = 1; moment <= moments; ++moment) {
    Result<TracedFrame> now = film_.at(exposure_time(sharp, camera, number, moment));
    if (!now) return now.errors();
    Result<LightPicture> one = at_moment(number, *now, options);
    if (!one) return one;
    sum.resize(one->size(), Vec3(0));
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += (*one)[i] / static_cast<float>(moments);
  }
  return sum;
}

/// The picture of what is there at a moment, of the raw frames about one.
Result<LightPicture> Resolver::at_moment(int number, const TracedFrame& now, const ResolveOptions& options) {
  auto [width, height] = scene_.film.size;
  int first = std::max(number - options.window, 1),
      last = std::min(number + options.window, scene_.film.frames);
  std::vector<std::vector<RawSample>> rows;  // of each frame and row of it
  for (int other = first; other <= last; ++other) {
    Result<const Raw*> raw = this->raw(other);
    if (!raw) return raw.errors();
    add_rows(rows, **raw, now, other - number);
  }
  SampleGrid grid(width, height, {0, height}, rows);
  LightPicture picture = gathered(grid, now, options, {0, height});
  if (scene_.film.air)
    AirLight(scene_.setup, scene_.film.time(number), now, scene_.film.size).add(picture, 0);
  return picture;
}

/// Appends the samples of a raw frame, row by row, where they lie in this one.
void Resolver::add_rows(std::vector<std::vector<RawSample>>& rows, const Raw& raw, const TracedFrame& now,
                        int age) const {
  auto wide = static_cast<std::size_t>(scene_.film.drawn_size()[0]);
  Vec2 size(scene_.film.size[0], scene_.film.size[1]);
  std::size_t begin = rows.size(), high = raw.light.size() / wide;
  rows.resize(begin + high);
  parallel_for(high, [&](std::size_t y) {
    for (std::size_t i = y * wide; i < (y + 1) * wide; ++i)
      add_moved(rows[begin + y], now, raw.spot[i], raw.lit[i] != 0, raw.light[i], age, size);
  });
}

Errors Resolver::still_in_bands(const RowSource& raw, int band, const RowReceiver& receive) {
  constexpr int kAround = 8;  // rows beside a band in which samples lie that it takes
  assert(scene_.film.frames == 1 && !scene_.setup.camera.aperture);
  Result<const TracedFrame*> found = traced(1);
  if (!found) return found.errors();
  const TracedFrame& now = **found;
  auto [width, height] = scene_.film.size;
  int fine = scene_.film.drawn_size()[1] / height;
  std::optional<AirLight> air;
  if (scene_.film.air) air.emplace(scene_.setup, scene_.film.time(1), now, scene_.film.size);
  for (int first = 0; first < height; first += band) {
    RowBand own{first, std::min(first + band, height)},
        around{std::max(0, own.first - kAround), std::min(own.end + kAround, height)};
    Result<LightPicture> light = raw(fine * around.first, fine * around.count());
    if (!light) return light.errors();
    std::vector<std::vector<RawSample>> rows;
    add_rows(rows, *found_spots(1, now, std::move(*light), fine * around.first), now, 0);
    SampleGrid grid(width, height, around, rows);
    LightPicture picture = gathered(grid, now, options_, own);
    if (air) air->add(picture, own.first);
    if (Errors errors = receive(picture); !errors.empty()) return errors;
  }
  return {};
}

}  // namespace frond
