#include "tests/support/sessions.h"

#include "engine/document/update.h"
#include "tests/support/random_documents.h"

namespace spineloft::testing {

std::vector<document::Document> randomSession(std::uint64_t seed, int steps, ActionCounts* succeeded) {
  Rng rng(seed);
  std::vector<document::Document> documents(1);
  for (int step = 0; step < steps; ++step) {
    const document::Action action = randomAction(rng, documents.back());
    const Result<document::Document> next = document::update(documents.back(), action);
    if (!next) continue;
    if (succeeded != nullptr) ++(*succeeded)[action.index()];
    if (next.value() != documents.back()) documents.push_back(next.value());
  }
  return documents;
}

std::function<std::shared_ptr<const image::Picture>(std::uint64_t)> photosOfAll(
    const std::vector<document::Document>& documents) {
  std::map<std::uint64_t, std::shared_ptr<const image::Picture>> photos;
  for (const document::Document& document : documents) {
    for (const document::PictureEntry& entry : document.pictures) {
      if (entry.picture) photos[entry.contentHash] = entry.picture;
    }
  }
  return [photos](std::uint64_t hash) {
    const auto at = photos.find(hash);
    return at == photos.end() ? nullptr : at->second;
  };
}

}  // namespace spineloft::testing
