#include "engine/cli/opened.h"

#include <utility>

#include "engine/cli/files.h"
#include "engine/cli/program.h"
#include "engine/io/share_text.h"

namespace spineloft::cli {
namespace {

Result<document::Document> readModel(const std::string& name, io::ReadNotes& notes) {
  const Result<Bytes> file = readFile(name);
  if (file.ok()) {
    Result<document::Document> document = io::readProject(file.value(), &notes);
    if (document.ok()) return document;
    const std::string& why = document.failure().detail;
    return {document.error(), name + (why.empty() ? "" : ": " + why)};
  }
  if (const auto text = io::textOfLink(name)) return io::readShareText(*text, &notes);
  return file.failure();
}

}  // namespace

Result<Opened> openModel(const std::string& name) {
  Opened opened;
  const double started = nowMs();
  Result<document::Document> document = readModel(name, opened.notes);
  if (!document.ok()) return document.failure();
  opened.document = std::move(document).value();
  const double read = nowMs();
  pipeline::Cache cache;
  Result<pipeline::Derived> derived = pipeline::deriveWithEdges(opened.document, cache, Progress());
  if (!derived.ok()) return derived.failure();
  opened.derived = std::move(derived).value();
  opened.readMs = read - started;
  opened.deriveMs = nowMs() - read;
  return opened;
}

}  // namespace spineloft::cli
