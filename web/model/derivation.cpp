#include "web/model/derivation.h"

#include <algorithm>

#include "engine/base/hash.h"
#include "engine/document/pieces.h"
#include "engine/document/update.h"
#include "engine/pipeline/bridge_shape.h"
#include "engine/pipeline/drawing_shape.h"
#include "engine/vision/edges.h"
#include "web/model/messages.h"
#include "web/model/solid_faults.h"

namespace spineloft::app {
namespace {

struct EdgeSearch {
  Result<image::EdgeMap> edges;
  double ms = 0;
};

/// While the edges of a sketch with a new stroke are sought, its parts stay as they were.
void keepEarlierShapes(const pipeline::Derived& before, pipeline::Derived& now) {
  for (pipeline::DerivedPart& part : now.parts) {
    if (!part.waiting || part.shape) continue;
    const auto was = std::ranges::find(before.parts, part.id, &pipeline::DerivedPart::id);
    if (was != before.parts.end()) part.shape = was->shape;
  }
}

}  // namespace

Derivation::Derivation(const Session& session, platform::Host& host, WorkerPool& pool)
    : session_(session),
      host_(host),
      pool_(pool),
      solids_(host),
      reliefs_(
          pool_,
          [this](const pipeline::ReliefJob& job) {
            if (job.keepIn(cache_)) {
              stale_ = true;
            } else {
              sendError(host_, spokenFailure({Error::OutOfMemory, {}}));
            }
          },
          [this] { stale_ = true; }),
      textures_(
          pool_,
          [this](const pipeline::TextureJob& job) {
            cache_.assignTexture(job.key(), job.texture());
            stale_ = true;
          },
          [this] { stale_ = true; }) {}

void Derivation::documentChanged() {
  stale_ = true;
  opened_ = false;
  preview_.reset();
}

void Derivation::forget() {
  solids_.forget();
  cache_.clear();
  reported_.clear();
  toldReliefs_.clear();
  reportedSteps_.clear();
  documentChanged();
  opened_ = true;
}

const pipeline::Derived& Derivation::shown() {
  if (stale_) refresh();
  return preview_ ? *preview_ : derived_;
}

const pipeline::Derived& Derivation::settled() {
  if (stale_ || behind_) refresh();
  return derived_;
}

pipeline::Derived Derivation::make(const pipeline::Derived& before) {
  const auto clock = [this] { return host_.nowMs(); };
  pipeline::Derived now = pipeline::derive(document(), cache_, clock, pipeline::Finish::Later);
  keepEarlierShapes(before, now);
  keepEarlierReliefs(before, now);
  keepEarlierTextures(before, now);
  solids_.update(document(), now, finishing_ ? SolidWork::Alone::All : SolidWork::Alone::AsKnown);
  return now;
}

void Derivation::refresh() {
  stale_ = behind_ = false;
  pipeline::Derived now = make(derived_);
  const pipeline::Derived before = std::exchange(derived_, std::move(now));
  if (preview_) {
    std::vector<pipeline::DerivedStep> steps = std::move(preview_->steps);
    preview_ = derived_;
    preview_->steps = std::move(steps);
  }
  for (const PictureId id : derived_.wantedEdges) findEdges(id);
  reliefs_.update(wantedReliefs(document(), derived_));
  textures_.update(wantedTextures(document(), derived_));
  noteTimes(before);
  report();
  reportReliefs();
  reportSolids();
  if (allMade()) finishing_ = false;
}

void Derivation::noteTimes(const pipeline::Derived& before) {
  for (const pipeline::DerivedPart& part : derived_.parts) {
    const bool known = std::ranges::any_of(before.parts, [&](const pipeline::DerivedPart& other) {
      return part.shape && other.shape && part.shape->key == other.shape->key;
    });
    if (!part.shape || known) continue;
    lastMs_.ribs = part.shape->ms.ribs;
    lastMs_.loft = part.shape->ms.loft;
  }
}

void Derivation::report() {
  for (const pipeline::DerivedPart& part : derived_.parts) {
    if (!part.failure) continue;
    const std::pair entry{part.id, part.failure->error};
    if (std::ranges::count(reported_, entry)) continue;
    reported_.push_back(entry);
    sendError(host_, spokenFailure(*part.failure));
  }
}

void Derivation::reportReliefs() {
  for (const pipeline::DerivedPart& part : derived_.parts) {
    const document::Part* now = document::findPart(document(), part.id);
    const bool isMade = part.shape && !part.waiting && !part.wantedRelief;
    if (now == nullptr || !now->relief || !isMade) continue;
    const std::string_view words = reliefWords(*now->relief, *part.shape);
    std::string& told = toldReliefs_[part.id];  // undo and redo do not tell it again
    if (told == words) continue;
    told = words;
    if (!words.empty() && !opened_) sendHint(host_, words);  // what a file brings along is not told
  }
  if (shapesMade()) opened_ = false;
}

void Derivation::reportSolids() {
  for (const pipeline::DerivedStep& step : derived_.steps) {
    const std::pair entry{step.id, step.failure ? step.failure->error : Error::kCount};
    const auto told = std::ranges::find(reportedSteps_, step.id, &decltype(reportedSteps_)::value_type::first);
    if (told != reportedSteps_.end() && *told == entry) continue;
    if (told != reportedSteps_.end()) reportedSteps_.erase(told);
    if (!step.failure) continue;
    reportedSteps_.push_back(entry);
    const Error error = step.failure->error;
    if (isWithoutAnswer(error)) continue;  // told already
    const bool toldOfPart = std::ranges::any_of(derived_.parts, [&](const pipeline::DerivedPart& derived) {
      return derived.id == step.faulty && derived.failure && derived.failure->error == error;
    });
    if (toldOfPart) continue;
    sendError(host_, solidFailureSentence(document(), derived_, step));
  }
}

void Derivation::findEdges(PictureId id) {
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
    sendError(host_, spokenFailure(pixels.failure()));
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
          sendError(host_, spokenFailure(search.edges.failure()));
        }
        stale_ = true;
      });
}

