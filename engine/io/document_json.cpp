#include "engine/io/document_json.h"

#include <algorithm>
#include <cctype>
#include <new>
#include <set>

#include "engine/base/text.h"
#include "engine/document/checks.h"
#include "engine/document/params.h"
#include "engine/document/pieces.h"
#include "engine/document/renumber.h"

namespace spineloft::io {
namespace {

using document::Document;
using document::Part;
using document::PictureEntry;

constexpr const char* kVersionKey = "version";

/// Version 2 brought puffs and flat pieces; what version 1 wrote means the same.
void fromVersion1(Json&) {}

static_assert(kProjectVersion == 2, "a new version needs its migration here, and a golden file");
constexpr std::array<Migration, kProjectVersion - 1> kMigrations{fromVersion1};

/// Whether brackets outside strings nest at most kMostDepth deep; the rest is the parser's business.
bool isShallow(std::string_view text) {
  int depth = 0;
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quoted) {
      if (c == '\\') ++i;
      if (c == '"') quoted = false;
    } else if (c == '"') {
      quoted = true;
    } else if (c == '[' || c == '{') {
      if (++depth > kMostDepth) return false;
    } else if (c == ']' || c == '}') {
      --depth;
    }
  }
  return true;
}

/// Sets `value` to `sound` and counts it, unless it is right.
template <class T>
void mend(bool right, T& value, T sound, ReadNotes& notes) {
  if (right) return;
  value = std::move(sound);
  ++notes.repaired;
}

/// Says what is wrong and what to do: "That outline is too small to make a part of: draw a larger one …".
void tell(const Failure& failure, ReadNotes& notes) {
  std::string words = failure.detail.empty() ? std::string(errorSentence(failure.error)) : failure.detail;
  if (words.ends_with('.')) words.pop_back();
  for (std::size_t at = words.find(". "); at != std::string::npos; at = words.find(". ")) {
    words[at] = ':';
    words[at + 2] = static_cast<char>(std::tolower(static_cast<unsigned char>(words[at + 2])));
  }
  notes.say(std::move(words));
}
/// The same, with what is wrong.
template <class T>
void mend(const Status& right, T& value, T sound, ReadNotes& notes) {
  if (!right) tell(right.failure(), notes);
  mend(right.ok(), value, std::move(sound), notes);
}

/// Takes out what is not right, and what is too much; counts each.
template <class T, class Right>
void weed(std::vector<T>& values, std::size_t most, const Right& right, ReadNotes& notes) {
  notes.repaired += std::erase_if(values, [&](const T& value) { return !right(value); });
  if (values.size() <= most) return;
  notes.repaired += values.size() - most;
  values.resize(most);
}

void mendMarks(std::vector<ribs::IgnoreMark>& marks, ReadNotes& notes) {
  weed(marks, ribs::kMostIgnoreMarks, [](const ribs::IgnoreMark& mark) { return document::isValid(mark); }, notes);
}

void mendPulls(std::vector<pull::Pull>& pulls, ReadNotes& notes) {
  for (const pull::Pull& pull : pulls) {
    if (const Status right = pull::checkPulls({pull}); !right) tell(right.failure(), notes);
  }
  weed(pulls, pull::kMostPulls, [](const pull::Pull& pull) { return pull::checkPulls({pull}).ok(); }, notes);
}

void mendEdits(ribs::RibEdits& edits, ReadNotes& notes) {
  const auto share = [](double at) { return at >= 0 && at <= 1; };
  weed(
      edits.ends, ribs::kMostEndEdits,
      [](const ribs::EndEdit& end) { return ribs::isValid(ribs::RibEdits{.ends = {end}}); }, notes);
  weed(edits.added, ribs::kMostAddedRibs, share, notes);
  weed(edits.removed, ribs::kMostAddedRibs, share, notes);
  mend(ribs::isValid(ribs::RibEdits{.startFan = edits.startFan}), edits.startFan, {}, notes);
  mend(ribs::isValid(ribs::RibEdits{.endFan = edits.endFan}), edits.endFan, {}, notes);
  mend(ribs::isValid(edits), edits, {}, notes);
}

