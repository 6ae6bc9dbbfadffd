#include "web/model/session.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "engine/document/update.h"
#include "engine/io/journal.h"
#include "web/model/messages.h"
#include "web/model/what_changed.h"
#include "web/words/words.h"

namespace spineloft::app {
namespace {

constexpr double kBurstMs = 1000;  // between two keys that belong together
/// A burst that goes on is told this often: with what the shell may take to write it
/// (web/shell/keep/journal_writer.ts), a step is on the disk or said to be late within 100 ms.
constexpr double kAmendMs = 40;

/// Content hashes of the photos that `after` shows and `before` does not.
std::vector<std::uint64_t> newPhotos(const document::Document& before, const document::Document& after) {
  std::vector<std::uint64_t> hashes;
  for (const document::PictureEntry& entry : after.pictures) {
    const bool known = std::ranges::any_of(before.pictures, [&](const document::PictureEntry& old) {
      return !old.isSketch() && old.contentHash == entry.contentHash;
    });
    if (!entry.isSketch() && !known) hashes.push_back(entry.contentHash);
  }
  return hashes;
}

/// What a step did, in the status line; what a command says itself comes after it, in its place.
void say(platform::Host& host, const char* sentence, const document::Document& before,
         const document::Document& after) {
  const std::string what = whatChanged(before, after);
  if (!what.empty()) sendStatus(host, words::tr(sentence, {{"what", what}}));
}

}  // namespace

Status Session::act(std::span<const document::Action> actions, std::string_view burst) {
  document::Document next = document();
  for (const document::Action& action : actions) {
    Result<document::Document> result = document::update(next, action);
    if (!result) return result.failure();
    next = std::move(result).value();
  }
  const double now = host_.nowMs();
  const bool goesOn = !burst.empty() && burst == burst_ && now - burstMs_ < kBurstMs;
  if (!goesOn) ++gesture_;
  burst_ = burst;
  burstMs_ = now;
  const document::Document before = document();
  tell(history_.commit(std::move(next), burst.empty() ? 0 : gesture_), before);
  say(host_, "Done: {what}.", before, document());
  return Done{};
}

Status Session::undo() {
  sendAmends(true);
  const document::Document before = document();
  Status status = history_.undo();
  if (!status) return status;
  sendRecord(io::undoRecord(), document());
  say(host_, "Undone: {what}.", document(), before);
  return status;
}

Status Session::redo() {
  sendAmends(true);
  const document::Document before = document();
  Status status = history_.redo();
  if (!status) return status;
  sendRecord(io::redoRecord(), document());
  say(host_, "Done again: {what}.", before, document());
  return status;
}

void Session::clear() {
  document::Document empty;
  empty.lastPictureId = document().lastPictureId;
  empty.lastPartId = document().lastPartId;
  empty.lastStepId = document().lastStepId;
  const document::Document before = document();
  tell(history_.commit(std::move(empty)), before);
  say(host_, "Done: {what}.", before, document());
}

void Session::open(document::History<document::Document> history) {
  sendAmends(true);
  history_ = std::move(history);
}

void Session::tell(document::Committed committed, const document::Document& before) {
  if (committed == document::Committed::Amended) {
    if (amendedFrom_) return;
    amendedFrom_ = before;
    amendedMs_ = host_.nowMs();
    host_.wakeAfter(kAmendMs);
  } else if (committed == document::Committed::Step) {
    if (amendedFrom_) sendRecord(io::amendRecord(*amendedFrom_, before), *amendedFrom_);
    amendedFrom_.reset();
    sendRecord(io::commitRecord(before, document()), before);
  }
}

void Session::sendAmends(bool now) {
  if (!amendedFrom_) return;
  const double left = kAmendMs - (host_.nowMs() - amendedMs_);
  if (!now && left > 1) {
    host_.wakeAfter(left);
    return;
  }
  const document::Document from = std::move(*amendedFrom_);
  amendedFrom_.reset();
  sendRecord(io::amendRecord(from, document()), from);
}

void Session::sendRecord(std::string record, const document::Document& before) {
  sendJournal(host_, {record, newPhotos(before, document()), document()});
}

}  // namespace spineloft::app
