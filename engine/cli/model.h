// A document of a recipe or of arguments, with all that is derived from it.
#pragma once

#include <string>

#include "engine/base/result.h"
#include "engine/document/document.h"
#include "engine/image/image.h"
#include "engine/io/json_values.h"
#include "engine/pipeline/derive.h"

namespace spineloft::cli {

/// What the outputs are written from: a document whose parts all have a shape.
struct Model {
  document::Document document;
  pipeline::Derived derived;
  io::NamedNumbers milliseconds;
  /// The picture and the shape of a part.
  image::Size picture(std::size_t part) const {
    return findPicture(document, document::pictureOf(*document.parts[part]))->size;
  }
  const pipeline::PartShape& shape(std::size_t part) const { return *derived.parts[part].shape; }
};

/// Errors: FileUnreadable, those of io::decodePicture.
Result<image::Picture> readPicture(const std::string& path);

/// Every part of the document with its shape. `cut`: its only stroke is cut to the thing under it first, as the page
/// does when the pen lifts. `milliseconds`: what took time before. Errors: NothingToExport, the first failure of a
/// part.
Result<Model> deriveModel(document::Document document, bool cut, io::NamedNumbers milliseconds);

}  // namespace spineloft::cli
