#include "engine/io/json_values.h"

#include <cmath>
#include <limits>
#include <new>
#include <nlohmann/json.hpp>

namespace spineloft::io {
namespace {

using Json = nlohmann::ordered_json;

Json parse(std::string_view text) {
  constexpr bool kNoExceptions = false;
  return Json::parse(text.begin(), text.end(), nullptr, kNoExceptions);
}

const Json* member(const Json& object, const char* key) {
  if (!object.is_object()) return nullptr;
  const auto at = object.find(key);
  return at == object.end() ? nullptr : &*at;
}

std::string where(std::size_t index, std::string_view what) {
  return "point " + std::to_string(index + 1) + ' ' + std::string(what);
}

/// null stands for NaN and the infinities, which JSON cannot spell.
bool isCoordinate(const Json& value) { return value.is_number() || value.is_null(); }
double coordinate(const Json& value) {
  return value.is_number() ? value.get<double>() : std::numeric_limits<double>::quiet_NaN();
}

Result<std::vector<PicturePoint>> pointsOf(const Json& list) {
  if (!list.is_array()) return {Error::JsonInvalid, "a stroke is a list of [x, y]"};
  if (list.empty()) return {Error::StrokeTooShort, "the list is empty"};
  std::vector<PicturePoint> points;
  points.reserve(list.size());
  for (const Json& item : list) {
    if (!item.is_array() || item.size() < 2 || !isCoordinate(item[0]) || !isCoordinate(item[1])) {
      return {Error::JsonInvalid, where(points.size(), "is not [x, y]")};
    }
    const PicturePoint point{coordinate(item[0]), coordinate(item[1])};
    if (!isFinite(point)) return {Error::StrokeNotFinite, where(points.size(), "is not finite")};
    points.push_back(point);
  }
  return points;
}

std::string namesIn(const Json& object) {
  std::string names;
  for (const auto& [key, value] : object.items()) names += (names.empty() ? "" : ", ") + key;
  return names.empty() ? "none" : names;
}

Result<std::vector<PicturePoint>> strokeIn(const Json& root, std::string_view name) {
  if (root.is_discarded()) return {Error::JsonInvalid, "not JSON"};
  const Json* spines = member(root, "spines");
  if (spines == nullptr) {
    if (!name.empty()) return {Error::JsonInvalid, "there are no named strokes in it"};
    const Json* points = member(root, "points");
    return pointsOf(points != nullptr ? *points : root);
  }
  if (!spines->is_object() || spines->empty()) {
    return {Error::JsonInvalid, "`spines` must map names to strokes"};
  }
  if (name.empty()) return pointsOf(spines->begin().value());
  const Json* chosen = member(*spines, std::string(name).c_str());
  if (chosen == nullptr) {
    return {Error::JsonInvalid, "no stroke is called " + std::string(name) + "; there are " + namesIn(*spines)};
  }
  return pointsOf(*chosen);
}

Json pair(PicturePoint p) { return Json::array({p.x, p.y}); }

Json object(const NamedNumbers& numbers) {
  Json out = Json::object();
  for (const auto& [name, value] : numbers) {
    // Counts read better without a fraction.
    if (value == std::floor(value) && std::abs(value) < 1e15) {
      out[name] = static_cast<std::int64_t>(value);
    } else {
      out[name] = value;
    }
  }
  return out;
}

std::string textOf(const Json& json, int indent) {
  // Names come from files: bytes that are not UTF-8 are replaced, not thrown at.
  return json.dump(indent, ' ', false, Json::error_handler_t::replace) + '\n';
}

std::string stringIn(const Json& root, const char* key) {
  const Json* value = member(root, key);
  return value != nullptr && value->is_string() ? value->get<std::string>() : std::string();
}

std::optional<BenchDifficulty> difficultyIn(const Json& root) {
  const Json* said = member(root, "difficulty");
  if (said == nullptr || !said->is_object()) return std::nullopt;
  const auto number = [&](const char* key) {
    const Json* value = member(*said, key);
    return value != nullptr && value->is_number() ? value->get<double>() : 0.0;
  };
  return BenchDifficulty{number("occlusion_pct"), number("missing_boundary_pct"), number("noise_sigma"),
                         number("no_edge_pct"), number("inner_edges_per_1000px")};
}

Result<BenchCase> caseIn(const Json& root) {
  if (root.is_discarded()) return {Error::JsonInvalid, "not JSON"};
  BenchCase out{
      stringIn(root, "id"), stringIn(root, "category"), stringIn(root, "image"), stringIn(root, "mask"), 1, {}, {},
      difficultyIn(root)};
  if (out.id.empty() || out.image.empty() || out.mask.empty()) {
    return {Error::JsonInvalid, "a case needs an id, an image and a mask"};
  }
  const Json* tolerance = member(root, "boundary_tolerance_px");
  if (tolerance != nullptr && tolerance->is_number()) out.boundaryTolerance = tolerance->get<double>();
  const Json* axis = member(root, "axis");
  const Json* spines = member(root, "spines");
  if (axis == nullptr || !axis->is_array() || axis->size() < 2 || spines == nullptr || !spines->is_object()) {
    return {Error::JsonInvalid, "a case needs an axis and spines"};
  }
  for (const Json& point : *axis) {
    if (!point.is_array() || point.size() < 3 || !point[0].is_number() || !point[1].is_number() ||
        !point[2].is_number()) {
      return {Error::JsonInvalid, "an axis point is [x, y, width]"};
    }
    out.axis.push_back({point[0].get<double>(), point[1].get<double>(), point[2].get<double>()});
  }
  for (const auto& [name, list] : spines->items()) {
    Result<std::vector<PicturePoint>> points = pointsOf(list);
    if (!points.ok()) return points.failure();
    out.strokes.emplace_back(name, std::move(points).value());
  }
  return out;
}

/// The skeletons of all pieces as one.
Json bonesJson(const std::vector<inflate::Skeleton>& skeletons) {
  int ends = 0, forks = 0, rings = 0;
  double length = 0;
  Json branches = Json::array();
  for (const inflate::Skeleton& skeleton : skeletons) {
    ends += skeleton.ends;
    forks += skeleton.forks;
    rings += skeleton.rings;
    length += inflate::lengthOf(skeleton);
    for (const auto& branch : skeleton.branches) {
      Json line = Json::array();
      for (const std::uint32_t p : branch) {
        const auto& [at, radius, factor] = skeleton.points[p];
        for (const double number : {at.x, -at.y, radius}) line.push_back(number);
      }
      branches.push_back(std::move(line));
    }
  }
  return {{"ends", ends}, {"forks", forks}, {"rings", rings}, {"length", length}, {"branches", std::move(branches)}};
}

}  // namespace

Result<std::vector<PicturePoint>> readStroke(std::string_view json, std::string_view name) {
  try {
    return strokeIn(parse(json), name);
  } catch (const std::bad_alloc&) {
    return Error::OutOfMemory;
  }
}

std::string writeRibs(const ribs::RibSet& ribs) {
  Json list = Json::array();
  for (const ribs::Rib& rib : ribs.ribs) {
    list.push_back({{"center", pair(rib.center)},
                    {"left", pair(rib.left)},
                    {"right", pair(rib.right)},
                    {"leftState", ribs::ribStateKey(rib.leftState)},
                    {"rightState", ribs::ribStateKey(rib.rightState)}});
  }
  return textOf({{"ribs", std::move(list)}}, -1);
}

std::string writeReport(const LoftReport& report) {
  const mesh::MeshReport& mesh = report.mesh;
  const ribs::EnergyTerms& energy = report.energy;
  Json json = {{"picture", {{"width", report.picture.width}, {"height", report.picture.height}}},
               {"ribs", report.ribs},
               {"energy",
                {{"distance", energy.distance},
                 {"neighbour", energy.neighbour},
                 {"opposite", energy.opposite},
                 {"prior", 0},  // of a term that once was; reports keep their keys
                 {"total", energy.total()}}},
               {"mesh",
                {{"vertices", report.vertices},
                 {"triangles", report.triangles},
                 {"closed", mesh.closed},
                 {"lawful", mesh.valid()},
                 {"shells", mesh.shells},
                 {"genus", mesh.genus},
                 {"crossesItself", report.crossesItself},
                 {"volume", mesh.volume},
                 {"area", mesh.area}}},
               {"milliseconds", object(report.milliseconds)}};
  if (report.bones) {
    json["bones"] = bonesJson(*report.bones);
    json["bones"]["asleep"] = report.asleep;
  }
  if (report.profile) {
    const auto& [slices, middle, offAxis, thickened] = *report.profile;
    json["profile"] = {{"slices", slices}, {"middle", middle}, {"offAxis", offAxis}, {"thickened", thickened}};
  }
  if (report.ways) {
    json["links"] = json["forks"] = Json::array();
    for (const auto& [plane, curve, nextPlane, nextCurve] : report.ways->links) {
      json["links"].push_back({plane, curve, nextPlane, nextCurve});
    }
    for (const auto& [plane, curve, up, at] : report.ways->forks) {
      json["forks"].push_back({{"plane", plane}, {"curve", curve}, {"up", up}, {"at", at}});
    }
  }
  return textOf(json, 2);
}

Result<BenchCase> readBenchCase(std::string_view json) {
  try {
    return caseIn(parse(json));
  } catch (const std::bad_alloc&) {
    return Error::OutOfMemory;
  }
}

std::string writeBench(const BenchReport& report) {
  const auto groups = [](const auto& named) {
    Json all = Json::array();
    for (const auto& [name, numbers] : named) {
      Json group = {{"name", name}};
      group.update(object(numbers));
      all.push_back(std::move(group));
    }
    return all;
  };
  Json cases = Json::array();
  for (const BenchRow& row : report.rows) {
    Json line = {{"name", row.name + ' ' + row.stroke},
                 {"id", row.name},
                 {"category", row.category},
                 {"stroke", row.stroke},
                 {"difficulty", row.difficulty}};
    if (!row.failure.empty()) line["failure"] = row.failure;
    line.update(object(row.numbers));
    cases.push_back(std::move(line));
  }
  Json all = {{"summary", groups(report.summary)}, {"cases", std::move(cases)}};
  for (const auto& [name, lines] : report.tables) all[name] = groups(lines);
  return textOf(all, 1);
}

std::string writeNumbers(const NamedNumbers& numbers) { return textOf(object(numbers), 1); }

}  // namespace spineloft::io
