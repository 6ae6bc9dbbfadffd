// spineloft loft: picture + stroke → part, through the same document and pipeline as the page.
#include <filesystem>
#include <memory>
#include <ostream>
#include <utility>

#include "engine/cli/files.h"
#include "engine/cli/model.h"
#include "engine/cli/program.h"
#include "engine/document/update.h"
#include "engine/geometry/pieces.h"
#include "engine/inflate/bone_edits.h"
#include "engine/inflate/profile.h"
#include "engine/inflate/thin_rings.h"
#include "engine/io/drawing_file.h"
#include "engine/io/json_values.h"
#include "engine/io/obj.h"
#include "engine/io/picture_file.h"
#include "engine/io/recipe_file.h"
#include "engine/mesh/laws.h"
#include "engine/mesh/self_crossing.h"
#include "engine/pipeline/silhouette.h"
#include "engine/publish/publish.h"

namespace spineloft::cli {
namespace {

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
  const double height = arguments.heightMm.value_or(document::Document{}.height.value);
  const std::vector<document::Action> actions{
      document::AddPicture{name, std::make_shared<const image::Picture>(std::move(picture))},
      document::RenameDocument{name}, document::SetHeight{Millimetres{height}}, std::move(draw)};
  document::Document document;
  for (const document::Action& action : actions) {
    Result<document::Document> next = document::update(document, action);
    if (!next.ok()) return next.failure();
    document = std::move(next).value();
  }
  return document;
}

/// The document of a recipe, on the picture and with the stroke of the arguments where they name them.
Result<document::Document> follow(const LoftArguments& arguments, image::Picture* picture,
                                  std::vector<PicturePoint> stroke) {
  const Result<std::string> text = readText(arguments.recipe);
  if (!text.ok()) return text.failure();
  io::RecipeInput input;
  if (picture != nullptr) {
    input.photo = std::make_shared<const image::Picture>(std::move(*picture));
    input.photoName = std::filesystem::path(arguments.image).stem().string();
  }
  input.stroke = std::move(stroke);
  Result<document::Document> document = io::readRecipe(text.value(), input);
  if (!document.ok()) {
    const std::string& why = document.failure().detail;
    return {document.error(), arguments.recipe + (why.empty() ? "" : ": " + why)};
  }
  if (!arguments.heightMm) return document;
  return document::update(document.value(), document::SetHeight{Millimetres{*arguments.heightMm}});
}

Result<Model> makeModel(const LoftArguments& arguments) {
  std::vector<PicturePoint> stroke;
  if (!arguments.stroke.empty()) {
    Result<std::vector<PicturePoint>> read = readStrokeFile(arguments);
    if (!read.ok()) return read.failure();
    stroke = std::move(read).value();
  }
  const double started = nowMs();
  Result<image::Picture> picture = image::Picture{};
  if (!arguments.image.empty()) picture = readPicture(arguments.image);
  if (!picture.ok()) return picture.failure();
  const double decoded = nowMs();
  Result<document::Document> document =
      arguments.recipe.empty()
          ? author(arguments, std::move(picture).value(), std::move(stroke))
          : follow(arguments, arguments.image.empty() ? nullptr : &picture.value(), std::move(stroke));
  if (!document.ok()) {
    if (!arguments.recipe.empty()) return document.failure();
    return {document.error(), arguments.stroke};
  }
  const bool cut = arguments.recipe.empty() && !arguments.wholeStroke;
  return deriveModel(std::move(document).value(), cut, {{"decode", decoded - started}});
}

/// What only makes sense for one part is not asked of several. Error: JsonInvalid.
Status checkOutputs(const LoftArguments& arguments, const Model& model) {
  const bool forOne = !arguments.mask.empty() || !arguments.ribs.empty() || arguments.objInPicture;
  if (!forOne || model.document.parts.size() == 1) return Done{};
  return {Error::JsonInvalid, arguments.recipe + ": it has " + std::to_string(model.document.parts.size()) +
                                  " parts; --mask, --ribs and --obj-space image are for one"};
}

Result<Bytes> modelFile(const LoftArguments& arguments, const Model& model) {
  if (!arguments.objInPicture) {
    return publish::publish(model.document, model.derived, arguments.format, Progress());
  }
  io::ExportPart part;
  part.name = model.document.parts.front()->name;
  part.mesh = &model.shape(0).mesh;
  return io::writeObj({&part, 1}, io::ObjSpace::Image);
}

/// The skeletons of the pieces of a puff, as edited.
std::vector<inflate::EditedSkeleton> bonesOf(const pipeline::PartShape& shape, const inflate::InflateParams& puff) {
  if (!puff.profile.isSoft()) return shape.bones;
  std::vector<inflate::EditedSkeleton> bones;
  for (const geometry::Contours& piece : geometry::piecesOf(shape.contours)) {
    Result<inflate::EditedSkeleton> skeleton = inflate::editedSkeleton(piece, puff.bones);
    if (skeleton.ok()) bones.push_back(std::move(skeleton).value());
  }
  return bones;
}

/// What the slices of a puff are made of; none of a soft one.
std::optional<io::LoftReport::Profile> profileOf(std::span<const inflate::EditedSkeleton> bones, image::Size picture,
                                                 const inflate::InflateParams& puff) {
  auto curves = inflate::matchedCurves(puff.profile.slices, puff.sides);
  if (puff.profile.isSoft() || !curves.ok()) return std::nullopt;
  io::LoftReport::Profile out{static_cast<int>(puff.profile.slices.size()), 0, 0,
                              inflate::thickenRings(curves.value(), bones, picture, puff)};
  for (const std::vector<inflate::ProfileCurve>& curve : curves.value())
    ++(curve.front().closed ? out.offAxis : out.middle);
  return out;
}

/// Of one part an object, of several a list of them; the times are those of all.
std::string reportOf(const Model& model) {
  std::string text;
  for (std::size_t i = 0; i < model.document.parts.size(); ++i) {
    const pipeline::PartShape& shape = model.shape(i);
    io::LoftReport report;
    report.picture = model.picture(i);
    report.ribs = shape.ribs.ribs.size();
    report.vertices = shape.mesh.positions.size();
    report.triangles = shape.mesh.triangles.size();
    report.energy = shape.ribs.energy;
    report.mesh = mesh::inspect(shape.mesh);
    report.crossesItself = mesh::selfCrossing(shape.mesh).has_value();
    if (const document::InflateRecipe* puff = document::inflateOf(*model.document.parts[i])) {
      const std::vector<inflate::EditedSkeleton> bones = bonesOf(shape, puff->inflate);
      report.bones.emplace();
      for (const inflate::EditedSkeleton& piece : bones) report.bones->push_back(piece.skeleton);
      report.asleep = inflate::asleep(bones);
      report.profile = profileOf(bones, report.picture, puff->inflate);
    }
    if (document::stackOf(*model.document.parts[i]) != nullptr) report.ways = shape.ways;
    report.milliseconds = model.milliseconds;
    text += (text.empty() ? "" : ",\n") + io::writeReport(report);
  }
  return model.document.parts.size() == 1 ? text : "[" + text + "]\n";
}

}  // namespace

