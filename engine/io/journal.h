// The history of a document as text: a base and one record a step, so that saving a step costs what
// changed, and playing the records again gives the same document and the same undo and redo.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/result.h"
#include "engine/document/document.h"
#include "engine/document/history.h"
#include "engine/io/project_file.h"

namespace spineloft::io {

using DocumentHistory = document::History<document::Document>;

/// The whole history: what a journal starts from, and starts from again when it has grown long.
std::string writeHistory(const DocumentHistory& history);

/// A record of one commit: only what differs between the two documents.
std::string commitRecord(const document::Document& before, const document::Document& after);
/// The same of History::amend (a commit that became part of the step before, Committed::Amended).
std::string amendRecord(const document::Document& before, const document::Document& after);
/// Records of an undo and a redo.
std::string undoRecord();
std::string redoRecord();

/// A history read back.
struct ReadHistory {
  DocumentHistory history;
  std::size_t dropped = 0;  ///< records at the end that were damaged or did not fit, left out
};
/// Plays `records` over `base` (of writeHistory). A record that is damaged, does not fit or shows a photo
/// that `pictures` does not have ends the play: what came before it is kept. Steps of the base that are
/// damaged only shorten its undo and redo. Errors: ProjectInvalid (the base is damaged), ProjectTooNew,
/// NoSuchPicture (a photo of the base's present is not there), OutOfMemory.
Result<ReadHistory> readHistory(std::string_view base, std::span<const std::string> records,
                                const PictureSource& pictures);

/// Content hashes of all photos (not of sketches) that any document of the history shows, each once, in order.
std::vector<std::uint64_t> photosOf(const DocumentHistory& history);

}  // namespace spineloft::io
