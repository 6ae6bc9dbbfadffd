#include "engine/cli/model.h"

#include <utility>

#include "engine/cli/files.h"
#include "engine/cli/program.h"
#include "engine/document/update.h"
#include "engine/io/picture_file.h"

namespace spineloft::cli {

Result<image::Picture> readPicture(const std::string& path) {
  const Result<Bytes> file = readFile(path);
  if (!file.ok()) return file.failure();
  Result<image::Picture> picture = io::decodePicture(file.value(), Progress());
  if (!picture.ok() && picture.failure().detail.empty()) return {picture.error(), path};
  return picture;
}

namespace {

/// The document with its only stroke cut to the thing under it, as the page does when the pen lifts.
/// `cache` has the edges.
Result<document::Document> onThing(const document::Document& document, pipeline::Cache& cache) {
  const document::Part& part = document.parts.front();
  const document::LoftRecipe& recipe = *document::loftOf(part);
  std::vector<PicturePoint> stroke = pipeline::strokeOnThing(document, recipe, cache);
  if (stroke == recipe.stroke) return document;
  return document::update(document, document::RedrawSpine{part.id, std::move(stroke)});
}

}  // namespace

Result<Model> deriveModel(document::Document document, bool cut, io::NamedNumbers milliseconds) {
  if (document.parts.empty()) return Error::NothingToExport;
  pipeline::Cache cache;
  double edgesMs = 0;
  Result<pipeline::Derived> derived = pipeline::deriveWithEdges(document, cache, Progress(), nowMs, &edgesMs);
  if (!derived.ok()) return derived.failure();
  if (cut) {
    Result<document::Document> shorter = onThing(document, cache);
    if (!shorter.ok()) return shorter.failure();
    document = std::move(shorter).value();
    derived = pipeline::derive(document, cache, nowMs);
  }
  double ribsMs = 0, loftMs = 0;
  for (std::size_t i = 0; i < document.parts.size(); ++i) {
    const pipeline::DerivedPart& part = derived.value().parts[i];
    if (!part.shape) {
      Failure failure = part.failure.value_or(Failure{Error::NothingToExport, {}});
      if (failure.detail.empty()) failure.detail = document.parts[i]->name;
      return failure;
    }
    ribsMs += part.shape->ms.ribs;
    loftMs += part.shape->ms.loft;
  }
  milliseconds.insert(milliseconds.end(), {{"edges", edgesMs}, {"ribs", ribsMs}, {"loft", loftMs}});
  return Model{std::move(document), std::move(derived).value(), std::move(milliseconds)};
}

}  // namespace spineloft::cli