Status runLoft(const LoftArguments& arguments, Console console) {
  if (!arguments.recipe.empty()) {
    const Result<std::string> text = readText(arguments.recipe);
    if (text.ok() && io::isDrawing(text.value())) return runDrawing(arguments, text.value(), console);
  }
  Result<Model> made = makeModel(arguments);
  if (!made.ok()) return made.failure();
  Model& model = made.value();
  if (Status status = checkOutputs(arguments, model); !status.ok()) return status;
  std::vector<OutputFile> files;
  const auto add = [&](const std::string& path, Result<Bytes> bytes) -> Status {
    if (!bytes.ok()) return bytes.failure();
    files.push_back({path, std::move(bytes).value()});
    return Done{};
  };
  const double started = nowMs();
  if (!arguments.out.empty()) {
    if (Status status = add(arguments.out, modelFile(arguments, model)); !status.ok()) return status;
  }
  if (!arguments.mask.empty()) {
    const image::Mask mask = pipeline::rasteriseSilhouette(model.shape(0).mesh, model.picture(0));
    if (Status status = add(arguments.mask, io::encodeMaskPng(mask)); !status.ok()) return status;
  }
  if (!arguments.ribs.empty()) {
    files.push_back({arguments.ribs, bytesOf(io::writeRibs(model.shape(0).ribs))});
  }
  model.milliseconds.emplace_back("write", nowMs() - started);
  if (!arguments.report.empty()) files.push_back({arguments.report, bytesOf(reportOf(model))});
  if (Status status = writeAll(files); !status.ok()) return status;
  if (!arguments.out.empty()) {
    reportSeparateParts(model.document, console.err);
    reportCrossingParts(model.document, model.derived, console.err);
  }

  std::ostream& out = console.out;
  std::size_t ribs = 0, triangles = 0;
  for (std::size_t i = 0; i < model.document.parts.size(); ++i) {
    ribs += model.shape(i).ribs.ribs.size();
    triangles += model.shape(i).mesh.triangles.size();
  }
  if (model.document.parts.size() > 1) out << model.document.parts.size() << " parts, ";
  out << ribs << " ribs, " << triangles << " triangles";
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
  if (Status status = writeAll({{arguments.out, std::move(png).value()}}); !status.ok()) return status;
  out << mask.width << " x " << mask.height << " pixels of edges: " << arguments.out << '\n';
  return Done{};
}

}  // namespace spineloft::cli
