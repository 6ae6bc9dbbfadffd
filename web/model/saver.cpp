#include "web/model/saver.h"

#include <string>
#include <utility>

#include "engine/document/checks.h"
#include "web/model/messages.h"
#include "web/model/solid_faults.h"
#include "web/words/words.h"

namespace spineloft::app {

Status Saver::save(publish::Format format) {
  // Work in progress is kept at once, and needs no solid.
  if (format == publish::Format::Project) {
    derivation_.settled();
  } else {
    derivation_.finishParts();
  }
  if (derivation_.allMade()) return write(format);
  waiting_ = format;
  return Done{};
}

void Saver::proceed() {
  if (!waiting_) return;
  derivation_.settled();
  if (!derivation_.allMade()) return;
  const publish::Format format = *std::exchange(waiting_, std::nullopt);
  if (const Status status = write(format); !status) sendError(host_, spokenFailure(status.failure()));
}

void Saver::modelOpened() {
  waiting_.reset();
  saved_ = session_.document();
}

Status Saver::write(publish::Format format) {
  const document::Document written = session_.document();
  if (written.parts.empty() && format != publish::Format::Project) return Error::NothingToExport;
  reportFaults(format);
  pool_.submit(
      "Saving the model",
      [written, derived = derivation_.settled(), format](const Progress& progress) {
        return publish::publish(written, derived, format, progress);
      },
      [this, format, written](Result<publish::Bytes> bytes) { handOver(std::move(bytes), format, written); });
  return Done{};
}

void Saver::handOver(Result<publish::Bytes> bytes, publish::Format format, const document::Document& written) {
  if (!bytes) {
    sendError(host_, spokenFailure(bytes.failure()));
    return;
  }
  host_.sendFile(publish::fileName(written, format), publish::mediaType(format), bytes.value());
  if (publish::holdsDocument(format)) saved_ = written;
}

Result<publish::Bytes> Saver::publishNow(publish::Format format) {
  derivation_.finishNow();
  reportFaults(format);
  return publish::publish(session_.document(), derivation_.settled(), format, Progress{});
}

Result<publish::SharedModel> Saver::shareNow() {
  derivation_.finishNow();
  return publish::shareModel(session_.document(), derivation_.settled());
}

void Saver::reportFaults(publish::Format format) {
  // A model file holds what it is made of, whatever became of it here.
  if (format == publish::Format::Project) return;
  const document::Document& document = session_.document();
  const std::string faults = faultsOf(document, derivation_.settled());
  if (!faults.empty()) sendWarning(host_, words::tr("In the file, {faults}", {{"faults", faults}}));
  for (const PartId id : derivation_.crossingParts()) {
    const document::Part* part = document::findPart(document, id);
    sendWarning(host_, spokenFailure({Error::PartCrossesItself, part ? part->name : std::string()}));
  }
}

bool Saver::unsaved() const { return document::holdsWork(session_.document()) && session_.document() != saved_; }

}  // namespace spineloft::app
