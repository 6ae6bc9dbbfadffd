#include "engine/io/share_slices.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/inflate/ready_profiles.h"
#include "engine/io/share_grid.h"
#include "engine/sections/section.h"

namespace spineloft::io {
namespace {

constexpr const char* kProfile = "profile";
constexpr const char* kSlices = "slices";
constexpr const char* kShape = "shape";
constexpr const char* kContours = "contours";
constexpr const char* kMirror = "mirror";

using Points = std::vector<SectionPoint>;

/// As a text has it.
Json kept(const inflate::ProfileParams& profile) {
  Json json = toJson(profile);
  roundNumbers(json);
  return json;
}

/// Profiles that have a name, and it.
const std::vector<std::pair<std::string, Json>>& namedProfiles() {
  static const auto made = [] {
    std::vector<std::pair<std::string, Json>> out;
    for (const inflate::ReadyProfile& ready : inflate::readyProfiles()) {
      const auto profile = inflate::readyProfile(ready.key);
      if (!profile->isSoft()) out.emplace_back(ready.key, kept(*profile));
    }
    for (const sections::SectionName& name : sections::sectionNames()) {
      inflate::ProfileParams profile;
      profile.slices = {{sections::SectionShape{name.preset}}};
      out.emplace_back(name.key, kept(profile));
    }
    return out;
  }();
  return made;
}
const Json* profileNamed(const Json& name) {
  if (!name.is_string()) return nullptr;
  const auto found =
      std::ranges::find(namedProfiles(), name.get_ref<const std::string&>(), &std::pair<std::string, Json>::first);
  return found == namedProfiles().end() ? nullptr : &found->second;
}

/// The shape of its one slice as a text has it; none where it is the usual one.
const Json* shapeOf(const Json& profile) {
  const auto slices = profile.find(kSlices);
  if (slices == profile.end() || slices->empty()) return nullptr;
  const auto shape = slices->front().find(kShape);
  return shape == slices->front().end() ? nullptr : &*shape;
}

SectionPoint mirrored(SectionPoint p) { return {p.x == 0 ? 0 : -p.x, p.y}; }

/// The k for which each point i is the mirror image of point k − i.
std::optional<std::size_t> foldOf(const Points& curve) {
  const std::size_t n = curve.size();
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t i = 0;
    while (i < n && mirrored(curve[i]) == curve[(k + n - i) % n]) ++i;
    if (i == n) return k;
  }
  return std::nullopt;
}
/// How many of n points tell all, from point (k + 1)/2 on.
std::size_t halfOf(std::size_t n, std::size_t k) { return k % 2 == 0 ? n / 2 + 1 : (n + 1) / 2; }
Points halved(const Points& curve, std::size_t k) {
  Points half;
  for (std::size_t i = 0; i < halfOf(curve.size(), k); ++i) half.push_back(curve[((k + 1) / 2 + i) % curve.size()]);
  return half;
}
std::optional<Points> unfolded(const Points& half, std::size_t k, bool odd) {
  const std::size_t m = half.size(), n = k % 2 == 0 ? 2 * m - (odd ? 1 : 2) : 2 * m - (odd ? 1 : 0);
  if (m < 2 || k >= n) return std::nullopt;
  Points curve(n);
  for (std::size_t i = 0; i < m; ++i) {
    const std::size_t at = ((k + 1) / 2 + i) % n;
    curve[(k + n - at) % n] = mirrored(half[i]);
    curve[at] = half[i];
  }
  return curve;
}

/// Point i of the mirror image backwards, from point k on.
SectionPoint imageAt(const Points& curve, std::size_t k, std::size_t i) {
  const std::size_t n = curve.size();
  return mirrored(curve[(2 * n - 1 - i - k) % n]);
}
Points imageOf(const Points& curve, std::size_t k) {
  Points image;
  for (std::size_t i = 0; i < curve.size(); ++i) image.push_back(imageAt(curve, k, i));
  return image;
}
std::optional<std::size_t> turnOf(const Points& curve, const Points& other) {
  if (curve.size() != other.size()) return std::nullopt;
  for (std::size_t k = 0; k < curve.size(); ++k) {
    std::size_t i = 0;
    while (i < other.size() && imageAt(curve, k, i) == other[i]) ++i;
    if (i == other.size()) return k;
  }
  return std::nullopt;
}

std::optional<std::vector<Points>> curvesIn(const Json& shape) {
  if (!shape.is_object() || !shape.contains(kContours)) return std::nullopt;
  const Json& contours = shape[kContours];
  if (!contours.is_array() || contours.size() > sections::kMostContours) return std::nullopt;
  std::vector<Points> curves(contours.size());
  for (std::size_t c = 0; c < curves.size(); ++c) {
    if (contours[c].size() > 2 * sections::kMostDrawnPoints || !get(contours[c], curves[c])) return std::nullopt;
  }
  return curves;
}

Json shortShape(const Json& shape) {
  for (const auto& [name, profile] : namedProfiles()) {
    const Json* known = shapeOf(profile);
    if (known != nullptr && *known == shape) return name;
  }
  const auto curves = curvesIn(shape);
  if (!curves || shape.size() > 1) return shape;
  std::vector<Points> out;
  Json folds = Json::array();
  bool any = false;
  for (std::size_t c = 0; c < curves->size(); ++c) {
    const Points& curve = (*curves)[c];
    const auto turn = c + 1 < curves->size() ? turnOf(curve, (*curves)[c + 1]) : std::nullopt;
    const auto fold = turn ? std::nullopt : foldOf(curve);
    any |= turn || fold;
    folds.push_back(turn   ? -1 - static_cast<std::int64_t>(*turn)
                    : fold ? 1 + 2 * static_cast<std::int64_t>(*fold) + static_cast<std::int64_t>(curve.size() % 2)
                           : 0);
    out.push_back(fold ? halved(curve, *fold) : curve);
    if (turn) ++c;
  }
  return any ? Json{{kContours, toJson(out)}, {kMirror, folds}} : shape;
}

/// What it is where it says so; else itself.
Json wholeShape(const Json& shape) {
  if (const Json* profile = profileNamed(shape)) {
    const Json* known = shapeOf(*profile);
    return known != nullptr ? *known : shape;
  }
  if (!shape.is_object() || !shape.contains(kMirror)) return shape;
  const auto curves = curvesIn(shape);
  const Json& folds = shape[kMirror];
  if (!curves || !folds.is_array() || folds.size() != curves->size()) return shape;
  std::vector<Points> out;
  for (std::size_t c = 0; c < curves->size(); ++c) {
    const Points& curve = (*curves)[c];
    if (!folds[c].is_number_integer()) return shape;
    const auto fold = folds[c].get<std::int64_t>();
    const auto code = static_cast<std::size_t>(fold < 0 ? -(fold + 1) : std::max<std::int64_t>(fold - 1, 0));
    std::optional<Points> first = fold > 0 ? unfolded(curve, code / 2, code % 2 != 0) : std::optional(curve);
    if (!first || (fold < 0 && code >= curve.size())) return shape;
    out.push_back(std::move(*first));
    if (fold < 0) out.push_back(imageOf(curve, code));
  }
  return {{kContours, toJson(out)}};
}

template <class Change>
void eachPuff(Json& document, const Change& change) {
  Json* parts = document.is_object() ? listOf(document, "parts") : nullptr;
  if (parts == nullptr) return;
  for (Json& part : *parts) {
    if (!part.is_object() || part.value("kind", Json()) != "puff") continue;
    const auto recipe = part.find("recipe");
    if (recipe != part.end() && recipe->is_object()) change(*recipe);
  }
}
template <class Change>
void eachShape(Json& profile, const Change& change) {
  Json* slices = profile.is_object() ? listOf(profile, kSlices) : nullptr;
  if (slices == nullptr) return;
  for (Json& slice : *slices) {
    if (slice.is_object() && slice.contains(kShape)) slice[kShape] = change(slice[kShape]);
  }
}
/// A profile of nothing but one shape.
Json profileOf(Json shape) {
  Json slice = Json::object();
  slice[kShape] = std::move(shape);
  Json profile = Json::object();
  profile[kSlices] = Json::array({std::move(slice)});
  return profile;
}

}  // namespace

