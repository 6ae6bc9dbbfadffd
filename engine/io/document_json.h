// The document as a JSON value, whole and in pieces. Internal to io/.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "engine/base/result.h"
#include "engine/document/document.h"
#include "engine/io/json_fields.h"
#include "engine/io/project_file.h"

namespace spineloft::io {

/// Longest JSON that is read, bytes: a thousand times an ordinary model.
inline constexpr std::size_t kMostJson = std::size_t{64} << 20;
/// Deepest nesting that is read.
inline constexpr int kMostDepth = 64;
/// Largest id that a document has: what a file says beyond it is not believed.
inline constexpr std::uint32_t kMostId = 2'000'000'000;
/// Largest id of a document that comes from outside, so that there are ids left for what is added later.
inline constexpr std::uint32_t kMostOpenedId = 1'000'000'000;

/// The JSON, checked for length and depth before it is parsed. Error: ProjectInvalid. Memory that runs
/// out is thrown as std::bad_alloc.
Result<Json> parseJson(std::string_view text);
/// As compact text; text that is not UTF-8 is mended.
std::string textOf(const Json& json);

/// The whole document with its version, as writeDocument has it.
Json documentJson(const document::Document& document);
/// Without pictures, parts and version: what the document itself says.
Json frameJson(const document::Document& document);

/// One step of migration: from the version of its place in the table (1 first) to the next.
using Migration = void (*)(Json& document);
/// One for each version before kProjectVersion.
std::span<const Migration> migrations();

/// What to do about a photo that is not there.
enum class MissingPhoto : std::uint8_t { Fail, Drop };

/// The document of documentJson, of any version up to ours. Errors: ProjectInvalid, ProjectTooNew,
/// NoSuchPicture (with MissingPhoto::Fail).
Result<document::Document> documentFrom(Json json, const Reading& reading, MissingPhoto missing);

/// Numbers everything anew where an id is above kMostOpenedId. For documents from outside: what the program itself
/// keeps goes on with the ids that it has.
void makeRoomForIds(document::Document& document, ReadNotes& notes);

/// Reads name, height, last ids and unknown keys into `document`.
void readFrame(Json json, document::Document& document, const Reading& reading);
/// A picture; none when it cannot be kept: NoSuchPicture when its photo is not there, ProjectInvalid
/// for all else. Its id may be 0.
Result<document::PictureEntry> pictureFrom(Json json, const Reading& reading);
/// A line drawing on one of `document`'s pictures. Its orders are looked at once its parts are there (mendOrders).
/// Errors: NoSuchPicture, ProjectInvalid (no usable line). Its id may be 0.
Result<document::Drawing> drawingFrom(Json json, const document::Document& document, const Reading& reading);
/// Orders of what is no piece of their drawing go, and so do drawings without a line.
void mendOrders(document::Document& document, ReadNotes& notes);
/// A part on one of `document`'s pictures. Errors: NoSuchPicture, ProjectInvalid (no usable stroke).
/// Its id may be 0.
Result<document::Part> partFrom(Json json, const document::Document& document, const Reading& reading);
/// A step; whether it fits into the forest is the caller's business (document::mendForest). Error:
/// ProjectInvalid (no sound step). Its id may be 0.
Result<document::Step> stepFrom(Json json, const Reading& reading);

}  // namespace spineloft::io