void mendLoft(loft::LoftParams& params, ReadNotes& notes) {
  using loft::kMostTilt, loft::kMostTwist, geometry::isValid;
  mend(isValid(params.twist, -kMostTwist, kMostTwist), params.twist, {}, notes);
  mend(isValid(params.squash, loft::kLeastSquash, loft::kMostSquash), params.squash, {}, notes);
  mend(isValid(params.tilt, -kMostTilt, kMostTilt), params.tilt, {}, notes);
  mend(isValid(params.bulge, -1, 1), params.bulge, {}, notes);
  mend(params.centring >= 0 && params.centring <= 10, params.centring, loft::LoftParams{}.centring, notes);
  weed(
      params.sections, loft::kMostSectionKeys,
      [](const loft::SectionKey& key) { return loft::checkSectionKeys({&key, 1}).ok(); }, notes);
  mend(loft::checkSectionKeys(params.sections).ok(), params.sections, loft::LoftParams{}.sections, notes);
  mend(loft::checkParams(params).ok(), params, {}, notes);
}

void mendRecipe(document::LoftRecipe& recipe, ReadNotes& notes) {
  const document::LoftRecipe standard;
  const double spacing = recipe.spine.minSpacing;
  mend(spacing >= 0.1 && spacing <= 100, recipe.spine.minSpacing, standard.spine.minSpacing, notes);
  mend(ribs::inRange(recipe.ribs), recipe.ribs, {}, notes);
  mendEdits(recipe.edits, notes);
  mendMarks(recipe.ignored, notes);
  mend(loft::isValid(recipe.pose), recipe.pose, {}, notes);
  mendLoft(recipe.loft, notes);
}
void mendRecipe(document::InflateRecipe& recipe, ReadNotes& notes) {
  mend(checkParams(recipe.inflate), recipe.inflate, {}, notes);
  mend(document::checkSolid(recipe.inflate), recipe.inflate.profile, {}, notes);
}
void mendRecipe(document::ExtrudeRecipe& recipe, ReadNotes& notes) {
  mend(isValid(recipe.extrude), recipe.extrude, {}, notes);
}
void mendRecipe(document::LatheRecipe& recipe, ReadNotes& notes) {
  mend(isValid(recipe.lathe), recipe.lathe, {}, notes);
}

void mendRecipe(document::StackRecipe& recipe, ReadNotes& notes) {
  mend(isValid(recipe.stack), recipe.stack, {}, notes);
  mend(isValid(recipe.rail), recipe.rail, {}, notes);
  for (stack::Plane& plane : recipe.planes) {
    mend(sections::isValid(plane.blend), plane.blend, stack::Plane{}.blend, notes);
    weed(plane.curves, stack::kMostCurves, [](const stack::Curve& curve) { return isValid(curve); }, notes);
  }
  weed(recipe.planes, stack::kMostPlanes, [](const stack::Plane& plane) { return isValid(plane); }, notes);
  for (std::size_t i = 0; i < recipe.planes.size(); ++i) {
    mend(checkLinks(recipe.planes, recipe.rail.closed, i), recipe.planes[i].links, {}, notes);
  }
  mend(checkPatterns(recipe.planes, recipe.stack.patterns), recipe.stack.patterns, {}, notes);
}

void mendRecipe(document::ShapeRecipe& recipe, ReadNotes& notes) {
  std::optional<sections::SectionShape>& section = recipe.shape.section;
  mend(!section || sections::checkShape(*section).ok(), section, {}, notes);
  mend(recipe.outlines.size() <= document::kMostOutlines, recipe.outlines, {}, notes);
  mend(isValid(recipe.shape), recipe.shape, {}, notes);
}

