#include "engine/io/share_grid.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <variant>

#include "engine/document/checks.h"
#include "engine/geometry/polyline.h"
#include "engine/io/document_json.h"
#include "engine/io/foretold.h"
#include "engine/io/share_ends.h"
#include "engine/io/share_text.h"

namespace spineloft::io {
namespace {

using document::Document;

/// Numbers of no other meaning keep this many decimal digits: unit vectors stay of length 1 to within 1e-6.
constexpr int kDigits = 7;
/// Pressures of a pen are multiples of 1 / this.
constexpr float kPressures = 32;
/// Rounds places on one picture.
class Grid {
 public:
  explicit Grid(image::Size size) : size_(size), step_(shareStep(size)) {}
  image::Size size() const { return size_; }
  double operator()(double value) const { return std::round(value / step_) * step_; }
  PicturePoint operator()(PicturePoint p) const { return {(*this)(p.x), (*this)(p.y)}; }
  ModelPoint operator()(ModelPoint p) const { return {(*this)(p.x), (*this)(p.y), (*this)(p.z)}; }
  std::vector<PicturePoint> rounded(std::vector<PicturePoint> line) const {
    for (PicturePoint& p : line) p = (*this)(p);
    return line;
  }
  /// Rounded, and simplified where that is shorter in a text: what has been through it stays as it is.
  std::vector<PicturePoint> operator()(const std::vector<PicturePoint>& line) const {
    const std::vector<PicturePoint> all = rounded(line);
    const std::vector<PicturePoint> few = geometry::simplifiedLine(std::span(all), tolerance());
    return bits(all) < bits(few) ? all : few;
  }
  double tolerance() const { return step_ / 2; }

 private:
  std::size_t bits(const std::vector<PicturePoint>& line) const { return lineCost(line, size_); }

