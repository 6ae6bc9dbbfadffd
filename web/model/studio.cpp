#include "web/model/studio.h"

#include <utility>

namespace spineloft::app {

Studio::Studio(platform::Host& host, int threads)
    : session_(host), derivation_(session_, host, pool_), saver_(session_, derivation_, host, pool_), pool_(threads) {}

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
  const SolidWork& solids = derivation_.solids();
  if (solids.busy()) return Activity{"Putting the parts together", solids.done()};
  return std::nullopt;
}

/// A cut-out on its way.
struct Studio::CutSearch {
  std::shared_ptr<const image::Picture> picture;
  vision::CutHints hints;
  std::function<void(Result<CutShape>)> done;
  std::optional<vision::CutOutSearch> rounds;
  Result<CutShape> found = Error::NothingCutOut;
  Progress progress;  ///< of the round that runs

  /// On a worker. False when it was the last round.
  bool step(const Progress& now) {
    if (!rounds) {
      Result<vision::CutOutSearch> begun = vision::CutOutSearch::begin(*picture, hints);
      if (!begun) {
        found = begun.failure();
        return false;
      }
      rounds.emplace(std::move(begun).value());
    }
    const bool more = rounds->step();
    if (!now.advance(rounds->done())) {
      found = Error::Cancelled;
      return false;
    }
    if (more) return true;
    Result<vision::CutContours> contours = rounds->outlines();
    if (contours) {
      found = filledShape(std::move(contours).value(), {picture->width, picture->height});
    } else {
      found = contours.failure();
    }
    return false;
  }
};

Status Studio::cutOut(PictureId id, const vision::CutHints& hints, std::function<void(Result<CutShape>)> done) {
  const document::PictureEntry* entry = document::findPicture(document(), id);
  if (entry == nullptr) return Error::NoSuchPicture;
  const Result<std::shared_ptr<const image::Picture>> pixels = derivation_.pixels(*entry);
  if (!pixels) return pixels.failure();
  stopCutOut();
  cutSearch_ = std::make_shared<CutSearch>();
  cutSearch_->picture = pixels.value();
  cutSearch_->hints = hints;
  cutSearch_->done = std::move(done);
  nextCutRound(cutSearch_);
  return Done{};
}

void Studio::nextCutRound(const std::shared_ptr<CutSearch>& search) {
  search->progress = pool_.submit(
      "Cutting it out", [search](const Progress& progress) { return search->step(progress); },
      [this, search](bool more) {
        if (search != cutSearch_) return;  // another one has begun, or nobody waits any more
        if (more) {
          nextCutRound(search);
          return;
        }
        cutSearch_.reset();
        search->done(std::move(search->found));
      });
}

void Studio::stopCutOut() {
  if (cutSearch_) cutSearch_->progress.cancel();
  cutSearch_.reset();
}

bool Studio::pump() {
  const bool changed = pool_.pump() > 0;
  if (changed) saver_.proceed();
  return changed;
}

void Studio::cancelWork() {
  pool_.cancelAll();
  saver_.cancel();
  derivation_.cancel();
}

}  // namespace spineloft::app