// All of these is in the table, or is checked.
void mendRecipe(document::ElementRecipe&, ReadNotes&) {}
void mendRecipe(document::BridgeRecipe&, ReadNotes&) {}

void mendRecipe(document::Recipe& recipe, ReadNotes& notes) {
  const document::PartKind kind = document::kindOf(recipe);
  const document::Recipe standard = document::emptyRecipe(kind);
  for (const document::ParamInfo& info : document::paramTable(kind)) {
    const double value = info.get(recipe);
    if (value >= info.low && value <= info.high) continue;
    tell({Error::ValueOutOfRange, "it must be " + shortNumber(info.low) + " … " + shortNumber(info.high)}, notes);
    info.set(recipe, info.get(standard));
    ++notes.repaired;
  }
  std::visit([&](auto& one) { mendRecipe(one, notes); }, recipe);
}

void mendName(std::string& name, std::string_view fallback, ReadNotes& notes) {
  const std::string tidy = document::tidyName(name, fallback);
  mend(tidy == name, name, tidy, notes);
}

/// Ids that are 0, too large or taken get new ones: above all others, or free ones where the largest is taken.
template <class T>
void mendIds(std::vector<Box<T>>& boxes, std::uint32_t& last, ReadNotes& notes) {
  if (last > kMostId) {
    last = 0;
    ++notes.repaired;
  }
  std::set<std::uint32_t> taken;
  std::vector<Box<T>*> renewed;
  for (Box<T>& box : boxes) {
    const std::uint32_t id = box->id.value;
    if (id == 0 || id > kMostId || !taken.insert(id).second) renewed.push_back(&box);
  }
  if (!taken.empty() && *taken.rbegin() > last) {
    last = *taken.rbegin();
    ++notes.repaired;
  }
  std::uint32_t next = last;
  for (Box<T>* box : renewed) {
    do next = next < kMostId ? next + 1 : 1;
    while (!taken.insert(next).second);
    T value = box->get();
    value.id.value = next;
    last = std::max(last, next);
    *box = std::move(value);
    ++notes.repaired;
  }
}

/// A view of what cannot be seen from a side goes.
void mendViews(Document& document, ReadNotes& notes) {
  for (Box<PictureEntry>& box : document.pictures) {
    if (!box->view || document::checkView(document, box->id, *box->view).ok()) continue;
    PictureEntry entry = box;
    entry.view.reset();
    box = std::move(entry);
    ++notes.repaired;
  }
}

/// Groups without a part go; a part of a group that is not there stands alone.
void mendGroups(Document& document, ReadNotes& notes) {
  std::set<std::uint32_t> known;
  weed(
      document.groups, document::kMostParts,
      [&](const document::Group& group) {
        const std::uint32_t id = group.id.value;
        return id != 0 && id <= kMostId && !document::partsOfGroup(document, group.id).empty() &&
               known.insert(id).second;
      },
      notes);
  for (document::Group& group : document.groups) {
    mendName(group.name, document::fallbackName(group), notes);
  }
  for (Box<Part>& box : document.parts) {
    if (!box->group || known.contains(box->group.value)) continue;
    Part part = box;
    part.group = {};
    box = std::move(part);
    ++notes.repaired;
  }
  mend(document.lastGroupId <= kMostId, document.lastGroupId, 0u, notes);
  const std::uint32_t most = known.empty() ? 0 : *known.rbegin();
  mend(most <= document.lastGroupId, document.lastGroupId, most, notes);
}

Status migrate(Json& json) {
  const auto at = json.find(kVersionKey);
  int version = 0;
  if (at == json.end() || !get(*at, version) || version < 1) {
    return {Error::ProjectInvalid, "no version"};
  }
  if (version > kProjectVersion) return Error::ProjectTooNew;
  json.erase(at);
  for (const Migration step : migrations().subspan(static_cast<std::size_t>(version) - 1)) step(json);
  return Done{};
}

