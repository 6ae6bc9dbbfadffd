// The open document with its history, and the records of the journal that tell of every change.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "engine/document/action.h"
#include "engine/document/document.h"
#include "engine/document/history.h"
#include "web/platform/host.h"

namespace spineloft::app {

class Session {
 public:
  explicit Session(platform::Host& host) : host_(host) {}

  const document::Document& document() const { return history_.present(); }
  /// Every step with its past and future. Each commit, undo and redo is told to the host as a record
  /// of the journal (engine/io/journal.h), in order.
  const document::History<document::Document>& history() const { return history_; }

  /// All actions or none, as one step of undo. Errors: those of document::update.
  /// Equal bursts (not empty) shortly after each other, with nothing in between, are one step.
  Status act(std::span<const document::Action> actions, std::string_view burst);
  Status undo();
  Status redo();
  /// An empty board; undo brings the old one back.
  void clear();
  /// Another model: its history takes the place of this one. No record of it is told.
  void open(document::History<document::Document> history);
  /// Tells the record of a burst that goes on (amends), once its time has come or `now`.
  void sendAmends(bool now);

 private:
  /// Tells what was just committed.
  void tell(document::Committed committed, const document::Document& before);
  void sendRecord(std::string record, const document::Document& before);

  platform::Host& host_;
  document::History<document::Document> history_;
  std::optional<document::Document> amendedFrom_;  ///< amends since this one are not told yet
  double amendedMs_ = 0;                           ///< when the first of them was
  std::string burst_;
  double burstMs_ = 0;
  document::Gesture gesture_ = 0;  ///< of the history: counts the bursts
};

}  // namespace spineloft::app
