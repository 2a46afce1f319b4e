#include "cpfg/curves.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/plain_text.h"
#include "core/read_as.h"

namespace frond::cpfg {

namespace {

constexpr int kMostPoints = 100'000, kMostSamples = 100'000;

/// A B-spline with equal knots, repeated at its ends, at the parameter 0..1 (de Boor's algorithm).
DVec3 clamped_spline(const std::vector<Vec3>& points, double parameter) {
  int count = static_cast<int>(points.size()), degree = std::min(3, count - 1), spans = count - degree;
  auto knot = [&](int i) { return static_cast<double>(std::clamp(i - degree, 0, spans)); };
  double u = parameter * spans;
  int span = std::clamp(static_cast<int>(u), 0, spans - 1) + degree;
  std::array<DVec3, 4> spots;
  for (int j = 0; j <= degree; ++j) spots[j] = DVec3(points[span - degree + j]);
  for (int r = 1; r <= degree; ++r)
    for (int j = degree; j >= r; --j) {
      double low = knot(span - degree + j), high = knot(span + 1 + j - r);
      auto at = static_cast<std::size_t>(j);
      spots[at] = spots[at - 1] + (spots[at] - spots[at - 1]) * (high > low ? (u - low) / (high - low) : 0);
    }
  return spots[degree];
}

/// A uniform cubic B-spline that is not clamped: open, or periodic.
DVec3 uniform_spline(const CurveTable& curve, double parameter) {
  int count = static_cast<int>(curve.points.size()), spans = curve.closed ? count : std::max(count - 3, 1);
  double u = std::clamp(parameter, 0.0, 1.0) * spans;
  int span = std::clamp(static_cast<int>(u), 0, spans - 1);
  double t = u - span, s = 1 - t;
  double weights[] = {s * s * s / 6, (3 * t * t * t - 6 * t * t + 4) / 6,
                      (-3 * t * t * t + 3 * t * t + 3 * t + 1) / 6, t * t * t / 6};
  DVec3 sum(0);
  for (int k = 0; k < 4; ++k) {
    int index = curve.closed ? (span + k) % count : std::min(span + k, count - 1);
    sum += weights[k] * DVec3(curve.points[index]);
  }
  return sum;
}

/// y where the spline's x comes to within 0.001 of a value, found by halving its parameter as cpfg does.
double solve(const FunctionTable& function, double x) {
  double low = 0, high = 1, y = 0;
  for (int i = 0; i < 60; ++i) {
    double middle = (low + high) / 2;
    DVec3 found = clamped_spline(function.points, middle);
    y = found.y;
    if (std::abs(found.x - x) <= 0.001) break;
    (found.x > x ? high : low) = middle;
  }
  return y;
}

/// Reads a file of lines with a label to the colon and lines of numbers.
class LabelReader {
 public:
  explicit LabelReader(std::string_view text) : rest_(text) {}

  bool is_empty() const { return trim(rest_).empty(); }

  std::string_view peek() {
    while (!rest_.empty()) {
      std::string_view line = trim(rest_.substr(0, rest_.find('\n')));
      if (!line.empty()) return line;
      skip();
    }
    return {};
  }
  void skip() { rest_.remove_prefix(std::min(rest_.find('\n'), rest_.size() - 1) + 1); }
  std::string_view next_line() {
    std::string_view line = peek();
    if (!rest_.empty()) skip();
    return line;
  }

