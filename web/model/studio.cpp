#include "web/model/studio.h"

#include <algorithm>

#include "engine/document/update.h"
#include "engine/io/journal.h"
#include "engine/vision/edges.h"
#include "web/model/messages.h"
#include "web/model/solid_faults.h"

namespace spineloft::app {
namespace {

constexpr double kBurstMs = 1000;  // between two keys that belong together
/// A burst that goes on is told this often.
constexpr double kAmendMs = 250;

/// Content hashes of the photos that `after` shows and `before` does not.
std::vector<std::uint64_t> newPhotos(const document::Document& before, const document::Document& after) {
  std::vector<std::uint64_t> hashes;
  for (const document::PictureEntry& entry : after.pictures) {
    const bool known = std::ranges::any_of(before.pictures, [&](const document::PictureEntry& old) {
      return !old.isSketch() && old.contentHash == entry.contentHash;
    });
    if (!entry.isSketch() && !known) hashes.push_back(entry.contentHash);
  }
  return hashes;
}

struct EdgeSearch {
  Result<image::EdgeMap> edges;
  double ms = 0;
};

}  // namespace

Studio::Studio(platform::Host& host, int threads)
    : host_(host),
      solids_(host),
      traces_(pool_, [this](const pipeline::TraceJob& making) { takeTrace(making); }),
      textures_(pool_, [this](const pipeline::TextureJob& making) { takeTexture(making); }),
      pool_(threads) {}

Status Studio::act(std::span<const document::Action> actions, std::string_view burst) {
  document::Document next = document();
  for (const document::Action& action : actions) {
    Result<document::Document> result = document::update(next, action);
    if (!result) return result.failure();
    next = std::move(result).value();
  }
  const double now = host_.nowMs();
  const bool goesOn = !burst.empty() && burst == burst_ && now - burstMs_ < kBurstMs;
  if (!goesOn) ++gesture_;
  burst_ = burst;
  burstMs_ = now;
  const document::Document before = document();
  tell(history_.commit(std::move(next), burst.empty() ? 0 : gesture_), before);
  changed();
  return Done{};
}

Status Studio::undo() {
  sendAmends(true);
  Status status = history_.undo();
  if (!status) return status;
  sendRecord(io::undoRecord(), document());
  changed();
  return status;
}

Status Studio::redo() {
  sendAmends(true);
  Status status = history_.redo();
  if (!status) return status;
  sendRecord(io::redoRecord(), document());
  changed();
  return status;
}

void Studio::open(document::History<document::Document> history) {
  sendAmends(true);
  cancelWork();
  solids_.forget();
  history_ = std::move(history);
  saved_ = document();
  reported_.clear();
  reportedSteps_.clear();
  saveWaiting_.reset();
  changed();
}

void Studio::tell(document::Committed committed, const document::Document& before) {
  if (committed == document::Committed::Amended) {
    if (amendedFrom_) return;
    amendedFrom_ = before;
    amendedMs_ = host_.nowMs();
    host_.wakeAfter(kAmendMs);
  } else if (committed == document::Committed::Step) {
    if (amendedFrom_) sendRecord(io::amendRecord(*amendedFrom_, before), *amendedFrom_);
    amendedFrom_.reset();
    sendRecord(io::commitRecord(before, document()), before);
  }
}

void Studio::sendAmends(bool now) {
  if (!amendedFrom_) return;
  const double left = kAmendMs - (host_.nowMs() - amendedMs_);
  if (!now && left > 1) {
    host_.wakeAfter(left);
    return;
  }
  const document::Document from = std::move(*amendedFrom_);
  amendedFrom_.reset();
  sendRecord(io::amendRecord(from, document()), from);
}

void Studio::sendRecord(std::string record, const document::Document& before) {
  sendJournal(host_, {record, newPhotos(before, document()), document()});
}

void Studio::clear() {
  document::Document empty;
  empty.lastPictureId = document().lastPictureId;
  empty.lastPartId = document().lastPartId;
  empty.lastStepId = document().lastStepId;
  const document::Document before = document();
  tell(history_.commit(std::move(empty)), before);
  changed();
}

void Studio::changed() {
  stale_ = true;
  ++revision_;
}

const pipeline::Derived& Studio::derived() {
  if (!stale_) return derived_;
  stale_ = false;
  const auto clock = [this] { return host_.nowMs(); };
  const pipeline::Derived before =
      std::exchange(derived_, pipeline::derive(document(), cache_, clock, pipeline::Finish::Later));
  for (const PictureId id : derived_.wantedEdges) findEdges(id);
  keepShown(before);
  keepEarlierTextures(before, derived_);
  traces_.update(wantedTraces(document(), derived_, cache_));
  textures_.update(wantedTextures(document(), derived_));
  noteTimes(before);
  report(derived_);
  updateSolids();
  saveWaiting();
  return derived_;
}

// What a person waited for: where perturbed strokes were asked meanwhile, the time of the stroke stays.
void Studio::noteTimes(const pipeline::Derived& before) {
  for (const pipeline::DerivedPart& part : derived_.parts) {
    const bool known = std::ranges::any_of(before.parts, [&](const pipeline::DerivedPart& other) {
      if (!part.shape || !other.shape) return false;
      const bool asked = other.id == part.id && other.shape->quality != part.shape->quality &&
                         part.shape->quality == pipeline::TraceQuality::Ensemble;
      return asked || part.shape->key == other.shape->key;
    });
    if (!part.shape || known) continue;
    lastMs_.ribs = part.shape->ms.ribs;
    lastMs_.loft = part.shape->ms.loft;
  }
}

void Studio::updateSolids() {
  previewing_ = false;
  solids_.update(document(), derived_, finishing_ ? SolidWork::Alone::All : SolidWork::Alone::AsKnown);
  reportSolids();
}

void Studio::reportSolids() {
  for (const pipeline::DerivedStep& step : derived_.steps) {
    const std::pair entry{step.id, step.failure ? step.failure->error : Error::kCount};
    const auto told = std::ranges::find(reportedSteps_, step.id, &decltype(reportedSteps_)::value_type::first);
    if (told != reportedSteps_.end() && *told == entry) continue;
    if (told != reportedSteps_.end()) reportedSteps_.erase(told);
    if (!step.failure) continue;
    reportedSteps_.push_back(entry);
    const Error error = step.failure->error;
    if (error == Error::Cancelled || error == Error::SolverStopped) continue;  // told already
    const bool toldOfPart = std::ranges::any_of(derived_.parts, [&](const pipeline::DerivedPart& derived) {
      return derived.id == step.faulty && derived.failure && derived.failure->error == error;
    });
    if (toldOfPart) continue;
    sendError(host_, solidFailureSentence(document(), derived_, step));
  }
}

bool Studio::takeSolid(const Json& answer, std::span<const std::uint8_t> bytes) {
  if (!solids_.take(answer, bytes)) return false;
  ++revision_;
  if (answer.find("progress") != nullptr) return true;
  if (!stale_ && !previewing_) updateSolids();
  saveWaiting();
  return true;
}

void Studio::takeTrace(const pipeline::TraceJob& making) {
  pipeline::takeTrace(making, cache_);
  changed();
  if (saveWaiting_ || finishing_) derived();
}

void Studio::takeTexture(const pipeline::TextureJob& making) {
  const std::shared_ptr<const pipeline::PartShape> dressed = cache_.assignTextures(making.key(), making.texture());
  for (pipeline::DerivedPart& part : derived_.parts) {
    if (dressed && part.shape && part.shape->key == making.key()) part.shape = dressed;
  }
  ++revision_;
  saveWaiting();
}

void Studio::saveWaiting() {
  if (!allMade()) return;
  // A preview shows what a file does not hold.
  if (finishing_ && previewing_) updateSolids();
  if (!allMade()) return;
  finishing_ = false;
  if (!saveWaiting_) return;
  const publish::Format format = *std::exchange(saveWaiting_, std::nullopt);
  if (const Status status = saveNow(format); !status) sendError(host_, failureSentence(status.failure()));
}

void Studio::previewSolid(const publish::Substitute& instead) {
  if (document().steps.empty()) return;
  previewing_ = true;
  solids_.preview(document(), derived_, &instead);
}

void Studio::previewPlaced(const document::PlaceParts& places) {
  if (document().steps.empty()) return;
  const Result<document::Document> placed = document::update(document(), places);
  if (!placed) return;
  previewing_ = true;
  solids_.preview(placed.value(), derived_, nullptr);
}

void Studio::expectEdit(PartId part) {
  const bool isInSolid = part && document::rootOf(document(), {part, {}}) != nullptr;
  solids_.expect(isInSolid ? part : PartId{});
}

void Studio::endPreview() {
  if (previewing_) updateSolids();
}

void Studio::solveAgain() {
  solids_.again();
  reportedSteps_.clear();
  changed();
}

std::optional<Studio::Activity> Studio::activity() const {
  if (const auto activity = pool_.activity(); activity && !activity->label.empty()) {
    return Activity{activity->label, activity->progress.done()};
  }
  if (solids_.busy()) return Activity{"Putting the parts together", solids_.done()};
  return std::nullopt;
}

/// While the edges of a sketch with a new stroke are sought, its parts stay as they were.
void Studio::keepShown(const pipeline::Derived& before) {
  for (pipeline::DerivedPart& part : derived_.parts) {
    if (!part.waiting || part.shape) continue;
    const auto was = std::ranges::find(before.parts, part.id, &pipeline::DerivedPart::id);
    if (was != before.parts.end()) part.shape = was->shape;
  }
}

void Studio::findEdges(PictureId id) {
  const document::PictureEntry* entry = document::findPicture(document(), id);
  if (entry == nullptr) return;
  const std::uint64_t hash = entry->contentHash;
  // A sketch changes faster than its edges are found: one search at a time, the next one begins with
  // what is on the paper then.
  const auto covered = [&](const Search& search) {
    return search.contentHash == hash || (entry->isSketch() && search.picture == id);
  };
  if (std::ranges::any_of(searching_, covered)) return;
  const Result<std::shared_ptr<const image::Picture>> pixels = cache_.pixels(*entry);
  if (!pixels) {
    sendError(host_, failureSentence(pixels.failure()));
    return;
  }
  searching_.push_back({id, hash});
  platform::Host* host = &host_;
  pool_.submit(
      "Looking for edges",
      [picture = pixels.value(), host](const Progress& progress) {
        const double start = host->nowMs();
        Result<image::EdgeMap> edges = vision::detectEdges(*picture, {}, progress);
        return EdgeSearch{std::move(edges), host->nowMs() - start};
      },
      [this, hash](EdgeSearch search) {
        std::erase_if(searching_, [&](const Search& s) { return s.contentHash == hash; });
        if (search.edges) {
          lastMs_.edges = search.ms;
          cache_.keepEdges(hash, std::make_shared<const image::EdgeMap>(std::move(search.edges).value()));
        } else {
          // An empty map means "no evidence": parts are made all the same, with guessed ribs.
          cache_.keepEdges(hash, std::make_shared<const image::EdgeMap>());
          sendError(host_, failureSentence(search.edges.failure()));
        }
        changed();
      });
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
  const Result<std::shared_ptr<const image::Picture>> pixels = cache_.pixels(*entry);
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
        ++revision_;
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

void Studio::report(const pipeline::Derived& derived) {
  for (const pipeline::DerivedPart& part : derived.parts) {
    if (!part.failure) continue;
    const std::pair entry{part.id, part.failure->error};
    if (std::ranges::count(reported_, entry)) continue;
    reported_.push_back(entry);
    sendError(host_, failureSentence(*part.failure));
  }
}

Status Studio::preview(const document::Recipe& recipe, pipeline::PartShape& shape) {
  return pipeline::previewShape(document(), recipe, cache_, shape, [this] { return host_.nowMs(); });
}

Status Studio::previewLive(const document::Recipe& recipe, pipeline::PartShape& shape) {
  return pipeline::liveShape(document(), recipe, cache_, shape, [this] { return host_.nowMs(); });
}

std::vector<PicturePoint> Studio::strokeOnThing(const document::LoftRecipe& recipe) {
  return pipeline::strokeOnThing(document(), recipe, cache_);
}

Status Studio::save(publish::Format format) {
  // Work in progress is kept at once, and needs no solid.
  if (format == publish::Format::Project) {
    derived();
  } else {
    finishParts();
  }
  if (allMade()) return saveNow(format);
  saveWaiting_ = format;
  return Done{};
}

bool Studio::finishParts() {
  derived();
  if (!finishing_) solids_.refineLabels(derived_);
  finishing_ = true;
  updateSolids();
  finishing_ = !allMade();
  return shapesMade();
}

std::vector<PartId> Studio::crossingParts() {
  std::vector<PartId> parts;
  for (const pipeline::DerivedPart& part : derived().parts) {
    if (part.crossesAt) parts.push_back(part.id);
  }
  return parts;
}

Status Studio::saveNow(publish::Format format) {
  if (document().parts.empty() && format != publish::Format::Project) return Error::NothingToExport;
  reportFaults(format);
  const document::Document written = document();
  pool_.submit(
      "Saving the model",
      [written, derived = derived(), format](const Progress& progress) {
        return publish::publish(written, derived, format, progress);
      },
      [this, format, written](Result<publish::Bytes> bytes) { finishSave(std::move(bytes), format, written); });
  return Done{};
}

void Studio::finishSave(Result<publish::Bytes> bytes, publish::Format format, const document::Document& written) {
  ++revision_;
  if (!bytes) {
    sendError(host_, failureSentence(bytes.failure()));
    return;
  }
  host_.sendFile(publish::fileName(written, format), publish::mediaType(format), bytes.value());
  if (publish::holdsDocument(format)) saved_ = written;
}

Result<publish::Bytes> Studio::publishNow(publish::Format format) {
  derived();
  traces_.finish(wantedTraces(document(), derived_, cache_));
  derived();
  textures_.finish(wantedTextures(document(), derived_));
  reportFaults(format);
  return publish::publish(document(), derived_, format, Progress{});
}

void Studio::reportFaults(publish::Format format) {
  // A model file holds what it is made of, whatever became of it here.
  if (format == publish::Format::Project) return;
  const std::string faults = faultsOf(document(), derived_);
  if (!faults.empty()) sendWarning(host_, "In the file, " + faults);
  for (const PartId id : crossingParts()) {
    const document::Part* part = document::findPart(document(), id);
    sendWarning(host_, failureSentence({Error::PartCrossesItself, part ? part->name : std::string()}));
  }
}

bool Studio::pump() { return pool_.pump() > 0; }

void Studio::cancelWork() {
  pool_.cancelAll();
  saveWaiting_.reset();
  finishing_ = false;
  if (!solids_.busy()) return;
  solids_.cancel();
  if (!stale_) updateSolids();
  ++revision_;
}

bool Studio::unsaved() const { return !document().parts.empty() && document() != saved_; }

}  // namespace spineloft::app