Status Derivation::preview(const document::Recipe& recipe, pipeline::Worked worked, pipeline::PartShape& shape) {
  return pipeline::previewShape(document(), recipe, cache_, shape, [this] { return host_.nowMs(); }, worked);
}

Status Derivation::previewLive(const document::Recipe& recipe, pipeline::Worked worked, pipeline::PartShape& shape) {
  return pipeline::liveShape(document(), recipe, cache_, shape, [this] { return host_.nowMs(); }, worked);
}

std::vector<PicturePoint> Derivation::strokeOnThing(const document::LoftRecipe& recipe) {
  return pipeline::strokeOnThing(document(), recipe, cache_);
}

namespace {

bool hasBridges(const document::Document& document) {
  return std::ranges::any_of(document.parts, [](const document::Part& part) { return document::bridgeOf(part); });
}

}  // namespace

void Derivation::carryBridges(const document::Document& document, const publish::Substitute* instead) {
  for (pipeline::DerivedPart& derived : preview_->parts) {
    const document::Part* part = document::findPart(document, derived.id);
    const document::BridgeRecipe* bridge = part ? document::bridgeOf(*part) : nullptr;
    if (bridge == nullptr || !derived.shape) continue;
    const auto meshOf = [&](PartId host) -> const mesh::TriMesh* {
      const document::Part* in = document::findPart(document, host);
      // Below its relief nothing is known of it: the bridge goes along when the hand lets go.
      if (instead != nullptr && instead->part == host) return in && in->relief ? nullptr : instead->mesh;
      const auto at = std::ranges::find(preview_->parts, host, &pipeline::DerivedPart::id);
      return at == preview_->parts.end() || !at->shape ? nullptr : &smoothMesh(*at->shape);
    };
    const document::PictureEntry* entry = document::findPicture(document, bridge->picture);
    const mesh::TriMesh *from = meshOf(bridge->from.part), *to = meshOf(bridge->to.part);
    if (entry == nullptr || from == nullptr || to == nullptr) continue;
    ShapeKey key = pipeline::shapeKey(*part, *entry, document);
    if (instead != nullptr && (instead->part == bridge->from.part || instead->part == bridge->to.part)) {
      key = ShapeKey{Hasher().text("carried").number(key.hash).number(instead->key.hash).value()};
    }
    if (derived.shape->key == key) continue;
    auto shape = std::make_shared<pipeline::PartShape>(*derived.shape);
    if (Result<pipeline::PartShape> made = pipeline::bridgeStage(*bridge, document, *from, *to)) {
      shape->mesh = std::move(made.value().mesh);
      shape->smooth.reset();
      shape->relief.reset();
      shape->rims = std::move(made.value().rims);
      // A failure leaves the mesh without its pulls: better than none while a hand moves.
      if (!part->pulls.empty()) {
        static_cast<void>(pipeline::pullStage(part->pulls, {}, pipeline::TraceQuality::Live, cache_, *shape));
      }
    }
    shape->key = key;  // one that cannot be made stays as it was, and is not tried again
    derived.shape = std::move(shape);
  }
}

