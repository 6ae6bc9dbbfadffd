#include "engine/inflate/ready_profiles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace spineloft::inflate {
namespace {

using Curve = std::vector<SectionPoint>;

constexpr std::array kNames = {
    ReadyProfile{"soft", "Soft"},   ReadyProfile{"round", "Round"},         ReadyProfile{"roof", "Roof"},
    ReadyProfile{"block", "Block"}, ReadyProfile{"step", "Step"},           ReadyProfile{"bowl", "Bowl"},
    ReadyProfile{"ring", "Ring"},   ReadyProfile{"two-rings", "Two rings"},
};

/// The right half of a curve that begins and ends on the axis, and its mirror image; counter-clockwise from below.
Curve mirrored(Curve right) {
  for (std::size_t i = right.size(); i-- > 0;) {
    if (right[i].x > 0) right.push_back({-right[i].x, right[i].y});
  }
  return right;
}

/// Coordinates of ready slices have three decimals, which a link keeps in few characters; what is nearer is the same.
constexpr double kSteps = 1000;
double onGrid(double v) { return std::round(v * kSteps) / kSteps; }

/// Whether two slices are the same to the grid: links and older files hold other digits.
bool areAlike(const sections::SectionShape& a, const sections::SectionShape& b) {
  const auto near = [](SectionPoint p, SectionPoint q) {
    return std::max(std::abs(p.x - q.x), std::abs(p.y - q.y)) * kSteps <= 1;
  };
  const auto alike = [&](const Curve& one, const Curve& other) { return std::ranges::equal(one, other, near); };
  return a.preset == b.preset && std::ranges::equal(a.contours, b.contours, alike);
}

/// A tube round the outline whose circle has its middle at x = `middle`, and its mirror image.
void addTube(std::vector<Curve>& curves, double middle, double radius) {
  constexpr int kPoints = 24;
  Curve right, left;
  for (int i = 0; i < kPoints; ++i) {
    const double angle = 2 * std::numbers::pi * i / kPoints;
    const SectionPoint p{onGrid(middle + radius * std::cos(angle)), onGrid(radius * std::sin(angle))};
    right.push_back(p);
    left.push_back({-p.x, p.y});
  }
  std::ranges::reverse(left);
  curves.push_back(std::move(right));
  curves.push_back(std::move(left));
}

ProfileParams profileOf(sections::SectionShape shape, double follow) { return {{{std::move(shape)}}, follow}; }

ProfileParams drawn(std::vector<Curve> curves, double follow) {
  sections::SectionShape shape;
  shape.contours = std::move(curves);
  return profileOf(std::move(shape), follow);
}

}  // namespace

std::span<const ReadyProfile> readyProfiles() { return kNames; }

std::optional<ProfileParams> readyProfile(std::string_view key) {
  // As thick as the place is wide where the middle is the highest; else as thick everywhere.
  if (key == "soft") return ProfileParams{};
  if (key == "round") return profileOf(sections::SectionPreset::Circle, 1);
  if (key == "roof") return drawn({{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}}, 1);
  if (key == "block") return drawn({mirrored({{0, -0.4}, {1, -0.4}, {1, 0.4}, {0, 0.4}})}, 0);
  if (key == "step") {
    return drawn(
        {mirrored({{0, -0.5}, {0.6, -0.5}, {0.6, -0.25}, {1, -0.25}, {1, 0.25}, {0.6, 0.25}, {0.6, 0.5}, {0, 0.5}})},
        0);
  }
  if (key == "bowl") {
    return drawn({mirrored({{0, -0.4}, {0.7, -0.4}, {1, 0.4}, {0.8, 0.4}, {0.6, -0.1}, {0, -0.2}})}, 0);
  }
  std::vector<Curve> tubes;
  if (key == "ring") {
    addTube(tubes, 0.7, 0.3);
    return drawn(std::move(tubes), 1);
  }
  if (key == "two-rings") {
    addTube(tubes, 0.83, 0.17);
    addTube(tubes, 0.4, 0.17);
    return drawn(std::move(tubes), 1);
  }
  return std::nullopt;
}

std::string_view profileKey(const ProfileParams& profile) {
  for (const ReadyProfile& name : kNames) {
    const auto ready = readyProfile(name.key)->slices;
    if (ready.empty() || profile.isSoft()) {
      if (ready.empty() && profile.isSoft()) return name.key;
    } else if (areAlike(ready.front().shape, profile.slices.front().shape)) {
      return name.key;
    }
  }
  return "own";
}

}  // namespace spineloft::inflate
