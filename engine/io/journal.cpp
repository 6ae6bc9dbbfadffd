#include "engine/io/journal.h"

#include <algorithm>
#include <exception>
#include <optional>
#include <set>

#include "engine/base/hash.h"
#include "engine/document/checks.h"
#include "engine/io/document_json.h"
#include "engine/io/json_diff.h"

namespace spineloft::io {
namespace {

using document::Document;
using document::Part;
using document::PictureEntry;

/// Digits of the check sum that a record begins with.
constexpr std::size_t kCheckDigits = 16;

std::string checkOf(std::string_view text) { return hashKey(Hasher().text(text).value()); }

std::string sealed(const Json& record) {
  std::string text = textOf(record);
  return checkOf(text) + text;
}

template <class T>
const Box<T>* boxOf(const std::vector<Box<T>>& boxes, std::uint32_t id) {
  const auto at = std::ranges::find_if(boxes, [&](const T& value) { return value.id.value == id; });
  return at == boxes.end() ? nullptr : &*at;
}

template <class T>
Json idsOf(const std::vector<Box<T>>& boxes) {
  Json ids = Json::array();
  for (const T& value : boxes) ids.push_back(value.id.value);
  return ids;
}

// ---- writing: {"frame": change, "pictures": {"order": change, "of": {id: change}}, "parts": …} ----

/// Null when the lists are equal.
template <class T>
Json listChange(const std::vector<Box<T>>& before, const std::vector<Box<T>>& after) {
  Json change = Json::object();
  if (Json order = difference(idsOf(before), idsOf(after)); !order.is_null()) {
    change["order"] = std::move(order);
  }
  for (const Box<T>& box : after) {
    const Box<T>* old = boxOf(before, box->id.value);
    if (old != nullptr && *old == box) continue;
    const std::string key = std::to_string(box->id.value);
    change["of"][key] = difference(old == nullptr ? Json() : toJson(*old), toJson(box));
  }
  return change.empty() ? Json() : change;
}

Json changeOf(const Document& before, const Document& after) {
  Json change = Json::object();
  const auto add = [&](const char* key, Json part) {
    if (!part.is_null()) change[key] = std::move(part);
  };
  add("frame", difference(frameJson(before), frameJson(after)));
  add("pictures", listChange(before.pictures, after.pictures));
  add("drawings", listChange(before.drawings, after.drawings));
  add("parts", listChange(before.parts, after.parts));
  add("steps", listChange(before.steps, after.steps));
  return change;
}

// ---- playing ------------------------------------------------------------------------------------

const Json* memberOf(const Json& json, const char* key) {
  const auto at = json.find(key);
  return at == json.end() ? nullptr : &*at;
}

/// The list after a change; `make` reads one element. None when the change does not fit.
template <class T, class Make>
std::optional<std::vector<Box<T>>> changedList(const std::vector<Box<T>>& before, const Json& change,
                                               const Make& make) {
  if (!change.is_object()) return std::nullopt;
  Json ids = idsOf(before);
  if (const Json* order = memberOf(change, "order")) {
    if (!applyDifference(ids, *order)) return std::nullopt;
  }
  const Json none = Json::object();
  const Json* of = memberOf(change, "of");
  if (of == nullptr) of = &none;
  if (!of->is_object() || !ids.is_array()) return std::nullopt;
  std::vector<Box<T>> after;
  std::set<std::uint32_t> taken;
  for (const Json& idJson : ids) {
    std::uint32_t id = 0;
    if (!get(idJson, id) || !taken.insert(id).second) return std::nullopt;
    const Box<T>* old = boxOf(before, id);
    const Json* changed = memberOf(*of, std::to_string(id).c_str());
    if (changed == nullptr) {
      if (old == nullptr) return std::nullopt;
      after.push_back(*old);
      continue;
    }
    Json json = old == nullptr ? Json() : toJson(*old);
    if (!applyDifference(json, *changed)) return std::nullopt;
    Result<T> made = make(std::move(json));
    if (!made || made.value().id.value != id) return std::nullopt;
    after.push_back(std::move(made).value());
  }
  return after;
}

/// Whether a piece of a line drawing has its lines; other parts have.
bool isOnDrawing(const Document& document, const Part& part) {
  const document::ElementRecipe* element = document::elementOf(part);
  return element == nullptr || document::checkElement(document, *element).ok();
}

/// What a change could break without touching it: parts of pictures that went or changed their size, pieces of lines
/// that went, ids beyond the last ones.
bool isWhole(const Document& before, const Document& after) {
  if (after.pictures.size() > document::kMostPictures || after.parts.size() > document::kMostParts) {
    return false;
  }
  const auto known = [&](const document::Step& step) {
    return step.id.value != 0 && step.id.value <= after.lastStepId;
  };
  if (after.steps.size() > document::kMostSteps || after.lastStepId > kMostId ||
      !std::ranges::all_of(after.steps, known) || !document::isForest(after)) {
    return false;
  }
  for (const PictureEntry& entry : after.pictures) {
    const PictureEntry* old = document::findPicture(before, entry.id);
    if (old != nullptr && old->size != entry.size) return false;
    if (entry.id.value == 0 || entry.id.value > after.lastPictureId) return false;
  }
  for (const document::Drawing& drawing : after.drawings) {
    const bool counts = drawing.id.value != 0 && drawing.id.value <= after.lastDrawingId;
    if (!counts || !document::checkDrawing(after, drawing)) return false;
  }
  for (const document::Group& group : after.groups) {
    if (group.id.value == 0 || group.id.value > after.lastGroupId) return false;
    if (document::partsOfGroup(after, group.id).empty()) return false;
  }
  return after.lastDrawingId <= kMostId && after.lastPictureId <= kMostId && after.lastPartId <= kMostId &&
         after.lastGroupId <= kMostId && std::ranges::all_of(after.parts, [&](const Part& part) {
           return part.id.value != 0 && part.id.value <= after.lastPartId &&
                  (!part.group || document::findGroup(after, part.group) != nullptr) &&
                  document::findPicture(after, document::pictureOf(part)) != nullptr && isOnDrawing(after, part);
         });
}

/// None when the change is damaged or does not fit.
std::optional<Document> changed(const Document& before, const Json& change, const PictureSource& photos) {
  if (!change.is_object()) return std::nullopt;
  ReadNotes notes;
  const Reading reading{notes, photos};
  Document after = before;
  if (const Json* frame = memberOf(change, "frame")) {
    Json json = frameJson(before);
    if (!applyDifference(json, *frame)) return std::nullopt;
    after = {};
    readFrame(std::move(json), after, reading);
    after.pictures = before.pictures;
    after.drawings = before.drawings;
    after.parts = before.parts;
    after.steps = before.steps;
  }
  if (const Json* pictures = memberOf(change, "pictures")) {
    auto list =
        changedList(before.pictures, *pictures, [&](Json json) { return pictureFrom(std::move(json), reading); });
    if (!list) return std::nullopt;
    after.pictures = std::move(*list);
  }
  if (const Json* drawings = memberOf(change, "drawings")) {
    auto list = changedList(before.drawings, *drawings,
                            [&](Json json) { return drawingFrom(std::move(json), after, reading); });
    if (!list) return std::nullopt;
    after.drawings = std::move(*list);
  }
  if (const Json* parts = memberOf(change, "parts")) {
    auto list = changedList(before.parts, *parts, [&](Json json) { return partFrom(std::move(json), after, reading); });
    if (!list) return std::nullopt;
    after.parts = std::move(*list);
  }
  if (const Json* steps = memberOf(change, "steps")) {
    auto list = changedList(before.steps, *steps, [&](Json json) { return stepFrom(std::move(json), reading); });
    if (!list) return std::nullopt;
    after.steps = std::move(*list);
  }
  if (!notes.clean() || !isWhole(before, after)) return std::nullopt;
  return after;
}

/// False when the record is damaged or does not fit; then the history is as it was.
bool play(DocumentHistory& history, std::string_view record, const PictureSource& photos) {
  if (record.size() <= kCheckDigits) return false;
  const std::string_view text = record.substr(kCheckDigits);
  if (checkOf(text) != record.substr(0, kCheckDigits)) return false;
  const Result<Json> json = parseJson(text);
  if (!json || !json.value().is_object()) return false;
  if (json.value().contains("undo")) return history.undo().ok();
  if (json.value().contains("redo")) return history.redo().ok();
  for (const char* kind : {"commit", "amend"}) {
    const Json* change = memberOf(json.value(), kind);
    if (change == nullptr) continue;
    std::optional<Document> next = changed(history.present(), *change, photos);
    if (!next) return false;
    if (kind == std::string_view("commit")) {
      history.commit(std::move(*next));
    } else {
      history.amend(std::move(*next));
    }
    return true;
  }
  return false;
}

/// Documents that follow one another from `present` on, as `changes` say, until one does not fit.
std::vector<Document> follow(const Document& present, const Json* changes, const PictureSource& photos) {
  std::vector<Document> documents;
  if (changes == nullptr || !changes->is_array()) return documents;
  const Document* before = &present;
  documents.reserve(changes->size());
  for (const Json& change : *changes) {
    std::optional<Document> next = changed(*before, change, photos);
    if (!next) break;
    documents.push_back(std::move(*next));
    before = &documents.back();
  }
  return documents;
}

Result<DocumentHistory> readBase(std::string_view base, const PictureSource& photos) {
  Result<Json> parsed = parseJson(base);
  if (!parsed) return parsed.failure();
  Json& json = parsed.value();
  if (!json.is_object() || !json.contains("present")) return {Error::ProjectInvalid, "no history"};
  ReadNotes notes;
  Result<Document> present = documentFrom(std::move(json["present"]), {notes, photos}, MissingPhoto::Fail);
  if (!present) return present.failure();
  std::vector<Document> past = follow(present.value(), memberOf(json, "past"), photos);
  std::vector<Document> future = follow(present.value(), memberOf(json, "future"), photos);
  // The oldest first, up to the last; then back to the present.
  past.insert(past.begin(), std::move(present).value());
  DocumentHistory history(std::move(past.back()));
  for (past.pop_back(); !past.empty(); past.pop_back()) history.commit(std::move(past.back()));
  std::size_t ahead = 0;
  for (Document& document : future) {
    if (history.commit(std::move(document)) == document::Committed::Step) ++ahead;
  }
  while (ahead > 0 && history.undo().ok()) --ahead;
  return history;
}

}  // namespace

std::string writeHistory(const DocumentHistory& history) {
  Json past = Json::array(), future = Json::array();
  const std::size_t present = history.undoSteps(), last = present + history.redoSteps();
  for (std::size_t i = present; i > 0; --i) {
    past.push_back(changeOf(history.at(i), history.at(i - 1)));
  }
  for (std::size_t i = present; i < last; ++i) {
    future.push_back(changeOf(history.at(i), history.at(i + 1)));
  }
  Json json{{"present", documentJson(history.present())}};
  if (!past.empty()) json["past"] = std::move(past);
  if (!future.empty()) json["future"] = std::move(future);
  return textOf(json);
}

std::string commitRecord(const Document& before, const Document& after) {
  return sealed({{"commit", changeOf(before, after)}});
}
std::string amendRecord(const Document& before, const Document& after) {
  return sealed({{"amend", changeOf(before, after)}});
}
std::string undoRecord() { return sealed({{"undo", true}}); }
std::string redoRecord() { return sealed({{"redo", true}}); }

Result<ReadHistory> readHistory(std::string_view base, std::span<const std::string> records,
                                const PictureSource& pictures) {
  try {
    Result<DocumentHistory> history = readBase(base, pictures);
    if (!history) return history.failure();
    ReadHistory read{std::move(history).value(), records.size()};
    for (const std::string& record : records) {
      if (!play(read.history, record, pictures)) break;
      --read.dropped;
    }
    return read;
  } catch (const std::exception&) {  // the JSON library and the standard one only throw for memory
    return Error::OutOfMemory;
  }
}

std::vector<std::uint64_t> photosOf(const DocumentHistory& history) {
  std::vector<std::uint64_t> hashes;
  for (std::size_t i = 0; i <= history.undoSteps() + history.redoSteps(); ++i) {
    for (const PictureEntry& entry : history.at(i).pictures) {
      if (!entry.isSketch() && std::ranges::count(hashes, entry.contentHash) == 0) {
        hashes.push_back(entry.contentHash);
      }
    }
  }
  return hashes;
}

}  // namespace spineloft::io
