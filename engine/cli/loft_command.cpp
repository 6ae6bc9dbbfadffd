// spineloft loft: picture + stroke → part, through the same document and pipeline as the page.
#include <filesystem>
#include <memory>
#include <ostream>
#include <utility>

#include "engine/cli/files.h"
#include "engine/cli/program.h"
#include "engine/document/update.h"
#include "engine/io/json_values.h"
#include "engine/io/obj.h"
#include "engine/io/picture_file.h"
#include "engine/mesh/laws.h"
#include "engine/pipeline/derive.h"
#include "engine/pipeline/silhouette.h"
#include "engine/publish/publish.h"

namespace spineloft::cli {
namespace {

/// What the outputs are written from.
struct Model {
  document::Document document;
  pipeline::Derived derived;
  io::NamedNumbers milliseconds;
  const pipeline::PartShape& shape() const { return *derived.parts.front().shape; }
  image::Size picture() const { return document.pictures.front()->size; }
};

Result<image::Picture> readPicture(const std::string& path) {
  const Result<Bytes> file = readFile(path);
  if (!file.ok()) return file.failure();
  Result<image::Picture> picture = io::decodePicture(file.value(), Progress());
  if (!picture.ok() && picture.failure().detail.empty()) return {picture.error(), path};
  return picture;
}

Result<std::vector<PicturePoint>> readStrokeFile(const LoftArguments& arguments) {
  const Result<std::string> text = readText(arguments.stroke);
  if (!text.ok()) return text.failure();
  Result<std::vector<PicturePoint>> stroke = io::readStroke(text.value(), arguments.strokeName);
  if (stroke.ok()) return stroke;
  const std::string& why = stroke.failure().detail;
  return {stroke.error(), arguments.stroke + (why.empty() ? "" : ": " + why)};
}

/// The document that a person would have made with these arguments.
Result<document::Document> author(const LoftArguments& arguments, image::Picture picture,
                                  std::vector<PicturePoint> stroke) {
  const std::string name = std::filesystem::path(arguments.image).stem().string();
  document::DrawSpine draw;
  draw.picture = PictureId{1};
  draw.stroke = std::move(stroke);
  draw.section = arguments.section;
  draw.startCap = draw.endCap = arguments.caps;
  const std::vector<document::Action> actions{
      document::AddPicture{name, std::make_shared<const image::Picture>(std::move(picture))},
      document::RenameDocument{name}, document::SetHeight{Millimetres{arguments.heightMm}},
      std::move(draw)};
  document::Document document;
  for (const document::Action& action : actions) {
    Result<document::Document> next = document::update(document, action);
    if (!next.ok()) return next.failure();
    document = std::move(next).value();
  }
  return document;
}

Result<Model> makeModel(const LoftArguments& arguments) {
  Result<std::vector<PicturePoint>> stroke = readStrokeFile(arguments);
  if (!stroke.ok()) return stroke.failure();
  const double started = nowMs();
  Result<image::Picture> picture = readPicture(arguments.image);
  if (!picture.ok()) return picture.failure();
  const double decoded = nowMs();
  Result<document::Document> document =
      author(arguments, std::move(picture).value(), std::move(stroke).value());
  if (!document.ok()) return {document.error(), arguments.stroke};
  pipeline::Cache cache;
  double edgesMs = 0;
  Result<pipeline::Derived> derived =
      pipeline::deriveWithEdges(document.value(), cache, Progress(), nowMs, &edgesMs);
  if (!derived.ok()) return derived.failure();
  const pipeline::DerivedPart& part = derived.value().parts.front();
  if (!part.shape) return part.failure.value_or(Failure{Error::NothingToExport, {}});
  const pipeline::StageMs ms = part.shape->ms;
  return Model{
      std::move(document).value(),
      std::move(derived).value(),
      {{"decode", decoded - started}, {"edges", edgesMs}, {"ribs", ms.ribs}, {"loft", ms.loft}}};
}

Result<Bytes> modelFile(const LoftArguments& arguments, const Model& model) {
  if (!arguments.objInPicture) {
    return publish::publish(model.document, model.derived, arguments.format, Progress());
  }
  io::ExportPart part;
  part.name = model.document.parts.front()->name;
  part.mesh = &model.shape().mesh;
  return io::writeObj({&part, 1}, io::ObjSpace::Image);
}

Bytes bytesOf(const std::string& text) { return Bytes(text.begin(), text.end()); }

std::string reportOf(const Model& model) {
  const pipeline::PartShape& shape = model.shape();
  io::LoftReport report;
  report.picture = model.picture();
  report.ribs = shape.ribs.ribs.size();
  report.vertices = shape.mesh.positions.size();
  report.triangles = shape.mesh.triangles.size();
  report.energy = shape.ribs.energy;
  report.mesh = mesh::inspect(shape.mesh);
  report.milliseconds = model.milliseconds;
  return io::writeReport(report);
}

}  // namespace

Status runLoft(const LoftArguments& arguments, std::ostream& out) {
  Result<Model> made = makeModel(arguments);
  if (!made.ok()) return made.failure();
  Model& model = made.value();
  std::vector<OutputFile> files;
  const auto add = [&](const std::string& path, Result<Bytes> bytes) -> Status {
    if (!bytes.ok()) return bytes.failure();
    files.push_back({path, std::move(bytes).value()});
    return Done{};
  };
  const double started = nowMs();
  if (!arguments.out.empty()) {
    if (Status status = add(arguments.out, modelFile(arguments, model)); !status.ok())
      return status;
  }
  if (!arguments.mask.empty()) {
    const image::Mask mask = pipeline::rasteriseSilhouette(model.shape().mesh, model.picture());
    if (Status status = add(arguments.mask, io::encodeMaskPng(mask)); !status.ok()) return status;
  }
  if (!arguments.ribs.empty()) {
    files.push_back({arguments.ribs, bytesOf(io::writeRibs(model.shape().ribs))});
  }
  model.milliseconds.emplace_back("write", nowMs() - started);
  if (!arguments.report.empty()) files.push_back({arguments.report, bytesOf(reportOf(model))});
  if (Status status = writeAll(files); !status.ok()) return status;

  out << model.shape().ribs.ribs.size() << " ribs, " << model.shape().mesh.triangles.size()
      << " triangles";
  for (const OutputFile& file : files) out << (&file == &files.front() ? ": " : ", ") << file.path;
  out << '\n';
  return Done{};
}

Status runEdges(const EdgesArguments& arguments, std::ostream& out) {
  const Result<image::Picture> picture = readPicture(arguments.image);
  if (!picture.ok()) return picture.failure();
  const Result<image::EdgeMap> found = vision::detectEdges(picture.value(), {}, Progress());
  if (!found.ok()) return found.failure();
  const image::EdgeMap& edges = found.value();
  image::Mask mask{picture.value().width, picture.value().height, {}};
  mask.pixels.reserve(static_cast<std::size_t>(mask.width) * static_cast<std::size_t>(mask.height));
  // Each picture pixel shows the map pixel it lies in.
  for (int y = 0; y < mask.height; ++y) {
    const std::size_t row = static_cast<std::size_t>((y + 0.5) / edges.scaleY);
    for (int x = 0; x < mask.width; ++x) {
      const std::size_t column = static_cast<std::size_t>((x + 0.5) / edges.scaleX);
      mask.pixels.push_back(edges.edges[row * static_cast<std::size_t>(edges.width) + column]);
    }
  }
  Result<Bytes> png = io::encodeMaskPng(mask);
  if (!png.ok()) return png.failure();
  if (Status status = writeAll({{arguments.out, std::move(png).value()}}); !status.ok())
    return status;
  out << mask.width << " x " << mask.height << " pixels of edges: " << arguments.out << '\n';
  return Done{};
}

}  // namespace spineloft::cli
