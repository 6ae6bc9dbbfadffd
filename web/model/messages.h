// Events of the contract, as the shell understands them.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/result.h"
#include "engine/document/document.h"
#include "engine/pipeline/part_shape.h"
#include "web/model/json.h"
#include "web/platform/host.h"

namespace spineloft::app {

/// failureSentence in the visitor's language.
std::string spokenFailure(const Failure& failure);

/// What a visitor should know of a relief that was made; empty: nothing.
std::string_view reliefWords(const relief::Relief& relief, const pipeline::PartShape& shape);

void sendError(platform::Host& host, std::string_view sentence);
void sendInfo(platform::Host& host, std::string_view sentence);
/// Nothing failed, and what was done may not be what was meant.
void sendHint(platform::Host& host, std::string_view sentence);
/// The same with a button that runs a command of the table with these arguments.
struct Offer {
  std::string_view sentence, label, command;
  Json args;
};
void sendOffer(platform::Host& host, const Offer& offer);
/// Nothing failed, but what was found wants a look.
void sendWarning(platform::Host& host, std::string_view sentence);
void sendPickPicture(platform::Host& host);
void sendCursor(platform::Host& host, std::string_view css);
void sendStatus(platform::Host& host, std::string_view text);

/// A text that the visitor types, in a dialog of the shell or, with `at`, in place; the answer comes with `id`.
struct Question {
  std::string_view id, title, text, value;
  std::optional<std::array<double, 4>> at = {};  ///< x, y, width, height, CSS pixels of the canvas
};
void sendQuestion(platform::Host& host, const Question& question);

/// A dialog of the shell: "help" or "find-command".
void sendShow(platform::Host& host, std::string_view dialog);

/// The page is to speak the language of this id; the shell loads it.
void sendLanguage(platform::Host& host, std::string_view id);

/// Pictures of the model that the shell makes and saves: "png" or "gif", with this name before the ending.
void sendTurntable(platform::Host& host, std::string_view what, std::string_view name);

/// One step of the document for the shell to keep.
struct JournalStep {
  std::string_view record;            ///< of engine/io/journal.h
  std::vector<std::uint64_t> photos;  ///< content hashes of the photos that it brings
  const document::Document& document;
};
void sendJournal(platform::Host& host, const JournalStep& step);
/// What the shell is asked to do with its models: "new-model", "open-model" …; `id` names one or is
/// empty.
void sendKeep(platform::Host& host, std::string_view what, std::string_view id = {});

}  // namespace spineloft::app
