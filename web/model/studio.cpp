#include "web/model/studio.h"

#include <utility>

namespace spineloft::app {

Studio::Studio(platform::Host& host, int threads)
    : session_(host),
      derivation_(session_, host, pool_),
      saver_(session_, derivation_, host, pool_),
      cutOut_(host, pool_),
      pool_(threads) {}

Status Studio::changed(Status status) {
  if (status) derivation_.documentChanged();
  return status;
}

void Studio::clear() {
  session_.clear();
  derivation_.documentChanged();
}

void Studio::open(document::History<document::Document> history) {
  cancelWork();
  session_.open(std::move(history));
  derivation_.forget();
  saver_.modelOpened();
}

const pipeline::Derived& Studio::derived() {
  derivation_.shown();
  saver_.proceed();
  return derivation_.shown();
}

bool Studio::takeSolid(const Json& answer, std::span<const std::uint8_t> bytes) {
  const bool changed = derivation_.takeSolid(answer, bytes);
  if (changed) saver_.proceed();
  return changed;
}

std::optional<Studio::Activity> Studio::activity() const {
  if (const auto activity = pool_.activity(); activity && !activity->label.empty()) {
    return Activity{activity->label, activity->progress.done()};
  }
  if (cutOut_.busy()) return Activity{"Cutting it out", cutOut_.done()};
  const SolidWork& solids = derivation_.solids();
  if (solids.busy()) return Activity{"Putting the parts together", solids.done()};
  return std::nullopt;
}

Status Studio::cutOut(PictureId id, const vision::CutHints& hints, CutOutWork::Finish done) {
  const document::PictureEntry* entry = document::findPicture(document(), id);
  if (entry == nullptr) return Error::NoSuchPicture;
  const Result<std::shared_ptr<const image::Picture>> pixels = derivation_.pixels(*entry);
  if (!pixels) return pixels.failure();
  cutOut_.begin({*pixels.value(), entry->contentHash}, hints, std::move(done));
  return Done{};
}

bool Studio::pump() {
  const bool changed = pool_.pump() > 0;
  if (changed) saver_.proceed();
  return changed;
}

void Studio::cancelWork() {
  pool_.cancelAll();
  cutOut_.cancel();
  saver_.cancel();
  derivation_.cancel();
}

}  // namespace spineloft::app