/// The objects in the list under `key`, at most so many, taken out of the document.
Json::array_t takeList(Json& json, const char* key, std::size_t most, ReadNotes& notes) {
  const auto at = json.find(key);
  if (at == json.end()) return {};
  Json value = std::move(*at);
  json.erase(at);
  if (!value.is_array()) {
    ++notes.repaired;
    return {};
  }
  auto list = std::move(value.get_ref<Json::array_t&>());
  const std::size_t all = list.size();
  std::erase_if(list, [](const Json& element) { return !element.is_object(); });
  if (list.size() > most) list.resize(most);
  notes.dropped += all - list.size();
  return list;
}

}  // namespace

Result<Json> parseJson(std::string_view text) {
  if (text.size() > kMostJson) return {Error::ProjectInvalid, "too long"};
  if (!isShallow(text)) return {Error::ProjectInvalid, "too deep"};
  Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded()) return {Error::ProjectInvalid, "not JSON"};
  return json;
}

std::string textOf(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

std::span<const Migration> migrations() { return kMigrations; }

Json documentJson(const Document& document) {
  Json json = toJson(document);
  json[kVersionKey] = kProjectVersion;
  return json;
}

Json frameJson(const Document& document) {
  Json plain = Json::object(), json = Json::object();
  WriteMembers writePlain(plain, nullptr);
  const Document standard;
  members(writePlain, standard);
  WriteMembers write(json, &plain);
  write.withElements = false;
  members(write, document);
  return json;
}

void readFrame(Json json, Document& document, const Reading& reading) {
  read(json, document, reading);
  mendName(document.name, document::kFallbackDocumentName, reading.notes);
  const double height = document.height.value;
  mend(height >= document::kMinHeightMm && height <= document::kMaxHeightMm, document.height, Document{}.height,
       reading.notes);
}

Result<PictureEntry> pictureFrom(Json json, const Reading& reading) {
  PictureEntry entry;
  const bool isPhoto = json.is_object() && json.contains("photo");
  read(json, entry, reading);
  if (isPhoto) {
    if (!entry.picture) return {Error::NoSuchPicture, entry.name};
    const image::Size size{entry.picture->width, entry.picture->height};
    mend(entry.size == size, entry.size, size, reading.notes);
    mend(entry.sketch.empty(), entry.sketch, {}, reading.notes);
  } else {
    const auto fits = [](int side) { return side >= image::kLeastSketchSide && side <= image::kMostSketchSide; };
    if (!fits(entry.size.width) || !fits(entry.size.height)) {
      return {Error::ProjectInvalid, "paper size"};
    }
    weed(
        entry.sketch, image::kMostSketchStrokes,
        [](const Box<image::SketchStroke>& stroke) { return image::isValid(*stroke); }, reading.notes);
    entry.contentHash = document::contentHash(entry.size, entry.sketch);
  }
  mendName(entry.name, document::fallbackName(entry), reading.notes);
  mendMarks(entry.ignored, reading.notes);
  return entry;
}

/// What a file says beyond what we know of a list has no place any more where mending shortened the list:
/// `value`, written as `json`, keeps what would be read again.
template <class T>
void settleExtra(T& value, Json json, const Reading& reading) {
  if (value.extra.empty()) return;
  T again;
  ReadNotes counted;
  read(json, again, {counted, reading.photos});
  mend(again.extra == value.extra, value.extra, again.extra, reading.notes);
}

Result<document::Drawing> drawingFrom(Json json, const Document& document, const Reading& reading) {
  document::Drawing drawing;
  read(json, drawing, reading);
  const PictureEntry* entry = document::findPicture(document, drawing.picture);
  if (entry == nullptr) return Error::NoSuchPicture;
  const ReadNotes before = reading.notes;
  std::set<LineId> known;
  weed(
      drawing.lines, descriptive::kMostLines,
      [&](const document::DrawnLine& line) {
        return line.id.value != 0 && line.id.value <= kMostId && document::isValid(line, entry->size) &&
               known.insert(line.id).second;
      },
      reading.notes);
  const std::uint32_t most = known.empty() ? 0 : known.rbegin()->value;
  const bool counts = most <= drawing.lastLineId && drawing.lastLineId <= kMostId;
  mend(counts, drawing.lastLineId, most, reading.notes);
  const auto isPlace = [&](LineId line, double at) {
    return document::findLine(drawing, line) != nullptr && at >= 0 && at <= 1;
  };
  const auto isPin = [&](const document::DepthPin& pin) {
    return isPlace(pin.line, pin.at) && document::isDepth(pin.z);
  };
  const auto isFold = [&](const document::LineFold& fold) { return isPlace(fold.line, fold.at); };
  weed(drawing.pins, document::kMostMarks, isPin, reading.notes);
  weed(drawing.folds, document::kMostMarks, isFold, reading.notes);
  weed(
      drawing.orders, document::kMostMarks,
      [](const document::PieceOrder& order) { return order.over != order.under && isFinite(order.at); }, reading.notes);
  if (reading.notes != before) settleExtra(drawing, toJson(drawing), reading);
  if (!document::checkLines(document, drawing)) return {Error::ProjectInvalid, "lines"};
  return drawing;
}

/// A bridge whose part is not there stands on none, so that a later part with that id is not taken for it.
void forgetHosts(Document& document) {
  for (Box<Part>& box : document.parts) {
    if (document::bridgeOf(*box) == nullptr) continue;
    Part part = box;
    for (document::BridgeEnd* end : {&document::bridgeOf(part)->from, &document::bridgeOf(part)->to}) {
      if (document::findPart(document, end->part) == nullptr) end->part = {};
    }
    if (!(part == *box)) box = std::move(part);
  }
}

void mendOrders(Document& document, ReadNotes& notes) {
  for (Box<document::Drawing>& box : document.drawings) {
    document::Drawing drawing = box;
    const auto isPiece = [&](PartId id) {
      const Part* part = document::findPart(document, id);
      const document::ElementRecipe* element = part == nullptr ? nullptr : document::elementOf(*part);
      return element != nullptr && element->drawing == drawing.id;
    };
    const std::size_t gone = std::erase_if(drawing.orders, [&](const document::PieceOrder& order) {
      return !isPiece(order.over) || !isPiece(order.under);
    });
    if (gone > 0) box = std::move(drawing);
    notes.repaired += gone;
  }
  notes.dropped +=
      std::erase_if(document.drawings, [](const document::Drawing& drawing) { return drawing.lines.empty(); });
}

Result<Part> partFrom(Json json, const Document& document, const Reading& reading) {
  Part part;
  read(json, part, reading);
  const ReadNotes before = reading.notes;
  mendName(part.name, document::fallbackName(part), reading.notes);
  mendRecipe(part.recipe, reading.notes);
  reading.notes.repaired += document::dropUnseen(document, part);
  if (auto* side = document::sideOf(part.recipe)) {
    mend(document::checkSide(document, part.recipe), *side, {}, reading.notes);
  }
  const bool follows = document::bridgeOf(part) != nullptr && !part.placement.isRest();
  mend(!follows && document::isValid(part.placement), part.placement, {}, reading.notes);
  mendPulls(part.pulls, reading.notes);
  mend(part.relief ? relief::checkRelief(*part.relief) : Done{}, part.relief, {}, reading.notes);
  mend(!part.mirror || document::isValid(*part.mirror), part.mirror, {}, reading.notes);
  if (reading.notes != before) settleExtra(part, toJson(part), reading);
  const Status stroke = document::checkDrawn(document, part.recipe);
  if (stroke) return part;
  tell(stroke.failure(), reading.notes);
  if (stroke.error() == Error::NoSuchPicture) return {Error::NoSuchPicture, part.name};
  return {Error::ProjectInvalid, part.name};
}

Result<document::Step> stepFrom(Json json, const Reading& reading) {
  document::Step step;
  const document::Step standard;
  read(json, step, reading);
  mendName(step.name, document::fallbackName(step), reading.notes);
  mend(step.blend >= 0 && step.blend <= document::kMostBlend, step.blend, 0.0, reading.notes);
  mend(step.wall >= document::kLeastWall && step.wall <= document::kMostWall, step.wall, standard.wall, reading.notes);
  mend(step.opening.depth >= 0 && step.opening.depth <= document::kMostOpening, step.opening.depth, 0.0, reading.notes);
  if (!document::checkStep(step)) return {Error::ProjectInvalid, step.name};
  return step;
}

void makeRoomForIds(Document& document, ReadNotes& notes) {
  const auto lasts = {document.lastPictureId, document.lastPartId, document.lastStepId, document.lastGroupId,
                      document.lastDrawingId};
  if (std::ranges::max(lasts) <= kMostOpenedId) return;
  document::renumber(document);
  ++notes.repaired;
}

Result<Document> documentFrom(Json json, const Reading& reading, MissingPhoto missing) {
  if (!json.is_object()) return {Error::ProjectInvalid, "no document"};
  if (Status version = migrate(json); !version) return version.failure();
  auto pictures = takeList(json, "pictures", document::kMostPictures, reading.notes);
  auto drawings = takeList(json, "drawings", document::kMostDrawings, reading.notes);
  auto parts = takeList(json, "parts", document::kMostParts, reading.notes);
  auto steps = takeList(json, "steps", document::kMostSteps, reading.notes);
  Document document;
  readFrame(std::move(json), document, reading);
  for (Json& picture : pictures) {
    Result<PictureEntry> entry = pictureFrom(std::move(picture), reading);
    if (!entry && entry.error() == Error::NoSuchPicture && missing == MissingPhoto::Fail) {
      return entry.failure();
    }
    if (entry) {
      document.pictures.push_back(std::move(entry).value());
    } else {
      ++reading.notes.dropped;
    }
  }
  mendIds(document.pictures, document.lastPictureId, reading.notes);
  mendViews(document, reading.notes);
  for (Json& element : drawings) {
    Result<document::Drawing> drawing = drawingFrom(std::move(element), document, reading);
    if (drawing) {
      document.drawings.push_back(std::move(drawing).value());
    } else {
      ++reading.notes.dropped;
    }
  }
  mendIds(document.drawings, document.lastDrawingId, reading.notes);
  for (Json& element : parts) {
    Result<Part> part = partFrom(std::move(element), document, reading);
    if (part) {
      document.parts.push_back(std::move(part).value());
    } else {
      ++reading.notes.dropped;
    }
  }
  mendIds(document.parts, document.lastPartId, reading.notes);
  forgetHosts(document);
  mendOrders(document, reading.notes);
  const ReadNotes before = reading.notes;
  mendGroups(document, reading.notes);
  if (reading.notes != before) settleExtra(document, frameJson(document), reading);
  for (Json& element : steps) {
    Result<document::Step> step = stepFrom(std::move(element), reading);
    if (step) {
      document.steps.push_back(std::move(step).value());
    } else {
      ++reading.notes.dropped;
    }
  }
  mendIds(document.steps, document.lastStepId, reading.notes);
  reading.notes.repaired += document::mendForest(document);
  return document;
}

std::string writeDocument(const Document& document) { return textOf(documentJson(document)); }

Result<Document> readDocument(std::string_view json, const PictureSource& pictures, ReadNotes* notes) {
  ReadNotes found;
  try {
    Result<Json> parsed = parseJson(json);
    if (!parsed) return parsed.failure();
    Result<Document> document = documentFrom(std::move(parsed).value(), {found, pictures}, MissingPhoto::Fail);
    if (document) makeRoomForIds(document.value(), found);
    if (notes != nullptr) *notes = found;
    return document;
  } catch (const std::exception&) {  // the JSON library and the standard one only throw for memory
    return Error::OutOfMemory;
  }
}

}  // namespace spineloft::io
