#include "web/model/keeping.h"
#include "web/words/words.h"

#include <utility>

#include "engine/io/journal.h"
#include "engine/io/json_fields.h"
#include "engine/io/project_file.h"
#include "engine/io/share_text.h"

namespace spineloft::app {

std::string Keeping::history() const { return io::writeHistory(studio_.history()); }

std::vector<std::string> Keeping::photos() const {
  std::vector<std::string> keys;
  for (const std::uint64_t hash : io::photosOf(studio_.history())) keys.push_back(io::hashKey(hash));
  return keys;
}

std::shared_ptr<const image::Picture> Keeping::photo(std::string_view hash) const {
  const std::optional<std::uint64_t> wanted = io::hashFromKey(hash);
  const auto& history = studio_.history();
  for (std::size_t i = 0; wanted && i <= history.undoSteps() + history.redoSteps(); ++i) {
    for (const document::PictureEntry& entry : history.at(i).pictures) {
      if (!entry.isSketch() && entry.contentHash == *wanted) return entry.picture;
    }
  }
  return nullptr;
}

std::string Keeping::layBy(image::Picture photo) {
  const std::uint64_t hash = document::contentHash(photo);
  laidBy_[hash] = std::make_shared<const image::Picture>(std::move(photo));
  return io::hashKey(hash);
}

Result<std::size_t> Keeping::restore(std::string_view base, std::span<const std::string> records) {
  const auto photos = std::exchange(laidBy_, {});
  if (base.empty()) {
    studio_.open(io::DocumentHistory());
    return std::size_t{0};
  }
  Result<io::ReadHistory> read =
      io::readHistory(base, records, [&](std::uint64_t hash) -> std::shared_ptr<const image::Picture> {
        const auto at = photos.find(hash);
        return at == photos.end() ? nullptr : at->second;
      });
  if (!read) return read.failure();
  studio_.open(std::move(read.value().history));
  return read.value().dropped;
}

Result<std::string> Keeping::openProject(std::span<const std::uint8_t> file,
                                         const std::map<PictureId, std::string>& photos) {
  const auto laidBy = std::exchange(laidBy_, {});
  io::CopiedPhotos copied;
  for (const auto& [picture, hash] : photos) {
    const auto at = laidBy.find(io::hashFromKey(hash).value_or(0));
    if (at != laidBy.end()) copied.emplace(picture, at->second);
  }
  io::ReadNotes notes;
  const auto link = io::textOfLink({reinterpret_cast<const char*>(file.data()), file.size()});
  Result<document::Document> document = link ? io::readShareText(*link, &notes, copied) : io::readProject(file, &notes);
  if (!document) return document.failure();
  studio_.open(io::DocumentHistory(std::move(document).value()));
  if (notes.clean()) return std::string();
  if (notes.dropped == 0) return std::string("Some numbers of this file were damaged and have been mended.");
  return std::string(words::tr(notes.dropped == 1 ? "This file is damaged: 1 picture or part could not be read."
                                                  : "This file is damaged: {n} pictures and parts could not be read.",
                               {{"n", notes.dropped}}));
}

}  // namespace spineloft::app
