#include "engine/cli/bench_cases.h"

#include <algorithm>
#include <iomanip>
#include <sstream>
#include <system_error>

#include "engine/cli/files.h"
#include "engine/io/picture_file.h"

namespace spineloft::cli {

namespace fs = std::filesystem;

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

std::string markdownOf(const std::vector<std::pair<std::string, io::NamedNumbers>>& lines) {
  std::ostringstream out;
  out << "| |";
  for (const auto& [name, value] : lines.front().second) out << ' ' << name << " |";
  out << "\n|:--|";
  for (std::size_t i = 0; i < lines.front().second.size(); ++i) out << "--:|";
  for (const auto& [title, numbers] : lines) {
    out << "\n| " << title << " |" << std::fixed;
    for (const auto& [name, value] : numbers) {
      out << ' ' << std::setprecision(name.back() == '%' ? 1 : 3) << value << " |";
    }
  }
  out << '\n';
  return out.str();
}

}  // namespace spineloft::cli
