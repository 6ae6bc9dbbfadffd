#include "engine/io/recipe_file.h"

#include <algorithm>
#include <exception>
#include <functional>
#include <utility>

#include "engine/document/action.h"
#include "engine/document/checks.h"
#include "engine/io/document_json.h"

namespace spineloft::io {
namespace {

using document::Document;
using document::Part;
using document::PictureEntry;

/// In larger recipes the value at fault is not searched for, members: it takes a reading for each.
constexpr std::size_t kMostSearched = 2000;

/// How many values of a recipe are at fault, and what is wrong with the first of them, where that is known.
struct Found {
  std::size_t faults = 0;
  std::vector<std::string> why;
};
using Faults = std::function<Found(const Json&)>;
using Place = std::vector<std::string>;  ///< keys, outermost first

Json::json_pointer pointerTo(const Place& place, std::size_t depth) {
  Json::json_pointer pointer;
  for (std::size_t i = 0; i < depth; ++i) pointer /= place[i];
  return pointer;
}

/// Members of objects, and elements of lists of objects, at any depth.
void collectPlaces(const Json& json, Place& here, std::vector<Place>& places) {
  const bool list = json.is_array() && std::ranges::any_of(json, &Json::is_object);
  if (!json.is_object() && !list) return;
  for (const auto& [key, value] : json.items()) {
    here.push_back(key);
    if (places.size() < kMostSearched) places.push_back(here);
    collectPlaces(value, here, places);
    here.pop_back();
  }
}

/// The innermost place without which fewer values are at fault, and what is wrong there; no place when there is none.
std::pair<Place, std::string> faultIn(const Json& whole, const Faults& faults) {
  const Found all = faults(whole);
  std::vector<Place> places;
  Place here;
  collectPlaces(whole, here, places);
  if (places.size() >= kMostSearched) places.clear();
  std::ranges::stable_sort(places, std::greater(), &Place::size);
  for (const Place& place : places) {
    Json without = whole;
    Json& around = without[pointerTo(place, place.size() - 1)];
    if (around.is_object()) {
      around.erase(place.back());
    } else {
      around.erase(static_cast<std::size_t>(std::stoul(place.back())));
    }
    const Found rest = faults(without);
    if (rest.faults >= all.faults) continue;
    const auto gone = std::ranges::mismatch(all.why, rest.why).in1;  // what is not said any more
    return {place, gone == all.why.end() ? std::string() : *gone};
  }
  return {Place(), all.why.empty() ? std::string() : all.why.front()};
}

constexpr const char* kNoPairs = "a line is one list x, y, x, y … of numbers, not of pairs";

/// Whether a list of three and more pairs of numbers, which no file of ours has, stands anywhere in it.
bool holdsPairs(const Json& json) {
  const auto isPair = [](const Json& one) {
    return one.is_array() && one.size() == 2 && one[0].is_number() && one[1].is_number();
  };
  if (json.is_array() && json.size() > 2 && std::ranges::all_of(json, isPair)) return true;
  return json.is_structured() && std::ranges::any_of(json, holdsPairs);
}

/// Says which value is at fault, and why: "recipe.profile.follow: follow must be 0 … 1".
Failure wrongValue(const Json& whole, const Faults& faults) {
  constexpr const char* kUnknown = " is damaged or out of range";
  const auto [place, why] = faultIn(whole, faults);
  if (place.empty()) return {Error::JsonInvalid, why.empty() ? std::string("a value") + kUnknown : why};
  std::string path;
  for (const std::string& key : place) path += (path.empty() ? "" : ".") + key;
  if (holdsPairs(whole[pointerTo(place, place.size())])) return {Error::JsonInvalid, path + ": " + kNoPairs};
  return {Error::JsonInvalid, path + (why.empty() ? kUnknown : ": " + why)};
}

/// The first key of what was left over, with the keys around it; empty when nothing was.
std::string firstKey(const Json& rest) {
  if (!rest.is_object()) return {};
  for (const auto& [key, value] : rest.items()) {
    if (key == kLengthKey) continue;
    const std::string inner = firstKey(value);
    return inner.empty() ? key : key + "." + inner;
  }
  return {};
}

/// Done where nothing was left over of what was read. Error: JsonInvalid, with the first key that is not known.
Status checkRest(const std::string& extra, const std::string& around = {}) {
  const std::string key = firstKey(Json::parse(extra, nullptr, false));
  if (key.empty()) return Done{};
  return {Error::JsonInvalid, "there is nothing named " + around + key};
}

/// The same of all that a document is made of.
Status checkRest(const Document& document) {
  Status status = checkRest(document.extra);
  const auto each = [&](const char* list, const auto& values) {
    for (std::size_t i = 0; i < values.size() && status; ++i)
      status = checkRest(values[i]->extra, list + ("." + std::to_string(i) + "."));
  };
  each("pictures", document.pictures);
  each("drawings", document.drawings);
  each("parts", document.parts);
  each("steps", document.steps);
  return status;
}

/// The name that a picture or a part gets when it is made.
void nameIfNone(Json& element, std::uint32_t id) {
  if (element.contains("name")) return;
  Part part;
  PictureEntry picture;
  part.id.value = picture.id.value = id;
  const bool isPart = element.contains("recipe");
  element["name"] = isPart ? document::fallbackName(part) : document::fallbackName(picture);
}

/// The last id of a list, where it is left out: the largest.
void completeLast(Json& json, const Json& list, const char* last) {
  std::uint32_t largest = 0;
  for (const Json& element : list) {
    std::uint32_t id = 0;
    if (element.is_object() && element.contains("id") && get(element["id"], id)) largest = std::max(largest, id);
  }
  if (!json.contains(last)) json[last] = std::min(largest, kMostId);
}

/// What people leave out of line drawings: the last ids, which are the largest.
void completeDrawings(Json& json) {
  const auto drawings = json.find("drawings");
  if (drawings == json.end() || !drawings->is_array()) return;
  completeLast(json, *drawings, "lastDrawingId");
  for (Json& drawing : *drawings) {
    if (drawing.is_object() && drawing.contains("lines")) completeLast(drawing, drawing["lines"], "lastLineId");
  }
}

Status checkPhoto(const RecipeInput& input, bool wanted) {
  if (wanted && !input.photo) {
    return {Error::JsonInvalid, "it stands on a photo, whose file must be named too"};
  }
  if (!wanted && input.photo) {
    return {Error::JsonInvalid, "it brings its own pictures and stands on no photo"};
  }
  return Done{};
}

/// A document with nothing but the photo, or without one a sheet of blank paper.
Document boardOf(const RecipeInput& input) {
  PictureEntry entry;
  entry.id = PictureId{1};
  if (input.photo) {
    entry.size = {input.photo->width, input.photo->height};
    entry.picture = input.photo;
    entry.contentHash = document::contentHash(*input.photo);
  } else {
    entry.size = document::AddSketch{}.size;
    entry.contentHash = document::contentHash(entry.size, {});
  }
  entry.name = document::tidyName(input.photoName, document::fallbackName(entry));
  Document board;
  board.name = entry.name;
  board.pictures.push_back(std::move(entry));
  board.lastPictureId = board.lastPartId = 1;
  return board;
}

/// The region of a puff or a flat piece, put on the photo.
Status checkOutline(const Document& board, Json& recipe) {
  if (!recipe["region"].is_object()) return Error::RegionEmpty;
  document::Region region;
  recipe["region"]["picture"] = 1;
  if (const auto lines = recipe["region"].find("contours"); lines != recipe["region"].end()) {
    const auto isLine = [](const Json& line) {
      std::vector<PicturePoint> points;
      return get(line, points);
    };
    if (holdsPairs(*lines)) return {Error::JsonInvalid, std::string("recipe.region.contours: ") + kNoPairs};
    if (!lines->is_array() || !std::ranges::all_of(*lines, isLine)) {
      return {Error::JsonInvalid, "recipe.region.contours is no list of lists x, y, x, y … of numbers"};
    }
  }
  Json copy = recipe["region"];
  ReadNotes notes;
  const PictureSource none;
  read(copy, region, Reading{notes, none});
  return document::checkRegion(board, region);
}

/// The planes of a part drawn slice by slice; what is no number is said later, with its key.
Status checkSlices(const Document& board, Json& recipe) {
  recipe["picture"] = 1;
  document::StackRecipe stack;
  Json copy = recipe;
  ReadNotes notes;
  const PictureSource none;
  read(copy, stack, Reading{notes, none});
  return notes.clean() ? document::checkStack(board, stack) : Status(Done{});
}

/// The outlines of a shape, all in its own picture; what is no number is said later, with its key.
Status checkOutlines(const Document& board, Json& recipe) {
  recipe["picture"] = 1;
  if (const auto outlines = recipe.find("outlines"); outlines != recipe.end() && outlines->is_array()) {
    for (Json& outline : *outlines) {
      if (outline.is_object()) outline["picture"] = 1;
    }
  }
  document::ShapeRecipe shape;
  Json copy = recipe;
  ReadNotes notes;
  const PictureSource none;
  read(copy, shape, Reading{notes, none});
  return notes.clean() ? document::checkShape(board, shape) : Status(Done{});
}

/// The line of a part: what is wrong with it is said as of a drawn one.
Status checkLine(const Document& board, const Json& recipe) {
  document::LoftRecipe line;
  line.picture = PictureId{1};
  if (!recipe.contains("stroke")) return Error::StrokeTooShort;
  if (!get(recipe["stroke"], line.stroke)) {
    return {Error::JsonInvalid, "recipe.stroke is no list x, y, x, y … of numbers"};
  }
  return document::checkStroke(board, line);
}

Result<Document> withPart(Json json, const RecipeInput& input) {
  if (!json.contains("recipe")) json = Json{{"recipe", std::move(json)}};
  const auto kind = json.find("kind");
  const auto is = [&](document::PartKind one) { return kind != json.end() && *kind == document::kindKey(one); };
  if (is(document::PartKind::Element)) {
    return {Error::JsonInvalid,
            "a piece of a line drawing needs its lines: give a whole document with parts and drawings"};
  }
  if (is(document::PartKind::Bridge)) {
    return {Error::JsonInvalid, "a bridge needs the parts that it joins: give a whole document"};
  }
  const bool isStack = is(document::PartKind::Stack), isShape = is(document::PartKind::Shape);
  const bool isRegion = kind != json.end() && !isStack && !isShape && !is(document::PartKind::Loft);
  // What says all about itself needs no photo.
  if (Status photo = checkPhoto(input, true); !photo && !isStack && !isShape) return photo.failure();
  Json& recipe = json["recipe"];
  if (!recipe.is_object()) return {Error::JsonInvalid, "recipe is no object"};
  json["id"] = 1;
  nameIfNone(json, 1);
  Document document = boardOf(input);
  if (isStack) {
    if (Status slices = checkSlices(document, recipe); !slices) return slices.failure();
  } else if (isShape) {
    if (Status outlines = checkOutlines(document, recipe); !outlines) return outlines.failure();
  } else if (isRegion) {
    if (Status outline = checkOutline(document, recipe); !outline) return outline.failure();
  } else {
    recipe["picture"] = 1;
    if (!input.stroke.empty()) recipe["stroke"] = toJson(input.stroke);
    if (Status line = checkLine(document, recipe); !line) return line.failure();
  }

  const PictureSource none;
  ReadNotes notes;
  Result<Part> part = partFrom(json, document, {notes, none});
  if (!part || !notes.clean()) {
    return wrongValue(json, [&](const Json& whole) {
      ReadNotes found;
      const bool sound = partFrom(whole, document, {found, none}).ok();
      return Found{found.dropped + found.repaired + (sound ? 0 : 1), found.why};
    });
  }
  if (Status rest = checkRest(part.value().extra); !rest) return rest.failure();
  document.parts.push_back(std::move(part).value());
  return document;
}

/// Gives a picture its photo, and its size where it says none.
void putPhoto(const image::Picture& photo, Json& picture) {
  picture["photo"] = hashKey(document::contentHash(photo));
  if (!picture.contains("size")) picture["size"] = toJson(image::Size{photo.width, photo.height});
}

/// Puts photos in the place of the ones that the pictures name. Error: JsonInvalid.
Status takePhoto(Json& pictures, const RecipeInput& input) {
  std::vector<Json*> photos;
  std::size_t taken = 0;
  for (Json& picture : pictures) {
    if (!picture.is_object()) continue;
    PictureId id;
    const bool known = picture.contains("id") && get(picture["id"], id);
    const auto own = std::ranges::find_if(input.pictures, [&](const auto& one) { return known && one.first == id; });
    if (own != input.pictures.end()) {
      putPhoto(*own->second, picture);
      ++taken;
    } else if (picture.contains("photo")) {
      photos.push_back(&picture);
    }
  }
  if (taken < input.pictures.size()) return {Error::JsonInvalid, "a photo was given for a picture that it has not"};
  if (Status photo = checkPhoto(input, !photos.empty()); !photo) return photo;
  for (Json* picture : photos) {
    const Json hash = hashKey(document::contentHash(*input.photo));
    Json& named = (*picture)["photo"];
    if (photos.size() > 1 && named != hash) {
      return {Error::JsonInvalid, "it stands on several photos; save it as a .spineloft file"};
    }
    putPhoto(*input.photo, *picture);
  }
  return Done{};
}

/// What people leave out of a list is filled in: names, and the last id, which is the largest.
void completeList(Json& json, const char* list, const char* last) {
  if (!json.contains(list)) return;
  for (Json& element : json[list]) {
    std::uint32_t id = 0;
    if (!element.is_object()) continue;
    if (element.contains("id")) get(element["id"], id);
    nameIfNone(element, id);
  }
  completeLast(json, json[list], last);
}

Result<Document> wholeDocument(Json json, const RecipeInput& input) {
  if (!input.stroke.empty()) {
    return {Error::JsonInvalid, "a whole document has lines of its own"};
  }
  if (!json.contains("version")) json["version"] = kProjectVersion;
  Json& pictures = json["pictures"];
  if (pictures.is_null()) pictures = Json::array();
  if (Status photo = takePhoto(pictures, input); !photo) return photo.failure();
  completeList(json, "pictures", "lastPictureId");
  completeDrawings(json);
  completeList(json, "parts", "lastPartId");
  if (json.contains("steps")) completeLast(json, json["steps"], "lastStepId");
  const PictureSource source = [&](std::uint64_t hash) {
    const auto own = std::ranges::find_if(input.pictures,
                                          [&](const auto& one) { return document::contentHash(*one.second) == hash; });
    return own != input.pictures.end() ? own->second : input.photo;
  };
  ReadNotes notes;
  Result<Document> document = documentFrom(json, {notes, source}, MissingPhoto::Drop);
  if (!document) {
    if (document.error() == Error::ProjectTooNew) return document;
    return {Error::JsonInvalid, document.failure().detail};
  }
  if (notes.clean()) {
    if (Status rest = checkRest(document.value()); !rest) return rest.failure();
    makeRoomForIds(document.value(), notes);
    return document;
  }
  return wrongValue(json, [&](const Json& whole) {
    ReadNotes found;
    const bool sound = documentFrom(whole, {found, source}, MissingPhoto::Drop).ok();
    return Found{sound ? found.dropped + found.repaired : std::size_t{1} << 20, found.why};
  });
}

}  // namespace

Result<Document> readRecipe(std::string_view json, const RecipeInput& input) {
  try {
    Result<Json> parsed = parseJson(json);
    if (!parsed) return {Error::JsonInvalid, parsed.failure().detail};
    Json recipe = std::move(parsed).value();
    if (!recipe.is_object()) return {Error::JsonInvalid, "it is no object"};
    return recipe.contains("parts") ? wholeDocument(std::move(recipe), input) : withPart(std::move(recipe), input);
  } catch (const std::exception&) {  // the JSON library and the standard one only throw for memory
    return Error::OutOfMemory;
  }
}

}  // namespace spineloft::io