  image::Size size_;
  double step_;
};

image::SketchStroke kept(const image::SketchStroke& stroke, const Grid& grid) {
  image::SketchStroke out = stroke;
  const std::vector<PicturePoint> points = grid.rounded(stroke.points);
  out.points.clear();
  out.pressure.clear();
  for (const std::size_t i : geometry::keptPoints(std::span(points), grid.tolerance())) {
    out.points.push_back(points[i]);
    if (i < stroke.pressure.size()) out.pressure.push_back(std::round(stroke.pressure[i] * kPressures) / kPressures);
  }
  return out;
}

void keepMarks(std::vector<ribs::IgnoreMark>& marks, const Grid& grid) {
  for (ribs::IgnoreMark& mark : marks) mark.stroke = grid(mark.stroke);
}

void keepRegion(document::Region& region, const Grid& grid) {
  for (std::vector<PicturePoint>& contour : region.contours) contour = grid(contour);
}

void keep(document::LoftRecipe& recipe, const Grid& grid) {
  recipe.stroke = grid(recipe.stroke);
  keepMarks(recipe.ignored, grid);
}
void keep(document::InflateRecipe& recipe, const Grid& grid) {
  keepRegion(recipe.region, grid);
  for (inflate::ProfileSlice& slice : recipe.inflate.profile.slices) {
    if (slice.at) slice.at = grid(*slice.at);
  }
}
void keep(document::ExtrudeRecipe& recipe, const Grid& grid) { keepRegion(recipe.region, grid); }
void keep(document::StackRecipe& recipe, const Grid& grid) {
  const auto rounded = [&](ModelPoint& p) { p = {grid(p.x), grid(p.y), grid(p.z)}; };
  for (stack::Plane& plane : recipe.planes) {
    if (plane.origin) rounded(*plane.origin);
    for (stack::Curve& curve : plane.curves) {
      for (SectionPoint& p : curve.through) p = {grid(p.x), grid(p.y)};
      curve.base = grid(curve.base);
    }
  }
  for (ModelPoint& p : recipe.rail.points) rounded(p);
}
/// Outlines are on grids of their own pictures.
void keep(document::ShapeRecipe& recipe, const Grid& grid) {
  document::ShapeRecipe kept = recipe;
  kept.shape.axis = {grid(recipe.shape.axis.from), grid(recipe.shape.axis.to)};
  kept.shape.width = grid(recipe.shape.width);
  if (isValid(kept.shape)) recipe = std::move(kept);
}
/// Its lines are in its drawing.
void keep(document::ElementRecipe&, const Grid&) {}
void keep(document::BridgeRecipe& recipe, const Grid& grid) {
  for (document::BridgeEnd* end : {&recipe.from, &recipe.to}) {
    for (ModelPoint& p : end->rim) p = grid(p);
  }
}
void keepPull(pull::Pull& pull, const Grid& grid) {
  pull::eachPlace(pull, [&](ModelPoint& p) { p = grid(p); });
  pull.height = grid(pull.height);
  pull.radius = std::max(grid(pull.radius), pull::kLeastRadius);
}
void keepRelief(relief::Relief& relief, const Grid& grid) {
  relief::eachPlace(relief, [&](PicturePoint& p) { p = grid(p); });
  if (relief.laid) relief.laid->width = std::max(grid(relief.laid->width), relief::kLeastWidth);
}
void keepLines(document::Drawing& drawing, const Grid& grid) {
  for (document::DrawnLine& line : drawing.lines) {
    document::DrawnLine kept = line;
    kept.points = grid(line.points);
    if (document::isValid(kept, grid.size())) line = std::move(kept);
  }
}
void keep(document::LatheRecipe& recipe, const Grid& grid) {
  keepRegion(recipe.region, grid);
  recipe.lathe.axisFrom = grid(recipe.lathe.axisFrom);
  recipe.lathe.axisTo = grid(recipe.lathe.axisTo);
}

double withDigits(double value) {
  if (value == 0 || !std::isfinite(value)) return value;
  const int digits = kDigits - 1 - static_cast<int>(std::floor(std::log10(std::abs(value))));
  const double scale = std::pow(10.0, std::min(digits, 9));
  const double out = std::round(value * scale) / scale;
  return std::isfinite(out) ? out : value;
}

/// About so many quarters of a bit numbers of the grid take, from the third one on.
std::size_t listCost(std::span<const double> numbers, double step) {
  std::vector<std::int64_t> whole;
  for (const double number : numbers) whole.push_back(std::llround(std::clamp(number / step, -1e15, 1e15)));
  std::uint64_t all = 0;
  for (const std::int64_t number : whole) all |= static_cast<std::uint64_t>(number);
  const int zeros = all == 0 ? 0 : std::countr_zero(all);
  for (std::int64_t& number : whole) number /= std::int64_t{1} << zeros;
  std::size_t least = std::numeric_limits<std::size_t>::max();
  for (const Mode& mode : kModes) {
    if (mode.even && whole.size() % 2 != 0) continue;
    std::size_t sum = mode.even ? 4 * 6 : 0;
    const std::vector<std::int64_t> off = offs(mode, whole);
    for (std::size_t i = 2; i < off.size(); ++i) sum += offCost(off[i]);
    least = std::min(least, sum);
  }
  return least;
}

}  // namespace

double shareStep(image::Size picture) {
  const int side = std::max({picture.width, picture.height, 1024});
  return std::exp2(std::floor(std::log2(side / 1024.0))) / 4;
}

std::size_t lineCost(const std::vector<PicturePoint>& line, image::Size picture) {
  std::vector<double> numbers;
  for (const PicturePoint p : line) numbers.insert(numbers.end(), {p.x, p.y});
  return listCost(numbers, shareStep(picture));
}

std::vector<PicturePoint> keptLine(const std::vector<PicturePoint>& line, image::Size picture) {
  return Grid(picture)(line);
}

Document onGrids(const Document& document) {
  Document rounded = document;
  TracedRibs traced;
  std::map<std::uint32_t, Grid> grids;
  for (Box<document::PictureEntry>& box : rounded.pictures) {
    document::PictureEntry entry = box.get();
    const Grid& grid = grids.try_emplace(entry.id.value, entry.size).first->second;
    for (Box<image::SketchStroke>& stroke : entry.sketch) stroke = kept(stroke.get(), grid);
    keepMarks(entry.ignored, grid);
    box = std::move(entry);
  }
  for (Box<document::Drawing>& box : rounded.drawings) {
    const auto grid = grids.find(box->picture.value);
    if (grid == grids.end()) continue;
    document::Drawing drawing = box.get();
    keepLines(drawing, grid->second);
    box = std::move(drawing);
  }
  for (Box<document::Part>& box : rounded.parts) {
    document::Part part = box.get();
    const auto grid = grids.find(document::pictureOf(part).value);
    if (grid == grids.end()) continue;
    std::visit([&](auto& recipe) { keep(recipe, grid->second); }, part.recipe);
    if (document::LoftRecipe* loft = document::loftOf(part)) tellEnds(*loft, grid->second.size(), traced);
    for (document::Outline* outline : document::outlinesOf(part.recipe)) {
      const auto own = grids.find(outline->picture.value);
      if (own == grids.end()) continue;
      for (auto& line : outline->lines) line = own->second(line);
    }
    for (pull::Pull& pull : part.pulls) keepPull(pull, grid->second);
    if (part.relief) keepRelief(*part.relief, grid->second);
    box = std::move(part);
  }
  return rounded;
}

void roundNumbers(Json& json) {
  if (json.is_number_float()) {
    const double value = json.get<double>();
    json = toJson(std::trunc(value * 4096) == value * 4096 ? value : withDigits(value));
  }
  if (json.is_structured()) {
    for (Json& element : json) roundNumbers(element);
  }
}

Json* listOf(Json& json, const char* key) {
  if (!json.is_object()) return nullptr;
  const auto at = json.find(key);
  return at != json.end() && at->is_array() ? &*at : nullptr;
}

}  // namespace spineloft::io
