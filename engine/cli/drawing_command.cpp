// spineloft loft --recipe with a bare drawing: lines → pieces, one node each.
#include <algorithm>
#include <ostream>
#include <utility>

#include "engine/cli/files.h"
#include "engine/cli/program.h"
#include "engine/descriptive/model.h"
#include "engine/document/document.h"
#include "engine/io/drawing_file.h"
#include "engine/io/gltf.h"
#include "engine/io/obj.h"
#include "engine/io/stl.h"
#include "engine/io/three_mf.h"
#include "engine/mesh/laws.h"

namespace spineloft::cli {
namespace {

/// What only makes sense for parts with pictures is not asked of a drawing. Error: JsonInvalid.
Status checkWishes(const LoftArguments& arguments) {
  const bool hasOthers = !arguments.image.empty() || !arguments.stroke.empty() || !arguments.mask.empty() ||
                         !arguments.ribs.empty() || arguments.objInPicture;
  const bool hasFormat = arguments.format == publish::Format::Glb || arguments.format == publish::Format::Obj ||
                         arguments.format == publish::Format::Stl || arguments.format == publish::Format::ThreeMf;
  if (!hasOthers && (arguments.out.empty() || hasFormat)) return Done{};
  return {Error::JsonInvalid, arguments.recipe +
                                  ": a drawing needs no picture and no stroke; it has --report, and --out as "
                                  "GLB, OBJ, STL or 3MF"};
}

/// All solids, standing on the ground, centred, `heightMm` tall.
Result<Bytes> fileOf(const descriptive::Model& model, publish::Format format, double heightMm) {
  mesh::Bounds all = mesh::boundsOf(model.solids[0].mesh);
  for (const descriptive::ModelPiece& one : model.solids) {
    const mesh::Bounds bounds = mesh::boundsOf(one.mesh);
    for (std::size_t k = 0; k < 3; ++k) {
      all.low[k] = std::min(all.low[k], bounds.low[k]);
      all.high[k] = std::max(all.high[k], bounds.high[k]);
    }
  }
  // GLB is in metres.
  const double scale = heightMm / (all.high[1] - all.low[1]) / (format == publish::Format::Glb ? 1000 : 1);
  std::vector<io::ExportPart> parts;
  for (const descriptive::ModelPiece& one : model.solids) {
    io::ExportPart part;
    part.name = model.pieces[one.piece].name;
    part.mesh = &one.mesh;
    part.placement = {{(all.low[0] + all.high[0]) / 2, all.low[1], (all.low[2] + all.high[2]) / 2}, scale};
    parts.push_back(std::move(part));
  }
  switch (format) {
    case publish::Format::Obj:
      return io::writeObj(parts);
    case publish::Format::Stl:
      return io::writeStl(parts);
    case publish::Format::ThreeMf:
      return io::write3mf(parts, {});
    case publish::Format::Glb:
    case publish::Format::Project:
    case publish::Format::ObjZip:
      break;
  }
  return io::writeGlb(parts, {});
}

}  // namespace

Status runDrawing(const LoftArguments& arguments, const std::string& text, Console console) {
  if (Status status = checkWishes(arguments); !status.ok()) return status;
  const Result<descriptive::Drawing> drawing = io::readDrawing(text);
  if (!drawing.ok()) return {drawing.error(), arguments.recipe + ": " + drawing.failure().detail};
  const double started = nowMs();
  const Result<descriptive::Model> model = descriptive::modelOf(drawing.value());
  if (!model.ok()) return {model.error(), arguments.recipe};
  const io::NamedNumbers milliseconds{{"model", nowMs() - started}};
  std::vector<OutputFile> files;
  if (!arguments.out.empty()) {
    const double height = arguments.heightMm.value_or(document::Document{}.height.value);
    Result<Bytes> bytes = fileOf(model.value(), arguments.format, height);
    if (!bytes.ok()) return bytes.failure();
    files.push_back({arguments.out, std::move(bytes).value()});
  }
  if (!arguments.report.empty()) {
    files.push_back({arguments.report, bytesOf(io::writeDrawingReport(model.value(), milliseconds))});
  }
  if (Status status = writeAll(files); !status.ok()) return status;
  console.out << model.value().solids.size() << " pieces, " << model.value().orders.orders.size() << " overlaps";
  for (const OutputFile& file : files) console.out << (&file == &files.front() ? ": " : ", ") << file.path;
  console.out << '\n';
  return Done{};
}

}  // namespace spineloft::cli
