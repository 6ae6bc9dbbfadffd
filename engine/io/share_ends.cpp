#include "engine/io/share_ends.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "engine/io/document_json.h"
#include "engine/io/share_grid.h"
#include "engine/io/share_text.h"
#include "engine/ribs/base/spine.h"
#include "engine/ribs/edit/end_curves.h"
#include "engine/ribs/edit/places.h"
#include "engine/ribs/edit/rib_frame.h"

namespace spineloft::io {
namespace {

/// Places along a spine are multiples of 1 / this.
constexpr double kPlaces = 4096;
/// In a text the place of the i-th rib is this and i: the spine tells where it is.
constexpr double kFirstRib = 2;
/// Half the width of a rib whose ends are not put anywhere, in steps of the grid: what its fan is told in.
constexpr double kUnknownUnit = 256;
/// Points of fans are multiples of 1 / this where they are read: all machines read the same ones.
constexpr double kFanDigits = 1048576;

double onGrid(double value, double step) { return std::round(value / step) * step; }

/// What the edits of a part's ribs are told by; without ribs where the stroke gives no spine.
class RibsOfText {
 public:
  RibsOfText(const document::LoftRecipe& recipe, image::Size picture, TracedRibs& traced)
      : step_(2 * shareStep(picture)) {
    auto spine = ribs::cleanSpine(recipe.stroke, picture, recipe.spine);
    if (!spine) return;
    spine_ = std::move(spine).value();
    ruler_.emplace(spine_.points);
    for (std::size_t i = 0; i < spine_.points.size(); ++i) places_.push_back(ruler_->placeOfPoint(i));
    if (places_.size() > traced.left) return;
    traced.left -= places_.size();
    curves_.emplace(spine_, picture);
  }
  RibsOfText(const RibsOfText&) = delete;

  /// As a text says it: with a place of a grid, or at the rib that is the nearest to this, beside its curve.
  void tell(ribs::EndEdit& end) const {
    end.reach = std::round(end.reach * kPlaces) / kPlaces;
    end.at = std::round(end.at * kPlaces) / kPlaces;
    const auto above = std::ranges::lower_bound(places_, end.at - 0.5 / kPlaces);
    if (above != places_.end() && *above <= end.at + 0.5 / kPlaces) {
      const auto rib = static_cast<std::size_t>(above - places_.begin());
      end.at = kFirstRib + static_cast<double>(rib);
      if (curves_) {
        const ribs::EndOnCurve told = curves_->tell(rib, end, step_);
        end.along = told.beside;
        end.out = told.length;
      }
    }
    end.along = onGrid(end.along, step_);
    end.out = onGrid(end.out, step_);
  }
  /// The end that a text of this version says.
  void find(ribs::EndEdit& end, int version) const {
    const double rib = end.at - kFirstRib;
    if (!(rib >= 0 && rib < static_cast<double>(places_.size()))) return;
    const auto i = static_cast<std::size_t>(rib);
    end.at = places_[i];
    if (curves_ && version >= kFirstOnCurves) curves_->put(i, {end.along, end.out}, end);
  }

  /// The frame of the first or the last rib, where both its ends are put somewhere, not in one place.
  std::optional<ribs::RibFrame> frame(const std::vector<ribs::EndEdit>& ends, bool atStart) const {
    const auto endOf = [&](ribs::Side side) -> std::optional<PicturePoint> {
      const auto isIt = [&](const ribs::EndEdit& end) {
        return end.side == side && std::abs(end.at - (atStart ? 0 : 1)) <= 0.5 / kPlaces;
      };
      const auto last = std::find_if(ends.rbegin(), ends.rend(), isIt);
      return last != ends.rend() && ruler_ ? std::optional(ruler_->fromFrame(*last)) : std::nullopt;
    };
    const auto left = endOf(ribs::Side::Left), right = endOf(ribs::Side::Right);
    if (!left || !right) return std::nullopt;
    const ribs::RibFrame frame(*left, *right, atStart);
    return frame.unit() > 0 ? std::optional(frame) : std::nullopt;
  }
  /// Half the width of a frame's rib, picture pixels.
  double unitOf(const std::optional<ribs::RibFrame>& frame) const {
    return frame ? frame->unit() : kUnknownUnit * step_;
  }
  double step() const { return step_; }

 private:
  double step_;
  ribs::Spine spine_;
  std::optional<ribs::Ruler> ruler_;
  std::vector<double> places_;
  std::optional<ribs::EndCurves> curves_;
};

/// The numbers of a told fan (tellEnds), two to a point.
std::vector<ribs::RibPoint> inPairs(const std::vector<double>& numbers) {
  std::vector<ribs::RibPoint> pairs;
  for (std::size_t i = 0; i + 1 < numbers.size(); i += 2) pairs.push_back({numbers[i], numbers[i + 1]});
  return pairs;
}

/// Where a fan of a text is expected, picture pixels in the frame of its rib.
class Expected {
 public:
  Expected(std::size_t count, double tip, double unit, double step)
      : count_(count), tip_(std::max(tip, step)), unit_(unit) {}
  ribs::RibPoint at(std::size_t i) const { return ribs::onEllipse(i, count_, tip_ / unit_) * unit_; }
  ribs::RibPoint out(std::size_t i) const { return normalized(at(i)); }
  ribs::RibPoint round(std::size_t i) const { return {out(i).y, -out(i).x}; }

