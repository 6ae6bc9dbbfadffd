// spineloft make: a recipe, with as many pictures as it has, to a model and what is measured of it.
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <ostream>
#include <utility>

#include "engine/cli/files.h"
#include "engine/cli/model.h"
#include "engine/cli/program.h"
#include "engine/io/picture_file.h"
#include "engine/io/recipe_file.h"
#include "engine/mesh/laws.h"
#include "engine/pipeline/outline_match.h"
#include "engine/pipeline/silhouette.h"
#include "engine/publish/publish.h"

namespace spineloft::cli {
namespace {

using Json = nlohmann::json;

Result<document::Document> readDocument(const MakeArguments& arguments) {
  const Result<std::string> text = readText(arguments.recipe);
  if (!text.ok()) return text.failure();
  io::RecipeInput input;
  for (const auto& [id, file] : arguments.pictures) {
    Result<image::Picture> picture = readPicture(file);
    if (!picture.ok()) return picture.failure();
    input.pictures.emplace_back(id, std::make_shared<const image::Picture>(std::move(picture).value()));
  }
  Result<document::Document> document = io::readRecipe(text.value(), input);
  if (document.ok()) return document;
  const std::string& why = document.failure().detail;
  return {document.error(), arguments.recipe + (why.empty() ? "" : ": " + why)};
}

/// A way to look at a part: from the front or as a picture of the document does, else as one beside it would.
struct Look {
  const char* name;
  std::optional<geometry::View> view;
  image::Size size;
};
std::vector<Look> looksAt(const document::Document& document, PictureId front) {
  using geometry::ViewFrom;
  const image::Size size = findPicture(document, front)->size;
  std::vector<Look> looks{{"front", std::nullopt, size},
                          {"side", geometry::View{ViewFrom::Right, (size.width - 1) / 2.0, 1, 0}, size},
                          {"top", geometry::View{ViewFrom::Top, (size.height - 1) / 2.0, 1, 0}, size}};
  for (const document::PictureEntry& entry : document.pictures) {
    if (!entry.view || entry.view->of != front) continue;
    const geometry::View& view = entry.view->view;
    if (view.from == ViewFrom::Back) {
      looks.push_back({"back", view, entry.size});
    } else {
      Look& look = looks[view.from == ViewFrom::Top ? 2 : 1];
      look = {look.name, view, entry.size};
    }
  }
  return looks;
}

/// One picture a part and look, at rest where it was drawn: NAME.png, of several parts ID-NAME.png.
Status addSilhouettes(const Model& model, const std::string& folder, std::vector<OutputFile>& files) {
  std::error_code problem;
  std::filesystem::create_directories(folder, problem);
  if (problem) return {Error::FileUnwritable, folder};
  const bool many = model.document.parts.size() > 1;
  for (std::size_t i = 0; i < model.document.parts.size(); ++i) {
    const document::Part& part = model.document.parts[i];
    for (const Look& look : looksAt(model.document, document::pictureOf(part))) {
      const mesh::TriMesh seen = pipeline::seenIn(model.shape(i).mesh, look.view);
      Result<Bytes> bytes = io::encodeMaskPng(pipeline::rasteriseSilhouette(seen, look.size));
      if (!bytes.ok()) return bytes.failure();
      const std::string name = (many ? std::to_string(part.id.value) + "-" : "") + look.name + ".png";
      files.push_back({(std::filesystem::path(folder) / name).string(), std::move(bytes).value()});
    }
  }
  return Done{};
}

const char* nameOf(const std::optional<geometry::View>& view) {
  static constexpr const char* kNames[] = {"right", "left", "back", "top"};
  return view ? kNames[static_cast<std::size_t>(view->from)] : "front";
}

/// How the silhouettes of a part agree with its outlines.
Json viewsOf(const Model& model, std::size_t number) {
  Json views = Json::array();
  const document::Part& part = model.document.parts[number];
  for (const document::Outline* outline : document::outlinesOf(part.recipe)) {
    const auto view = viewOn(model.document, outline->picture, document::pictureOf(part));
    if (!view.ok()) continue;
    const auto match = pipeline::matchOutline(model.shape(number).mesh, view.value(), outline->lines);
    views.push_back(
        {{"view", nameOf(view.value())}, {"iou", match.iou}, {"largest", match.largest}, {"mean", match.mean}});
  }
  return views;
}

Json placesOf(const std::vector<ModelPoint>& points) {
  Json places = Json::array();
  for (const ModelPoint p : points) places.push_back({p.x, p.y, p.z});
  return places;
}

/// How much of its way each pull of a part could go, and where its line and its ring lie then: ModelSpace.
Json pullsOf(const Model& model, std::size_t number) {
  Json pulls = Json::array();
  for (const pipeline::PulledLine& pulled : model.shape(number).pulled) {
    Json one{{"share", pulled.share}, {"line", placesOf(pulled.points)}};
    if (!pulled.ring.empty()) one["ring"] = placesOf(pulled.ring);
    pulls.push_back(std::move(one));
  }
  return pulls;
}

/// Where a bridge leaves its parts: ModelSpace.
Json rimsOf(const Model& model, std::size_t number) {
  Json rims = Json::array();
  for (const bridge::Rim& rim : model.shape(number).rims) {
    const auto& [points, centre, out] = rim;
    double radius = 0;
    for (const ModelPoint p : points) radius += distance(p, centre) / static_cast<double>(points.size());
    rims.push_back({{"centre", {centre.x, centre.y, centre.z}}, {"radius", radius}, {"out", {out.x, out.y, out.z}}});
  }
  return rims;
}

/// What a relief found: null of a part without one.
Json reliefOf(const Model& model, std::size_t number) {
  const std::optional<pipeline::ReliefFound>& found = model.shape(number).relief;
  if (!found) return {};
  return {{"mode", relief::modeKey(found->mode)},
          {"seen", found->seen},
          {"raises", found->raises},
          {"explained", found->explained},
          {"share", found->share}};
}

std::string reportOf(const Model& model) {
  Json parts = Json::array(), times = Json::object();
  for (std::size_t i = 0; i < model.document.parts.size(); ++i) {
    const document::Part& part = model.document.parts[i];
    const mesh::TriMesh& made = model.shape(i).mesh;
    const mesh::MeshReport report = mesh::inspect(made);
    const mesh::Bounds bounds = mesh::boundsOf(made);
    parts.push_back({{"id", part.id.value},
                     {"name", part.name},
                     {"kind", document::kindKey(document::kindOf(part))},
                     {"lawful", report.valid()},
                     {"broken", mesh::brokenLaw(report)},
                     {"shells", report.shells},
                     {"genus", report.genus},
                     {"volume", report.volume},
                     {"area", report.area},
                     {"low", bounds.low},
                     {"high", bounds.high},
                     {"vertices", made.positions.size()},
                     {"triangles", made.triangles.size()},
                     {"ms", model.shape(i).ms.ribs + model.shape(i).ms.loft},
                     {"views", viewsOf(model, i)},
                     {"pulls", pullsOf(model, i)},
                     {"rims", rimsOf(model, i)},
                     {"relief", reliefOf(model, i)}});
  }
  for (const auto& [name, value] : model.milliseconds) times[name] = value;
  return Json{{"parts", parts}, {"milliseconds", times}}.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace

Status runMake(const MakeArguments& arguments, Console console) {
  const double started = nowMs();
  Result<document::Document> document = readDocument(arguments);
  if (!document.ok()) return document.failure();
  const Result<Model> made = deriveModel(std::move(document).value(), false, {{"read", nowMs() - started}});
  if (!made.ok()) return made.failure();
  const Model& model = made.value();
  std::vector<OutputFile> files;
  if (!arguments.out.empty()) {
    Result<Bytes> bytes = publish::publish(model.document, model.derived, arguments.format, Progress());
    if (!bytes.ok()) return bytes.failure();
    files.push_back({arguments.out, std::move(bytes).value()});
  }
  if (!arguments.silhouettes.empty()) {
    if (Status status = addSilhouettes(model, arguments.silhouettes, files); !status.ok()) return status;
  }
  if (!arguments.report.empty()) files.push_back({arguments.report, bytesOf(reportOf(model))});
  if (Status status = writeAll(files); !status.ok()) return status;
  if (!arguments.out.empty()) {
    reportSeparateParts(model.document, console.err);
    reportCrossingParts(model.document, model.derived, console.err);
  }
  std::size_t triangles = 0;
  for (std::size_t i = 0; i < model.document.parts.size(); ++i) triangles += model.shape(i).mesh.triangles.size();
  console.out << model.document.parts.size() << (model.document.parts.size() == 1 ? " part, " : " parts, ") << triangles
              << " triangles";
  for (const OutputFile& file : files) console.out << (&file == &files.front() ? ": " : ", ") << file.path;
  console.out << '\n';
  return Done{};
}

}  // namespace spineloft::cli