void shortenSlices(Json& document) {
  eachPuff(document, [](Json& recipe) {
    const auto profile = recipe.find(kProfile);
    if (profile == recipe.end() || recipe.contains(kShape)) return;
    const auto named = std::ranges::find(namedProfiles(), *profile, &std::pair<std::string, Json>::second);
    if (named != namedProfiles().end()) {
      recipe[kShape] = named->first;
      recipe.erase(kProfile);
      return;
    }
    eachShape(*profile, shortShape);
    const Json* slices = listOf(*profile, kSlices);
    if (slices == nullptr || slices->size() != 1 || !(*slices)[0].is_object()) return;
    const Json shape = (*slices)[0].value(kShape, Json());
    if (!shape.is_object() || *profile != profileOf(shape)) return;
    recipe[kShape] = shape;
    recipe.erase(kProfile);
  });
}

void restoreSlices(Json& document) {
  eachPuff(document, [](Json& recipe) {
    const auto shape = recipe.find(kShape);
    if (shape != recipe.end() && !recipe.contains(kProfile)) {
      const Json* named = profileNamed(*shape);
      Json profile = named != nullptr ? *named : profileOf(wholeShape(*shape));
      recipe.erase(kShape);
      recipe[kProfile] = std::move(profile);
      return;
    }
    if (recipe.contains(kProfile)) eachShape(recipe[kProfile], wholeShape);
  });
}

}  // namespace spineloft::io