 private:
  std::size_t count_;
  double tip_, unit_;
};

void tellFan(std::vector<ribs::RibPoint>& fan, const RibsOfText& row, double unit) {
  if (fan.empty()) return;
  const std::size_t count = fan.size(), middle = count / 2;
  const double grid = row.step();
  std::vector<double> out{onGrid(fan[middle].x * unit - unit, grid)}, round;
  const Expected expected(count, out[0] + unit, unit, row.step());
  for (std::size_t i = 0; i < count; ++i) {
    const ribs::RibPoint away = fan[i] * unit - expected.at(i);
    if (i != middle) out.push_back(onGrid(dot(away, expected.out(i)), grid));
    round.push_back(onGrid(i == middle ? -away.y : dot(away, expected.round(i)), grid) / 2);
  }
  out.insert(out.end(), round.begin(), round.end());
  fan = inPairs(out);
}

void findFan(std::vector<ribs::RibPoint>& fan, const RibsOfText& row, double unit) {
  if (fan.empty()) return;
  const std::size_t count = fan.size(), middle = count / 2;
  std::vector<double> numbers;
  for (const ribs::RibPoint p : fan) numbers.insert(numbers.end(), {p.x, p.y});
  const double tip = numbers[0] + unit;
  const Expected expected(count, tip, unit, row.step());
  const auto found = [&](std::size_t i) {
    const double round = 2 * numbers[count + i];
    if (i == middle) return ribs::RibPoint{tip, expected.at(i).y - round};
    return expected.at(i) + expected.out(i) * numbers[i < middle ? i + 1 : i] + expected.round(i) * round;
  };
  const auto digits = [&](double value) { return std::round(value / unit * kFanDigits) / kFanDigits; };
  for (std::size_t i = 0; i < count; ++i) fan[i] = {digits(found(i).x), digits(found(i).y)};
}

}  // namespace

void tellEnds(document::LoftRecipe& recipe, image::Size picture, TracedRibs& traced) {
  ribs::RibEdits& edits = recipe.edits;
  if (edits.ends.empty() && edits.startFan.empty() && edits.endFan.empty()) return;
  const RibsOfText row(recipe, picture, traced);
  for (ribs::EndEdit& end : edits.ends) row.tell(end);
  std::vector<ribs::EndEdit> found = edits.ends;
  for (ribs::EndEdit& end : found) row.find(end, kShareVersion);
  tellFan(edits.startFan, row, row.unitOf(row.frame(found, true)));
  tellFan(edits.endFan, row, row.unitOf(row.frame(found, false)));
}

void findEnds(Json& json, int version) {
  Json* parts = listOf(json, "parts");
  const Json* pictures = listOf(json, kPicturesKey);
  if (parts == nullptr || pictures == nullptr) return;
  TracedRibs traced;
  for (Json& part : *parts) {
    const auto recipe = part.is_object() ? part.find("recipe") : part.end();
    if (recipe == part.end() || !recipe->is_object()) continue;
    const auto edits = recipe->find("edits");
    if (edits == recipe->end()) continue;
    Json* ends = listOf(*edits, "ends");
    Json *startFan = listOf(*edits, "startFan"), *endFan = listOf(*edits, "endFan");
    if ((ends == nullptr || ends->empty()) && startFan == nullptr && endFan == nullptr) continue;
    ReadNotes notes;
    document::LoftRecipe loft;
    Json stroke = {{"picture", recipe->value("picture", Json())}, {"stroke", recipe->value("stroke", Json())}};
    if (recipe->contains("spine")) stroke["spine"] = (*recipe)["spine"];
    read(stroke, loft, {notes, {}});
    image::Size size;
    for (const Json& picture : *pictures) {
      std::uint32_t id = 0;
      const bool ours = picture.is_object() && get(picture.value("id", Json()), id) && id == loft.picture.value;
      if (ours) get(picture.value("size", Json()), size);
    }
    const RibsOfText row(loft, size, traced);
    std::vector<ribs::EndEdit> found;
    if (ends != nullptr) {
      for (Json& end : *ends) {
        ribs::EndEdit edit;
        if (!get(end, edit)) continue;
        row.find(edit, version);
        found.push_back(edit);
        end = toJson(edit);
      }
    }
    for (Json* fan : {startFan, endFan}) {
      std::vector<ribs::RibPoint> points;
      if (fan == nullptr || !get(*fan, points)) continue;
      findFan(points, row, row.unitOf(row.frame(found, fan == startFan)));
      *fan = toJson(points);
    }
  }
}

}  // namespace spineloft::io
