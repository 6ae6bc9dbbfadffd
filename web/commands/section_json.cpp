#include "web/commands/section_json.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/geometry/polygon.h"
#include "web/edit/section_editing.h"

namespace spineloft::app {
namespace {

constexpr std::size_t kMostNameBytes = document::kMaxNameBytes;

Json pointsJson(const std::vector<SectionPoint>& points) {
  Json::Array list;
  for (const SectionPoint p : points) list.push_back(Json::Array{p.x, p.y});
  return list;
}

Result<sections::SectionShape> shapeOfContours(const Json& contours) {
  const auto bad = [] { return Failure{Error::SectionInvalid, "contours: [[[x, y], …], …]"}; };
  if (contours.array() == nullptr || contours.array()->size() > sections::kMostContours) return bad();
  std::vector<std::vector<SectionPoint>> outlines;
  for (const Json& entry : *contours.array()) {
    std::optional<std::vector<SectionPoint>> points = pointsFrom(&entry);
    if (!points || points->size() > sections::kMostDrawnPoints) return bad();
    outlines.push_back(std::move(*points));
  }
  return sections::sectionOfOutlines(std::move(outlines));
}

std::string_view nameOf(const sections::SectionShape& shape) {
  return shape.drawn() ? std::string_view("drawn") : sections::sectionKey(shape.preset);
}

bool isHole(const std::vector<SectionPoint>& contour) {
  return geometry::signedArea(std::span<const SectionPoint>(contour)) < 0;
}

std::string_view blendKey(sections::BlendKind kind) {
  for (const sections::BlendName& name : sections::blendNames()) {
    if (name.kind == kind) return name.key;
  }
  return {};
}

void writeCurve(JsonWriter& json, const geometry::AlongCurve& curve, double unit) {
  json.beginArray();
  for (const geometry::AlongPoint& p : curve.points) {
    json.beginArray().number(p.at).number(p.value / unit).endArray();
  }
  json.endArray();
}

}  // namespace

std::optional<std::vector<SectionPoint>> pointsFrom(const Json* list) {
  if (list == nullptr || list->array() == nullptr) return std::nullopt;
  std::vector<SectionPoint> points;
  for (const Json& entry : *list->array()) {
    const Json::Array* pair = entry.array();
    if (pair == nullptr || pair->size() < 2) return std::nullopt;
    const double nan = std::numeric_limits<double>::quiet_NaN();
    points.push_back({(*pair)[0].number().value_or(nan), (*pair)[1].number().value_or(nan)});
  }
  return points;
}

std::optional<geometry::AlongCurve> curveFrom(const Json* list) {
  const std::optional<std::vector<SectionPoint>> points = pointsFrom(list);
  if (!points) return std::nullopt;
  geometry::AlongCurve curve;
  for (const SectionPoint p : *points) curve.points.push_back({p.x, p.y});
  return curve;
}

Result<std::optional<sections::SectionShape>> shapeFrom(const Json& args, const SectionUi& sections) {
  using Shape = std::optional<sections::SectionShape>;
  if (const Json* contours = args.find("contours")) {
    Result<sections::SectionShape> shape = shapeOfContours(*contours);
    if (!shape) return shape.failure();
    return Shape(std::move(shape).value());
  }
  if (const std::optional<double> id = args.number("shelf")) {
    const auto at = std::ranges::find_if(sections.shelf, [&](const ShelfSection& s) { return s.id == *id; });
    if (at == sections.shelf.end()) return {Error::ValueOutOfRange, "shelf"};
    return Shape(at->shape);
  }
  if (const std::string* key = args.text("section")) {
    const std::optional<sections::SectionPreset> preset = sections::sectionFromKey(*key);
    if (!preset) return {Error::ValueOutOfRange, *key};
    return Shape(sections::SectionShape(*preset));
  }
  return Shape();
}

Result<sections::Blend> blendFrom(const Json& args, const sections::Blend& fallback) {
  const std::string* key = args.text("blend");
  if (key == nullptr) return fallback;
  const std::optional<sections::BlendKind> kind = sections::blendFromKey(*key);
  if (!kind) return {Error::ValueOutOfRange, *key};
  sections::Blend before = fallback;
  if (*kind == sections::BlendKind::Custom && args.find("points") != nullptr) {
    const std::optional<geometry::AlongCurve> curve = curveFrom(args.find("points"));
    if (!curve) return {Error::ValueOutOfRange, "points: [[t, value], …]"};
    before.custom = *curve;
  }
  return blendOf(*kind, before);
}

Json shapeJson(const sections::SectionShape& shape) {
  if (!shape.drawn()) return Json::Object{{"section", sections::sectionKey(shape.preset)}};
  Json::Array contours;
  for (const auto& contour : shape.contours) contours.push_back(pointsJson(contour));
  return Json::Object{{"contours", std::move(contours)}};
}

Json shelfJson(const SectionUi& sections) {
  Json::Array list;
  for (const ShelfSection& section : sections.shelf) {
    Json::Object entry = *shapeJson(section.shape).object();
    entry.emplace_back("name", section.name);
    list.push_back(std::move(entry));
  }
  return list;
}

void readShelf(SectionUi& sections, const Json& shelf) {
  sections.shelf.clear();
  if (shelf.array() == nullptr) return;
  for (const Json& entry : *shelf.array()) {
    if (sections.shelf.size() >= kMostShelfSections) return;
    Result<std::optional<sections::SectionShape>> shape = shapeFrom(entry, sections);
    const std::string* name = entry.text("name");
    if (!shape || !shape.value() || !shape.value()->drawn()) continue;
    const std::uint32_t id = ++sections.lastShelfId;
    const bool named = name && !name->empty() && name->size() <= kMostNameBytes;
    sections.shelf.push_back({id, named ? *name : "My slice " + std::to_string(id), *std::move(shape).value()});
  }
}

void writeSections(JsonWriter& json, const document::Part& part) {
  json.key("slices").beginArray();
  for (const loft::SectionKey& key : document::loftIn(part).loft.sections) {
    const auto holes = std::ranges::count_if(key.shape.contours, isHole);
    const auto curves = key.shape.drawn() ? std::ssize(key.shape.contours) : 1;
    json.beginObject().key("at").number(key.at).key("section").text(nameOf(key.shape));
    json.key("curves").number(static_cast<double>(curves - holes));
    json.key("holes").number(static_cast<double>(holes));
    json.key("blend").text(blendKey(key.blend.kind)).endObject();
  }
  json.endArray().key("along").beginObject();
  for (const AlongInfo& info : alongTable()) {
    json.key(info.key);
    writeCurve(json, alongOf(document::loftIn(part).loft, info.kind), info.unit);
  }
  json.endObject();
}

void writeSectionUi(JsonWriter& json, const SectionUi& sections) {
  json.key("shelf").beginArray();
  for (const ShelfSection& section : sections.shelf) {
    json.beginObject().key("id").number(section.id).key("name").text(section.name).endObject();
  }
  json.endArray().key("slice").number(static_cast<double>(sections.key));
  json.key("placing").flag(sections.placing).key("sliceBoard");
  if (!sections.board) {
    json.null();
    return;
  }
  const SectionBoard& board = *sections.board;
  json.beginObject().key("tool").text(boardToolKey(board.tool));
  json.key("symmetry").beginObject().key("leftRight").flag(board.symmetry.leftRight);
  json.key("frontBack").flag(board.symmetry.frontBack);
  json.key("fold").number(board.symmetry.fold).endObject();
  json.key("curves").beginArray();
  for (const sections::DrawnCurve& curve : board.shown()) {
    json.beginArray();
    for (const sections::DrawnPoint& p : curve.points) {
      json.beginArray().number(p.at.x).number(p.at.y).flag(p.corner).endArray();
    }
    json.endArray();
  }
  json.endArray();
  const auto problem = sections::problemOf(board.shown());
  json.key("problem");
  problem ? json.text(sections::sentenceOf(problem->fault)) : json.null();
  json.key("undo").number(static_cast<double>(board.past.size()));
  json.key("redo").number(static_cast<double>(board.future.size()));
  const Rect& at = board.square;  // [−1, 1]² with a margin, on the canvas
  json.key("square").beginArray().number(at.x).number(at.y).number(at.width).endArray().endObject();
}

}  // namespace spineloft::app
