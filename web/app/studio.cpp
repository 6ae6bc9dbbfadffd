#include "web/app/studio.h"

#include <algorithm>

#include "engine/document/update.h"
#include "engine/vision/edges.h"
#include "web/app/messages.h"

namespace spineloft::app {
namespace {

constexpr double kBurstMs = 1000;  // between two keys that belong together

struct EdgeSearch {
  Result<image::EdgeMap> edges;
  double ms = 0;
};

}  // namespace

Studio::Studio(platform::Host& host, int threads) : host_(host), pool_(threads) {}

Status Studio::act(std::span<const document::Action> actions, std::string_view burst) {
  document::Document next = document();
  for (const document::Action& action : actions) {
    Result<document::Document> result = document::update(next, action);
    if (!result) return result.failure();
    next = std::move(result).value();
  }
  const double now = host_.nowMs();
  const bool goesOn = !burst.empty() && burst == burst_ && now - burstMs_ < kBurstMs &&
                      undoSteps() == burstStep_ && redoSteps() == 0;
  if (goesOn) static_cast<void>(history_.undo());
  history_.commit(std::move(next));
  burst_ = burst;
  burstMs_ = now;
  burstStep_ = undoSteps();
  changed();
  return Done{};
}

Status Studio::undo() {
  Status status = history_.undo();
  if (status) changed();
  return status;
}

Status Studio::redo() {
  Status status = history_.redo();
  if (status) changed();
  return status;
}

void Studio::clear() {
  document::Document empty;
  empty.lastPictureId = document().lastPictureId;
  empty.lastPartId = document().lastPartId;
  history_.commit(std::move(empty));
  changed();
}

void Studio::changed() {
  stale_ = true;
  ++revision_;
}

const pipeline::Derived& Studio::derived() {
  if (!stale_) return derived_;
  stale_ = false;
  const pipeline::Derived before = std::exchange(
      derived_, pipeline::derive(document(), cache_, [this] { return host_.nowMs(); }));
  for (const PictureId id : derived_.wantedEdges) findEdges(id);
  keepShown(before);
  for (const pipeline::DerivedPart& part : derived_.parts) {
    const bool known = std::ranges::count(before.parts, part.shape, &pipeline::DerivedPart::shape);
    if (!part.shape || known) continue;
    lastMs_.ribs = part.shape->ms.ribs;
    lastMs_.loft = part.shape->ms.loft;
  }
  report(derived_);
  return derived_;
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
          cache_.keepEdges(hash,
                           std::make_shared<const image::EdgeMap>(std::move(search.edges).value()));
        } else {
          // An empty map means "no evidence": parts are made all the same, with guessed ribs.
          cache_.keepEdges(hash, std::make_shared<const image::EdgeMap>());
          sendError(host_, failureSentence(search.edges.failure()));
        }
        changed();
      });
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

Result<pipeline::PartShape> Studio::preview(const document::LoftRecipe& recipe) {
  return pipeline::previewShape(document(), recipe, cache_, [this] { return host_.nowMs(); });
}

Status Studio::save(publish::Format format) {
  if (document().parts.empty()) return Error::NothingToExport;
  const document::Document written = document();
  pool_.submit(
      "Saving the model",
      [written, derived = derived(), format](const Progress& progress) {
        return publish::publish(written, derived, format, progress);
      },
      [this, format, written](Result<publish::Bytes> bytes) {
        finishSave(std::move(bytes), format, written);
      });
  return Done{};
}

void Studio::finishSave(Result<publish::Bytes> bytes, publish::Format format,
                        const document::Document& written) {
  ++revision_;
  if (!bytes) {
    sendError(host_, failureSentence(bytes.failure()));
    return;
  }
  host_.sendFile(publish::fileName(written, format), publish::mediaType(format), bytes.value());
  saved_ = written;
}

Result<publish::Bytes> Studio::publishNow(publish::Format format) {
  return publish::publish(document(), derived(), format, Progress{});
}

bool Studio::pump() { return pool_.pump() > 0; }

void Studio::cancelWork() { pool_.cancelAll(); }

bool Studio::unsaved() const { return !document().parts.empty() && document() != saved_; }

}  // namespace spineloft::app
