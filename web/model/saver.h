// From the model to a file: what it holds is finished, written on a worker, and handed to the shell.
#pragma once

#include <optional>

#include "engine/base/worker_pool.h"
#include "engine/publish/publish.h"
#include "engine/publish/share_model.h"
#include "web/model/derivation.h"
#include "web/model/session.h"

namespace spineloft::app {

class Saver {
 public:
  /// All three outlive it, and the host of the other two.
  Saver(const Session& session, Derivation& derivation, platform::Host& host, WorkerPool& pool)
      : session_(session), derivation_(derivation), host_(host), pool_(pool) {}

  /// Writes the model on a worker and hands the file to the shell, when all is made that it holds. Errors:
  /// NothingToExport.
  Status save(publish::Format format);
  /// Writes what waited, if all is made now.
  void proceed();
  /// Nothing waits any more.
  void cancel() { waiting_.reset(); }
  /// Another model is open: it counts as saved.
  void modelOpened();
  /// The file, now and here.
  Result<publish::Bytes> publishNow(publish::Format format);
  /// The text of a link, now and here.
  Result<publish::SharedModel> shareNow();
  /// Something was drawn, and no file that a model can be opened from holds the document as it is.
  bool unsaved() const;

 private:
  Status write(publish::Format format);
  void handOver(Result<publish::Bytes> bytes, publish::Format format, const document::Document& written);
  /// Says what of the model a file in this format does not hold as it should be.
  void reportFaults(publish::Format format);

  const Session& session_;
  Derivation& derivation_;
  platform::Host& host_;
  WorkerPool& pool_;
  document::Document saved_;  ///< as the last file has it that holds a document
  /// Waits for the ribs, solids and textures it is to hold.
  std::optional<publish::Format> waiting_;
};

}  // namespace spineloft::app