 private:
  std::string_view rest_;
};

std::vector<float> numbers_of(std::string_view line) {
  std::vector<float> numbers;
  for (;;) {
    line.remove_prefix(std::min(line.find_first_not_of(" \t,"), line.size()));
    std::optional<float> value = consume_as<float>(line);
    if (!value || !std::isfinite(*value)) return numbers;
    numbers.push_back(*value);
  }
}

std::string_view after_colon(std::string_view line) {
  return trim(line.substr(std::min(line.find(':') + 1, line.size())));
}

int whole_after_colon(std::string_view line, int most) {
  std::vector<float> numbers = numbers_of(after_colon(line));
  return numbers.empty() ? 0 : static_cast<int>(std::clamp(numbers[0], 0.0F, static_cast<float>(most)));
}

/// So many lines `x y [z] [multiplicity]` of points in so many dimensions.
Result<std::vector<Vec3>> read_points(LabelReader& file, int lines, std::size_t dimensions) {
  std::vector<Vec3> points;
  for (int i = 0; i < lines; ++i) {
    std::string_view line = file.next_line();
    std::vector<float> numbers = numbers_of(line);
    if (numbers.size() < dimensions)
      return error_at("", "`{}`: expected point {} of {}, {} numbers", line, i + 1, lines, dimensions);
    float times = numbers.size() > dimensions ? std::clamp(numbers[dimensions], 1.0F, 1000.0F) : 1;
    Vec3 point(numbers[0], numbers[1], dimensions > 2 ? numbers[2] : 0);
    points.insert(points.end(), static_cast<std::size_t>(times), point);
    if (points.size() > kMostPoints) return Error{"", "more than 100,000 points"};
  }
  if (points.empty()) return Error{"", "no points; expected `points: n` and n lines of numbers"};
  return points;
}

/// Reads one function to the end of its points.
Result<NamedFunction> read_one(LabelReader& file, int samples) {
  NamedFunction read;
  while (!file.is_empty()) {
    std::string_view line = file.next_line();
    if (line.starts_with("name:")) read.name = std::string(after_colon(line));
    if (line.starts_with("samples:")) samples = whole_after_colon(line, kMostSamples);
    if (line.starts_with("markers:"))
      for (int i = whole_after_colon(line, kMostPoints); i > 0; --i) file.next_line();
    if (!line.starts_with("points:")) continue;
    Result<std::vector<Vec3>> points = read_points(file, whole_after_colon(line, kMostPoints), 2);
    if (!points) return points.errors();
    read.function.points = std::move(*points);
    if (samples > 2) {
      std::vector<double> values;
      for (int i = 0; i < samples; ++i) values.push_back(solve(read.function, i / (samples - 1.0)));
      read.function.samples = std::move(values);
    }
    return read;
  }
  return Error{"", "no `points:`; expected a function of the program funcedit"};
}

}  // namespace

double FunctionTable::operator()(double x) const {
  x = std::isnan(x) ? 0 : std::clamp(x, 0.0, 1.0);
  if (samples.empty()) return solve(*this, x);
  double at = x * static_cast<double>(samples.size() - 1);
  std::size_t index = std::min(static_cast<std::size_t>(at), samples.size() - 2);
  double share = at - static_cast<double>(index);
  return samples[index] + (samples[index + 1] - samples[index]) * share;
}

DVec3 CurveTable::operator()(double share) const {
  double wanted = (std::isnan(share) ? 0 : std::clamp(share, 0.0, 1.0)) * length.back();
  auto next = std::min(std::upper_bound(length.begin(), length.end(), wanted), length.end() - 1);
  auto index = std::max<std::ptrdiff_t>(next - length.begin(), 1);
  double low = length[index - 1], high = length[index];
  double within = high > low ? (wanted - low) / (high - low) : 0;
  return uniform_spline(*this,
                        (static_cast<double>(index - 1) + within) / static_cast<double>(length.size() - 1));
}

Result<FunctionTable> read_function(std::string_view text, int samples) {
  LabelReader file(text);
  Result<NamedFunction> read = read_one(file, samples);
  if (!read) return read.errors();
  return std::move(read->function);
}

Result<std::vector<NamedFunction>> read_function_set(std::string_view text) {
  LabelReader file(text);
  int items = -1;
  while (!file.is_empty() && items < 0)
    if (std::string_view line = file.next_line(); line.starts_with("items:"))
      items = whole_after_colon(line, 10'000);
  if (items < 0) return Error{"", "no `items:`; expected a set of functions"};
  std::vector<NamedFunction> functions;
  for (int i = 0; i < items; ++i) {
    Result<NamedFunction> read = read_one(file, 0);
    if (!read) return read.errors();
    functions.push_back(std::move(*read));
  }
  return functions;
}

Result<ContourFile> read_contour(std::string_view text, bool of_cylinder) {
  LabelReader file(text);
  ContourFile contour;
  bool is_new = file.peek().starts_with("cver"), first = of_cylinder && file.peek().starts_with("cver 1 1");
  // The oldest form: how many points, of how many numbers, `closed` or `open`.
  if (std::vector<float> numbers = numbers_of(file.peek()); of_cylinder && numbers.size() >= 2) {
    contour.closed = file.next_line().find("closed") != std::string_view::npos;
    int count = static_cast<int>(std::clamp(numbers[0], 0.0F, static_cast<float>(kMostPoints)));
    Result<std::vector<Vec3>> points = read_points(file, count, numbers[1] > 2 ? 3 : 2);
    if (!points) return points.errors();
    contour.points = std::move(*points);
    return contour;
  }
  bool ends = false;
  int lines = 0;
  while (!file.is_empty()) {
    std::string_view line = file.peek();
    if (!numbers_of(line).empty() && lines > 0) break;
    file.next_line();
    std::string_view value = after_colon(line);
    if (line.starts_with("name:")) contour.name = std::string(value);
    if (line.starts_with("points:")) lines = whole_after_colon(line, kMostPoints);
    if (!line.starts_with("type:")) continue;
    if (first)
      contour.closed = !value.starts_with("open");
    else
      contour.closed = is_new ? value.starts_with('c') : value == "bspline-closed";
    ends = !is_new && value == "bspline-endpoint";
  }
  Result<std::vector<Vec3>> points = read_points(file, lines, 3);
  if (!points) return points.errors();
  contour.points = std::move(*points);
  // A curve that comes to its ends has them three times.
  if (ends) contour.points.insert(contour.points.begin(), 2, contour.points.front());
  if (ends) contour.points.insert(contour.points.end(), 2, contour.points.back());
  return contour;
}

CurveTable measure(const ContourFile& contour, int samples) {
  CurveTable curve{contour.points, contour.closed, {0}};
  samples = std::clamp(samples, 2, kMostSamples);
  DVec3 before = uniform_spline(curve, 0);
  for (int i = 1; i < samples; ++i) {
    DVec3 now = uniform_spline(curve, i / (samples - 1.0));
    curve.length.push_back(curve.length.back() +
                           std::hypot(now.x - before.x, now.y - before.y, now.z - before.z));
    before = now;
  }
  return curve;
}

}  // namespace frond::cpfg
