// The cases of a data folder, read and ready to be scored.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/result.h"
#include "engine/image/image.h"
#include "engine/io/json_values.h"

namespace spineloft::cli {

/// The folders with a case.json: the given one, or those right below it, by name.
std::vector<std::filesystem::path> caseFolders(const std::string& root);

/// A case read into memory.
struct LoadedCase {
  io::BenchCase text;
  image::Picture picture;
  image::Mask mask;  ///< as large as the picture
};
/// Errors: those of reading files, pictures and JSON, with the path that is to blame.
Result<LoadedCase> loadCase(const std::filesystem::path& folder);

/// In which ways a case is hard; always one of "outline complete", "outline partly erased" and "outline half erased".
/// None where nothing is known of it.
std::vector<std::string> difficultyNames(const std::optional<io::BenchDifficulty>& difficulty);

/// All those names.
std::span<const std::string_view> difficultyOrder();

}  // namespace spineloft::cli
