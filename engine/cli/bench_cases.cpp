#include "engine/cli/bench_cases.h"

#include <algorithm>
#include <array>
#include <system_error>

#include "engine/cli/files.h"
#include "engine/io/picture_file.h"

namespace spineloft::cli {

namespace fs = std::filesystem;

namespace {

// From where on a case is hard in one way: % of its outline or pixels, edges every 1,000 px, and grey levels.
constexpr double kPartlyErased = 10, kHalfErased = 40, kFaint = 40, kHidden = 5, kBusy = 50, kNoisy = 6;
constexpr std::array<std::string_view, 7> kDifficulties{"outline complete",
                                                        "outline partly erased",
                                                        "outline half erased",
                                                        "outline faint",
                                                        "partly hidden",
                                                        "edges inside",
                                                        "noise"};

}  // namespace

std::vector<fs::path> caseFolders(const std::string& root) {
  std::vector<fs::path> folders;
  std::error_code problem;
  if (fs::exists(fs::path(root) / "case.json", problem)) return {fs::path(root)};
  for (const auto& entry : fs::directory_iterator(root, problem)) {
    if (fs::exists(entry.path() / "case.json", problem)) folders.push_back(entry.path());
  }
  std::sort(folders.begin(), folders.end());
  return folders;
}

Result<LoadedCase> loadCase(const fs::path& folder) {
  const Result<std::string> text = readText((folder / "case.json").string());
  if (!text.ok()) return text.failure();
  Result<io::BenchCase> parsed = io::readBenchCase(text.value());
  if (!parsed.ok()) return {parsed.error(), folder.string() + ": " + parsed.failure().detail};
  LoadedCase loaded{std::move(parsed).value(), {}, {}};
  const Result<Bytes> image = readFile((folder / loaded.text.image).string());
  if (!image.ok()) return image.failure();
  Result<image::Picture> picture = io::decodePicture(image.value(), Progress());
  if (!picture.ok()) return {picture.error(), (folder / loaded.text.image).string()};
  loaded.picture = std::move(picture).value();
  const Result<Bytes> maskFile = readFile((folder / loaded.text.mask).string());
  if (!maskFile.ok()) return maskFile.failure();
  Result<image::Mask> mask = io::decodeMask(maskFile.value());
  if (!mask.ok()) return {mask.error(), (folder / loaded.text.mask).string()};
  loaded.mask = std::move(mask).value();
  if (loaded.mask.width != loaded.picture.width || loaded.mask.height != loaded.picture.height) {
    return {Error::JsonInvalid, folder.string() + ": the mask is not as large as the picture"};
  }
  return loaded;
}

std::vector<std::string> difficultyNames(const std::optional<io::BenchDifficulty>& difficulty) {
  if (!difficulty) return {};
  const io::BenchDifficulty& d = *difficulty;
  const std::array<bool, kDifficulties.size()> is{
      d.missingOutlinePct < kPartlyErased,
      d.missingOutlinePct >= kPartlyErased && d.missingOutlinePct < kHalfErased,
      d.missingOutlinePct >= kHalfErased,
      d.faintOutlinePct >= kFaint,
      d.hiddenPct >= kHidden,
      d.innerEdges >= kBusy,
      d.noise >= kNoisy};
  std::vector<std::string> names;
  for (std::size_t i = 0; i < is.size(); ++i) {
    if (is[i]) names.emplace_back(kDifficulties[i]);
  }
  return names;
}

std::span<const std::string_view> difficultyOrder() { return kDifficulties; }

}  // namespace spineloft::cli