void Derivation::layPreview(const document::Document& document, const publish::Substitute* instead) {
  shown();
  if (!preview_) preview_ = derived_;
  carryBridges(document, instead);
  solids_.preview(document, *preview_, instead);
}

void Derivation::previewSolid(const publish::Substitute& instead) {
  if (!document().steps.empty() || hasBridges(document())) layPreview(document(), &instead);
}

void Derivation::previewPlaced(const document::PlaceParts& places) {
  if (document().steps.empty() && !hasBridges(document())) return;
  if (const Result<document::Document> placed = document::update(document(), places)) {
    layPreview(placed.value(), nullptr);
  }
}

void Derivation::previewPinned(const document::PinDepth& pin) {
  const Result<document::Document> next = document::update(document(), pin);
  const document::Drawing* drawing = next ? document::findDrawing(next.value(), pin.drawing) : nullptr;
  if (drawing == nullptr) return;
  // Not through the cache: what a drag passes over would push out what the document needs.
  const document::PlainDrawing plain = document::plainDrawing(next.value(), *drawing);
  const auto solved = std::make_shared<const pipeline::DrawingShape>(pipeline::drawingStage(plain.drawing));
  if (solved->failure) return;
  shown();
  preview_ = derived_;
  for (pipeline::DerivedDrawing& one : preview_->drawings) {
    if (one.id == pin.drawing) one.shape = solved;
  }
  for (std::size_t i = 0; i < plain.pieces.size(); ++i) {
    const auto part = std::ranges::find(preview_->parts, plain.pieces[i], &pipeline::DerivedPart::id);
    if (part == preview_->parts.end() || !part->shape) continue;
    auto shape = std::make_shared<pipeline::PartShape>(*part->shape);
    if (!pipeline::elementStage(*solved, i, *shape)) continue;
    const document::Part* piece = document::findPart(next.value(), plain.pieces[i]);
    const std::span<const pull::Pull> pulls = piece ? std::span(piece->pulls) : std::span<const pull::Pull>();
    if (!pulls.empty() && !pipeline::pullStage(pulls, {}, pipeline::TraceQuality::Live, cache_, *shape)) continue;
    shape->key = ShapeKey{Hasher().text("pinned").number(part->shape->key.hash).number(pin.z.value_or(0)).value()};
    part->shape = std::move(shape);
  }
  if (!next.value().steps.empty()) solids_.preview(next.value(), *preview_, nullptr);
}

void Derivation::endPreview() {
  if (!preview_) return;
  preview_.reset();
  stale_ = true;
}

void Derivation::expectEdit(PartId part) {
  const bool isInSolid = part && document::rootOf(document(), {part, {}}) != nullptr;
  solids_.expect(isInSolid ? part : PartId{});
}

bool Derivation::takeSolid(const Json& answer, std::span<const std::uint8_t> bytes) {
  if (!solids_.take(answer, bytes)) return false;
  if (answer.find("progress") == nullptr) (preview_ ? behind_ : stale_) = true;
  return true;
}

void Derivation::solveAgain() {
  solids_.again();
  reportedSteps_.clear();
  documentChanged();
}

bool Derivation::finishParts() {
  settled();
  if (!finishing_) solids_.forgetUnanswered(derived_);
  finishing_ = true;
  stale_ = true;
  settled();
  return shapesMade();
}

std::vector<PartId> Derivation::crossingParts() {
  std::vector<PartId> parts;
  for (const pipeline::DerivedPart& part : settled().parts) {
    if (part.crossesAt) parts.push_back(part.id);
  }
  return parts;
}

void Derivation::finishNow() {
  settled();
  for (const ReliefWork::Wanted& one : wantedReliefs(document(), derived_)) {
    reliefs_.finish({one});  // one by one: the cache holds a few
    settled();
  }
  textures_.finish(wantedTextures(document(), derived_));
  settled();
}

void Derivation::cancel() {
  finishing_ = false;
  if (!solids_.busy()) return;
  solids_.cancel();
  stale_ = true;
}

}  // namespace spineloft::app
