#include "web/commands/command_args.h"

#include <array>
#include <cmath>
#include <limits>

#include "engine/mesh/ray_hit.h"
#include "web/commands/command_actions.h"

namespace spineloft::app {
namespace {

std::optional<PicturePoint> pairOf(const Json& value) {
  const Json::Array* pair = value.array();
  if (pair == nullptr || pair->size() < 2) return std::nullopt;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  return PicturePoint{(*pair)[0].number().value_or(nan), (*pair)[1].number().value_or(nan)};
}

}  // namespace

Outcome missing(std::string_view what) { return Refusal{"ArgumentMissing", "This needs " + std::string(what) + "."}; }

Outcome noPart() { return refuse({Error::NoSuchPart, {}}); }

Outcome noSpine(const document::Part* part) {
  const bool other = part != nullptr && document::loftOf(*part) == nullptr;
  return refuse({other ? Error::NotABone : Error::NoSuchPart, {}});
}
Outcome noSpine(const CommandEnv& env, const Json& args) { return noSpine(partOf(env, args)); }

std::optional<std::vector<PicturePoint>> strokeOf(const Json& args, std::string_view key) {
  const Json* list = args.find(key);
  if (list == nullptr || list->array() == nullptr) return std::nullopt;
  std::vector<PicturePoint> stroke;
  for (const Json& entry : *list->array()) {
    const std::optional<PicturePoint> point = pairOf(entry);
    if (!point) return std::nullopt;
    stroke.push_back(*point);
  }
  return stroke;
}

std::optional<std::vector<std::vector<PicturePoint>>> linesOf(const Json& args, std::string_view key) {
  const Json* list = args.find(key);
  if (list == nullptr || list->array() == nullptr) return std::nullopt;
  std::vector<std::vector<PicturePoint>> lines;
  for (const Json& one : *list->array()) {
    auto line = strokeOf(Json::Object{{"stroke", one}});
    if (!line) return std::nullopt;
    lines.push_back(std::move(*line));
  }
  return lines;
}

std::optional<PicturePoint> pointOf(const Json& args, std::string_view key) {
  const Json* value = args.find(key);
  return value ? pairOf(*value) : std::nullopt;
}

std::optional<ModelPoint> placeOf(const mesh::TriMesh& mesh, const Json& place, bool back) {
  constexpr double kFar = 1e7;
  const Json::Array* numbers = place.array();
  if (numbers == nullptr || numbers->size() < 2 || numbers->size() > 3) return std::nullopt;
  std::array<double, 3> at{};
  for (std::size_t i = 0; i < numbers->size(); ++i) at[i] = (*numbers)[i].number().value_or(NAN);
  if (numbers->size() == 3) return ModelPoint{at[0], at[1], at[2]};
  const double way = back ? 1 : -1;
  const ModelPoint eye{at[0], -at[1], -way * kFar};
  const double far = mesh::firstHit(mesh, eye, {0, 0, way}).far;
  return std::isfinite(far) ? std::optional(eye + ModelPoint{0, 0, way * far}) : std::nullopt;
}

std::optional<PicturePoint> nudgeOf(const Json& args) {
  constexpr double kFar = 10;
  if (args.find("by")) return pointOf(args, "by");
  const std::string* key = args.text("key");
  if (key == nullptr) return std::nullopt;
  const double step = args.flag("far").value_or(false) ? kFar : 1;
  if (*key == "ArrowLeft") return PicturePoint{-step, 0};
  if (*key == "ArrowRight") return PicturePoint{step, 0};
  if (*key == "ArrowUp") return PicturePoint{0, -step};
  if (*key == "ArrowDown") return PicturePoint{0, step};
  return std::nullopt;
}

std::optional<geometry::AlongCurve> curveOf(const Json& args, std::string_view key) {
  const std::optional<std::vector<PicturePoint>> points = strokeOf(args, key);
  if (!points) return std::nullopt;
  geometry::AlongCurve curve;
  for (const PicturePoint p : *points) curve.points.push_back({p.x, p.y});
  return curve;
}

std::optional<ribs::EndRef> endOf(const Json& args) {
  const std::optional<double> rib = args.number("rib");
  const std::string* side = args.text("side");
  if (!rib || !(*rib >= 0) || *rib > 1e6 || *rib != std::floor(*rib) || side == nullptr) {
    return std::nullopt;
  }
  if (*side != "left" && *side != "right") return std::nullopt;
  return ribs::EndRef{static_cast<std::size_t>(*rib), *side == "left" ? ribs::Side::Left : ribs::Side::Right};
}

PartId idFrom(const Json& args, std::string_view key) {
  const std::optional<double> id = args.number(key);
  if (!id || !(*id >= 1) || *id > 4e9 || *id != std::floor(*id)) return {};
  return PartId{static_cast<std::uint32_t>(*id)};
}

bool namesPart(const Json& args) { return args.find("part") != nullptr || args.find("id") != nullptr; }

}  // namespace spineloft::app
