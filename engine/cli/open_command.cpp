// spineloft open: a project → its parts derived again, and written in any form.
#include <ostream>
#include <utility>

#include "engine/cli/files.h"
#include "engine/cli/opened.h"
#include "engine/cli/printable.h"
#include "engine/cli/program.h"
#include "engine/io/json_values.h"
#include "engine/mesh/laws.h"
#include "engine/publish/publish.h"

namespace spineloft::cli {
namespace {

std::string reportOf(const Opened& opened) {
  double shaped = 0, vertices = 0, triangles = 0, valid = 0;
  for (const pipeline::DerivedPart& part : opened.derived.parts) {
    if (!part.shape) continue;
    ++shaped;
    vertices += static_cast<double>(part.shape->mesh.positions.size());
    triangles += static_cast<double>(part.shape->mesh.triangles.size());
    valid += mesh::brokenLaw(mesh::inspect(part.shape->mesh)).empty();
  }
  return io::writeNumbers({{"pictures", static_cast<double>(opened.document.pictures.size())},
                           {"parts", static_cast<double>(opened.document.parts.size())},
                           {"solids", static_cast<double>(opened.document.steps.size())},
                           {"shaped", shaped},
                           {"lawful", valid},
                           {"vertices", vertices},
                           {"triangles", triangles},
                           {"height_mm", opened.document.height.value},
                           {"dropped", static_cast<double>(opened.notes.dropped)},
                           {"repaired", static_cast<double>(opened.notes.repaired)},
                           {"read_ms", opened.readMs},
                           {"derive_ms", opened.deriveMs}});
}

}  // namespace

Status runOpen(const OpenArguments& arguments, Console console) {
  const Result<Opened> read = openModel(arguments.file);
  if (!read.ok()) return read.failure();
  const Opened& opened = read.value();
  std::vector<OutputFile> files;
  if (!arguments.out.empty()) {
    Result<Bytes> bytes = publish::publish(opened.document, opened.derived, arguments.format, Progress());
    if (!bytes.ok()) return bytes.failure();
    files.push_back({arguments.out, std::move(bytes).value()});
  }
  if (!arguments.document.empty()) {
    files.push_back({arguments.document, bytesOf(io::writeDocument(opened.document))});
  }
  if (!arguments.report.empty()) files.push_back({arguments.report, bytesOf(reportOf(opened))});
  if (Status status = writeAll(files); !status.ok()) return status;
  if (!arguments.out.empty()) {
    reportSeparateParts(opened.document, console.err);
    reportCrossingParts(opened.document, opened.derived, console.err);
  }

  std::ostream& out = console.out;
  out << onOneLine(opened.document.name) << ": " << opened.document.pictures.size() << " pictures, "
      << opened.document.parts.size() << " parts";
  if (!opened.notes.clean()) {
    out << " (damaged: " << opened.notes.dropped << " left out, " << opened.notes.repaired << " mended)";
  }
  for (const OutputFile& file : files) out << (&file == &files.front() ? ": " : ", ") << file.path;
  out << '\n';
  return Done{};
}

}  // namespace spineloft::cli
