// Recipes: what a person authored, as a JSON file of its own, so that models are made without the page.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/base/result.h"
#include "engine/base/vec.h"
#include "engine/document/document.h"

namespace spineloft::io {

/// What a recipe is applied to, besides what it says itself.
struct RecipeInput {
  std::shared_ptr<const image::Picture> photo;  ///< null: none
  std::string photoName;
  /// Photos by the ids of a whole document's pictures; a picture may be without one in the recipe.
  std::vector<std::pair<PictureId, std::shared_ptr<const image::Picture>>> pictures;
  std::vector<PicturePoint> stroke;  ///< stands for the line of a part; empty: its own
};

/// The document of a recipe, which is one of
/// - a whole document as writeDocument has it (an object with `parts`; without `version` it is one of
///   this program). If it stands on one photo, that is `input.photo`, whose size must agree; if on
///   several, they must all be it; those of `input.pictures` have their own;
/// - a part as it stands in the list `parts`, or the bare `recipe` of one: a document with this part on
///   `input.photo` (its own `picture` and `id` are not read). A stack or a shape without a photo is on blank paper.
/// Stricter than readDocument, because people write recipes: what would be left out or mended there is
/// an error here that names the key ("recipe.loft.twist"), and so is a key of a part that nobody knows.
/// A whole document keeps such keys. Errors: JsonInvalid (with what is wrong), ProjectTooNew, those of
/// ribs::cleanSpine for the line of a part, OutOfMemory.
Result<document::Document> readRecipe(std::string_view json, const RecipeInput& input);

}  // namespace spineloft::io
