#include "engine/pipeline/derive.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <new>
#include <span>
#include <utility>

#include "engine/document/pieces.h"
#include "engine/pipeline/bridge_shape.h"
#include "engine/pipeline/keys.h"
#include "engine/pipeline/outline_ink.h"
#include "engine/pipeline/part_texture.h"
#include "engine/pipeline/relief_shape.h"
#include "engine/ribs/search/overshoot.h"

namespace spineloft::pipeline {
namespace {

double nowMs(const Clock& clock) { return clock ? clock() : 0.0; }

// Null where nothing is scribbled over.
Result<std::shared_ptr<const ribs::IgnoredEdges>> ignoredEdgesOf(const document::LoftRecipe& recipe,
                                                                 const document::PictureEntry& entry,
                                                                 const image::EdgeMap& edges, Cache& cache) {
  if (entry.ignored.empty() && recipe.ignored.empty()) return std::shared_ptr<const ribs::IgnoredEdges>{};
  const IgnoredKey key = ignoredKey(recipe, entry);
  std::shared_ptr<const ribs::IgnoredEdges> known = cache.ignored(key);
  if (known) return known;
  Result<ribs::IgnoredEdges> made = ignoredStage(edges, entry.ignored, recipe.ignored);
  if (!made) return made.failure();
  known = std::make_shared<const ribs::IgnoredEdges>(std::move(made).value());
  cache.keepIgnored(key, known);
  return known;
}

// What a shape is made for: a part of the document, a preview of one, or one whose stroke is being drawn.
enum class Purpose : std::uint8_t { Part, Preview, Live };

// The shape of a loft, with the ribs that are traced already or the edges that are known.
Status loftShape(const document::LoftRecipe& recipe, const document::PictureEntry& entry, Cache& cache, Purpose purpose,
                 PartShape& shape, const Clock& clock) {
  static const image::EdgeMap kNoEdges;
  const double started = nowMs(clock);
  const bool live = purpose == Purpose::Live;
  const TraceKey key = traceKey(recipe, entry);
  const std::shared_ptr<const image::EdgeMap> edges = cache.edges(entry.contentHash);
  // Without edges the ribs are guessed: that is no result to keep.
  std::shared_ptr<const TracedRibs> traced;
  if (edges) traced = cache.traced(key);
  if (traced && purpose == Purpose::Part) cache.keepTraced(key, traced, false);
  if (!traced) {
    std::shared_ptr<const ribs::IgnoredEdges> ignored;
    if (edges) {
      Result<std::shared_ptr<const ribs::IgnoredEdges>> found = ignoredEdgesOf(recipe, entry, *edges, cache);
      if (!found) return found.failure();
      ignored = std::move(found).value();
    }
    const ribs::PictureEvidence evidence{edges ? *edges : kNoEdges, entry.size, ignored.get()};
    if (live) {
      if (Status made = liveStage(recipe, evidence, cache.live()); !made.ok()) return made;
    } else {
      Result<TracedRibs> made = traceStage(recipe, evidence, Progress{}, cache.ribMemory());
      if (!made) return made.failure();
      traced = std::make_shared<const TracedRibs>(std::move(made).value());
      if (edges) cache.keepTraced(key, traced, purpose == Purpose::Preview);
    }
  }
  const double took = nowMs(clock) - started;
  const TracedRibs& ribs = traced ? *traced : cache.live().traced;
  Status made = shapeStage(recipe, ribs, entry.size, cache.shapeMemory(), shape, clock);
  if (made.ok()) shape.ms.ribs += took;
  return made;
}

bool needsEdges(const document::Recipe& recipe) { return document::kindOf(recipe) == document::PartKind::Loft; }

// What a shape is made from: a recipe, its own picture, and the document with the others.
struct Made {
  const document::Recipe& recipe;
  const document::PictureEntry& entry;
  const document::Document& document;
  PartId part;  ///< which it is, where it is one of the document's
  Worked worked = {};
  Search search = Search::Known;
};

std::shared_ptr<const DrawingShape> solved(const descriptive::Drawing& drawing, Cache& cache) {
  const DrawingKey key = drawingKey(drawing);
  if (auto known = cache.drawing(key)) return known;
  auto made = std::make_shared<const DrawingShape>(drawingStage(drawing));
  cache.keepDrawing(key, made);
  return made;
}

// The shape of a piece, of its drawing that is solved already or now.
Status elementShape(const document::ElementRecipe& recipe, const Made& from, Cache& cache, PartShape& shape,
                    const Clock& clock) {
  const double started = nowMs(clock);
  const PieceIn piece = pieceIn(from.document, recipe, from.part);
  const std::shared_ptr<const DrawingShape> drawing = solved(piece.drawing, cache);
  if (Status made = elementStage(*drawing, piece.number, shape); !made.ok()) return made;
  shape.ms.loft = nowMs(clock) - started;
  return Done{};
}

// The shape of a host: the one that is known, or made now.
Result<std::shared_ptr<const PartShape>> hostShape(const document::Document& document, const document::BridgeEnd& end,
                                                   Cache& cache, const Clock& clock);

// The shape of a bridge, of the parts that it stands on.
Status bridgeShape(const document::BridgeRecipe& recipe, const document::Document& document, Cache& cache,
                   PartShape& shape, const Clock& clock) {
  const auto from = hostShape(document, recipe.from, cache, clock);
  if (!from) return from.failure();
  const auto to = hostShape(document, recipe.to, cache, clock);
  if (!to) return to.failure();
  Result<PartShape> made = bridgeStage(recipe, document, smoothMesh(*from.value()), smoothMesh(*to.value()), clock);
  if (!made) return made.failure();
  shape = std::move(made).value();
  return Done{};
}

/// Under a hand that moves it what takes most of the time waits: rounded forks, and the last points round a curve.
Status stackShape(const document::StackRecipe& recipe, image::Size size, Purpose purpose, PartShape& shape,
                  const Clock& clock) {
  constexpr int kLiveSides = 48;
  const bool live = purpose == Purpose::Live;
  document::StackRecipe coarse;
  if (live) {
    coarse = recipe;
    coarse.stack.melt = 0;
    coarse.stack.sides = std::min(recipe.stack.sides, kLiveSides);
  }
  const bool waits = live && coarse.stack != recipe.stack;
  Result<PartShape> made = stackStage(waits ? coarse : recipe, size, clock);
  if (!made) return made.failure();
  shape = std::move(made).value();
  if (waits) shape.quality = TraceQuality::Live;
  return Done{};
}

// In place of what `shape` held, which a failure leaves as it was.
Status frontShapeOf(const Made& from, Cache& cache, Purpose purpose, PartShape& shape, const Clock& clock) {
  if (const auto* loft = std::get_if<document::LoftRecipe>(&from.recipe)) {
    return loftShape(*loft, from.entry, cache, purpose, shape, clock);
  }
  const image::Size size = from.entry.size;
  const auto* puff = std::get_if<document::InflateRecipe>(&from.recipe);
  if (puff != nullptr && !puff->inflate.profile.isSoft()) {
    const InteriorKey key = interiorKey(*puff, from.entry);
    const KnownInterior known = cache.interior(key);
    KnownInterior interior = known;
    Result<PartShape> made = regionStage(from.recipe, size, interior, clock);
    if (interior && !known) cache.keepInterior(key, interior);
    if (!made) return made.failure();
    shape = std::move(made).value();
    return Done{};
  }
  if (const auto* element = std::get_if<document::ElementRecipe>(&from.recipe)) {
    return elementShape(*element, from, cache, shape, clock);
  }
  if (const auto* stack = std::get_if<document::StackRecipe>(&from.recipe)) {
    return stackShape(*stack, size, purpose, shape, clock);
  }
  if (const auto* bridge = std::get_if<document::BridgeRecipe>(&from.recipe)) {
    return bridgeShape(*bridge, from.document, cache, shape, clock);
  }
  const auto* outlined = std::get_if<document::ShapeRecipe>(&from.recipe);
  Result<PartShape> made =
      outlined ? outlineStage(*outlined, from.document, size, clock) : regionStage(from.recipe, size, clock);
  if (!made) return made.failure();
  shape = std::move(made).value();
  return Done{};
}

// The same as deep as a side outline says.
Status sidedShapeOf(const Made& from, Cache& cache, Purpose purpose, PartShape& shape, const Clock& clock) {
  const std::optional<document::Outline>* side = document::sideOf(from.recipe);
  if (side == nullptr || !*side) return frontShapeOf(from, cache, purpose, shape, clock);
  PartShape made;
  if (Status status = frontShapeOf(from, cache, purpose, made, clock); !status.ok()) return status;
  const double started = nowMs(clock);
  if (Status status = sideStage(from.recipe, from.document, made); !status.ok()) return status;
  made.ms.loft += nowMs(clock) - started;
  shape = std::move(made);
  return Done{};
}

// The same with what is done to its surface. What comes before that is kept, so that a hand which moves a pull or the
// height of a relief waits for nothing else.
Status shapeOf(const Made& from, Cache& cache, Purpose purpose, PartShape& shape, const Clock& clock) {
  const auto& [pulls, relief] = from.worked;
  if (pulls.empty() && relief == nullptr) return sidedShapeOf(from, cache, purpose, shape, clock);
  const bool keeps = !needsEdges(from.recipe) || cache.edges(from.entry.contentHash);
  ShapeKey key = keeps ? unpulledKey(from.recipe, from.entry, from.document, from.part) : ShapeKey{};
  PartShape made;
  const auto known = key ? cache.unpulled(key) : nullptr;
  if (known) {
    made = *known;
    made.ms = {};
  } else {
    if (Status status = sidedShapeOf(from, cache, purpose, made, clock); !status.ok()) return status;
    if (made.quality == TraceQuality::Live) key = {};
    if (key) cache.keepUnpulled(key, std::make_shared<const PartShape>(made));
  }
  const double started = nowMs(clock);
  const TraceQuality quality = purpose == Purpose::Live ? TraceQuality::Live : TraceQuality::Final;
  if (!pulls.empty()) {
    if (Status status = pullStage(pulls, key, quality, cache, made); !status.ok()) return status;
  }
  if (relief != nullptr && (purpose == Purpose::Part || known)) {
    for (std::size_t i = 0; key && i < pulls.size(); ++i) key = pulledKey(key, pulls[i], made.pulled[i].share);
    const Search search = purpose == Purpose::Part ? from.search : Search::Live;
    Status status = reliefStage(*relief, from.entry, from.document, key, search, cache, made);
    if (!status.ok()) return status;
  }
  if (relief != nullptr && purpose == Purpose::Live) made.quality = TraceQuality::Live;
  made.ms.loft += nowMs(clock) - started;
  shape = std::move(made);
  return Done{};
}

Result<std::shared_ptr<const PartShape>> hostShape(const document::Document& document, const document::BridgeEnd& end,
                                                   Cache& cache, const Clock& clock) {
  const document::Part* host = hostOf(document, end);
  if (host == nullptr) return Error::HostGone;
  const document::PictureEntry& entry = *findPicture(document, pictureOf(*host));
  if (auto known = cache.shape(shapeKey(*host, entry, document))) return known;
  if (auto known = cache.shape(smoothKey(*host, entry, document))) return known;
  if (needsEdges(host->recipe) && !cache.edges(entry.contentHash)) return Error::HostGone;
  PartShape shape;
  const Made from{host->recipe, entry, document, host->id, {host->pulls, nullptr}};
  if (const Status made = shapeOf(from, cache, Purpose::Preview, shape, clock); !made.ok()) return Error::HostGone;
  return std::make_shared<const PartShape>(std::move(shape));
}

// Whether it stands on a part whose edges are not known yet.
bool waitsForHost(const document::Recipe& recipe, const document::Document& document, const Cache& cache) {
  const auto* bridge = std::get_if<document::BridgeRecipe>(&recipe);
  if (bridge == nullptr) return false;
  return std::ranges::any_of(std::array{&bridge->from, &bridge->to}, [&](const document::BridgeEnd* end) {
    const document::Part* host = hostOf(document, *end);
    return host != nullptr && needsEdges(host->recipe) &&
           !cache.edges(findPicture(document, pictureOf(*host))->contentHash);
  });
}

}  // namespace

const image::Picture* pixelsOf(const document::Document& document, const Derived& derived, PictureId id) {
  const std::size_t count = std::min(document.pictures.size(), derived.pictures.size());
  for (std::size_t i = 0; i < count; ++i) {
    if (document.pictures[i]->id == id) return derived.pictures[i].get();
  }
  return nullptr;
}

namespace {

// The ink that does not show on a part of that picture: of its own outline, and of those of other parts, which would
// cross it as bands. Pictures of equal content are one, as they are to the keys of shapes.
std::vector<ribs::IgnoreMark> inkOver(const document::Document& document, const Derived& derived, std::size_t number,
                                      const document::PictureEntry& entry) {
  std::vector<ribs::IgnoreMark> ink;
  if (!entry.isSketch() || document.parts[number]->look.inked) return ink;
  for (std::size_t i = 0; i < derived.parts.size(); ++i) {
    const std::shared_ptr<const PartShape>& other = derived.parts[i].shape;
    const document::PictureEntry* drawnOn = findPicture(document, pictureOf(document.parts[i]));
    if (!other || drawnOn == nullptr || drawnOn->contentHash != entry.contentHash) continue;
    addInkUpon(*derived.parts[number].shape, entry.size, other->outlineInk, ink);
  }
  return ink;
}

// What may cover a part: ink of outlines, scribbles of its picture, its own scribbles.
struct MarksOver {
  std::vector<ribs::IgnoreMark> ofPicture;
  std::span<const ribs::IgnoreMark> own;
  std::array<std::span<const ribs::IgnoreMark>, 2> spans() const { return {ofPicture, own}; }
};
MarksOver marksOver(const document::Part& part, std::vector<ribs::IgnoreMark> ink,
                    const document::PictureEntry& entry) {
  const auto* loft = std::get_if<document::LoftRecipe>(&part.recipe);
  MarksOver marks{std::move(ink), loft ? std::span(loft->ignored) : std::span<const ribs::IgnoreMark>{}};
  marks.ofPicture.insert(marks.ofPicture.end(), entry.ignored.begin(), entry.ignored.end());
  return marks;
}

// Whether an earlier part has the same shape.
bool standsBefore(const Derived& derived, std::size_t number) {
  const ShapeKey key = derived.parts[number].shape->key;
  return std::any_of(derived.parts.begin(), derived.parts.begin() + static_cast<std::ptrdiff_t>(number),
                     [&](const DerivedPart& other) { return other.shape && other.shape->key == key; });
}

// Whether parts of that picture wait for its edges: their outlines are not known yet.
bool waitsFor(const document::Document& document, const Derived& derived, PictureId picture) {
  for (std::size_t i = 0; i < derived.parts.size(); ++i) {
    if (derived.parts[i].waiting && pictureOf(document.parts[i]) == picture) return true;
  }
  return false;
}

// Makes the texture of one part that wants one, or puts it down as wanting one. All shapes are known.
void assignTexture(const document::Document& document, std::size_t number, Cache& cache, Finish finish,
                   Derived& derived) {
  std::shared_ptr<const PartShape>& shape = derived.parts[number].shape;
  const document::Part& part = document.parts[number];
  const document::PictureEntry* entry = findPicture(document, pictureOf(part));
  if (!shape || entry == nullptr) return;
  if (finish == Finish::Later && waitsFor(document, derived, entry->id)) return;
  std::vector<ribs::IgnoreMark> ink = inkOver(document, derived, number, *entry);
  const TextureKey key = textureKey(shape->key, ink);
  shape = cache.wantTexture(shape->key, key);
  if (isTextureKnown(*shape)) return;
  if (finish == Finish::Later) {
    if (!standsBefore(derived, number)) derived.wantedTextures.push_back(part.id);
    return;
  }
  const image::Picture* pixels = pixelsOf(document, derived, pictureOf(part));
  const MarksOver marks = marksOver(part, std::move(ink), *entry);
  shape = cache.assignTexture(key, pixels ? textureStage(*shape, *pixels, marks.spans()) : nullptr);
}

}  // namespace

std::shared_ptr<TextureJob> makeTexture(const document::Document& document, const Derived& derived, PartId id) {
  const document::Part* part = document::findPart(document, id);
  const auto at = std::ranges::find(derived.parts, id, &DerivedPart::id);
  if (part == nullptr || at == derived.parts.end() || !at->shape) return nullptr;
  const document::PictureEntry* entry = findPicture(document, pictureOf(*part));
  const std::size_t count = std::min(document.pictures.size(), derived.pictures.size());
  const auto number = static_cast<std::size_t>(at - derived.parts.begin());
  for (std::size_t i = 0; entry != nullptr && i < count; ++i) {
    if (document.pictures[i]->id != entry->id || !derived.pictures[i]) continue;
    try {
      const MarksOver marks = marksOver(*part, inkOver(document, derived, number, *entry), *entry);
      return std::make_shared<TextureJob>(at->shape, derived.pictures[i], marks.spans());
    } catch (const std::bad_alloc&) {
      return nullptr;
    }
  }
  return nullptr;
}

std::shared_ptr<ReliefJob> makeRelief(const document::Document& document, const Derived& derived, PartId id) {
  const document::Part* part = document::findPart(document, id);
  const auto at = std::ranges::find(derived.parts, id, &DerivedPart::id);
  if (part == nullptr || at == derived.parts.end() || !at->wantedRelief || !part->relief) return nullptr;
  const document::PictureEntry* own = findPicture(document, pictureOf(*part));
  const document::PictureEntry* from = own ? reliefPicture(document, *part->relief, *own) : nullptr;
  const auto entry = std::ranges::find_if(document.pictures, [&](const auto& box) { return &*box == from; });
  const auto number = static_cast<std::size_t>(entry - document.pictures.begin());
  if (from == nullptr || number >= derived.pictures.size() || !derived.pictures[number]) return nullptr;
  try {
    return std::make_shared<ReliefJob>(*at->wantedRelief, sizeOf(*own), *part->relief, derived.pictures[number]);
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
}

namespace {

DerivedPart derivePart(const document::Document& document, const document::Part& part,
                       const document::PictureEntry& entry, Cache& cache, const Clock& clock, Finish finish) {
  DerivedPart result{part.id, nullptr, std::nullopt, false};
  const ShapeKey key = shapeKey(part, entry, document);
  const bool known = (!needsEdges(part.recipe) || cache.edges(entry.contentHash) != nullptr) &&
                     !waitsForHost(part.recipe, document, cache);
  result.shape = cache.shape(key);
  if (!result.shape && !known) result.waiting = true;
  if (!result.shape && known) {
    PartShape shape;
    const Search search = finish == Finish::Now ? Search::All : Search::Known;
    const Made from{part.recipe, entry, document, part.id, {part.pulls, part.relief ? &*part.relief : nullptr}, search};
    const Status made = shapeOf(from, cache, Purpose::Part, shape, clock);
    if (made.ok()) {
      const HeightsKey heights = std::exchange(shape.wantedHeights, {});
      const RaisedKey raised = std::exchange(shape.wantedRaised, {});
      shape.key = heights ? smoothKey(part, entry, document) : key;
      result.shape = heights ? cache.shape(shape.key) : nullptr;
      if (!result.shape) {
        shape.outlineInk = outlineInk(shape, entry);
        result.shape = std::make_shared<const PartShape>(std::move(shape));
        cache.keepShape(result.shape);
      }
      if (heights) result.wantedRelief = WantedRelief{heights, raised, result.shape, cache.heights(heights)};
    } else {
      result.failure = made.failure();
    }
  }
  return result;
}

}  // namespace

Derived derive(const document::Document& document, Cache& cache, const Clock& clock, Finish finish) {
  Derived derived;
  std::vector<std::uint64_t> usedEdges;
  for (const document::PictureEntry& entry : document.pictures) {
    usedEdges.push_back(entry.contentHash);
    if (!cache.edges(entry.contentHash)) derived.wantedEdges.push_back(entry.id);
    const auto pixels = cache.pixels(entry);
    derived.pictures.push_back(pixels ? pixels.value() : nullptr);
  }
  for (const document::Drawing& drawing : document.drawings) {
    document::PlainDrawing plain = plainDrawing(document, drawing);
    std::shared_ptr<const DrawingShape> shape = solved(plain.drawing, cache);
    derived.drawings.push_back({drawing.id, std::move(plain.pieces), std::move(shape)});
  }
  derived.parts.resize(document.parts.size());
  for (const bool bridges : {false, true}) {  // last: they need the shapes of the others
    for (std::size_t i = 0; i < document.parts.size(); ++i) {
      const document::Part& part = document.parts[i];
      if ((bridgeOf(part) != nullptr) != bridges) continue;
      const document::PictureEntry* entry = findPicture(document, pictureOf(part));
      derived.parts[i] = entry ? derivePart(document, part, *entry, cache, clock, finish)
                               : DerivedPart{part.id, nullptr, Failure{Error::NoSuchPicture, part.name}, false};
    }
  }
  for (const DerivedPart& part : derived.parts) {
    if (part.wantedRelief) derived.wantedReliefs.push_back(part.id);
  }
  for (std::size_t i = 0; i < derived.parts.size(); ++i) assignTexture(document, i, cache, finish, derived);
  cache.endRound(usedEdges);
  return derived;
}

namespace {

Status shapeFor(Purpose purpose, const document::Document& document, const document::Recipe& recipe, Cache& cache,
                PartShape& shape, const Clock& clock, Worked worked) {
  const document::PictureEntry* entry = findPicture(document, document::pictureOf(recipe));
  if (entry == nullptr) return Error::NoSuchPicture;
  return shapeOf({recipe, *entry, document, {}, worked}, cache, purpose, shape, clock);
}

}  // namespace

Status previewShape(const document::Document& document, const document::Recipe& recipe, Cache& cache, PartShape& shape,
                    const Clock& clock, Worked worked) {
  return shapeFor(Purpose::Preview, document, recipe, cache, shape, clock, worked);
}

Status liveShape(const document::Document& document, const document::Recipe& recipe, Cache& cache, PartShape& shape,
                 const Clock& clock, Worked worked) {
  return shapeFor(Purpose::Live, document, recipe, cache, shape, clock, worked);
}

Result<PartShape> previewShape(const document::Document& document, const document::Recipe& recipe, Cache& cache,
                               const Clock& clock, Worked worked) {
  PartShape shape;
  const Status made = previewShape(document, recipe, cache, shape, clock, worked);
  if (!made.ok()) return made.failure();
  return shape;
}

Result<PartShape> liveShape(const document::Document& document, const document::Recipe& recipe, Cache& cache,
                            const Clock& clock, Worked worked) {
  PartShape shape;
  const Status made = liveShape(document, recipe, cache, shape, clock, worked);
  if (!made.ok()) return made.failure();
  return shape;
}

std::vector<PicturePoint> strokeOnThing(const document::Document& document, const document::LoftRecipe& recipe,
                                        Cache& cache) {
  const document::PictureEntry* entry = findPicture(document, recipe.picture);
  const auto edges = entry ? cache.edges(entry->contentHash) : nullptr;
  if (!edges) return recipe.stroke;
  const auto ignored = ignoredEdgesOf(recipe, *entry, *edges, cache);
  if (!ignored) return recipe.stroke;
  try {
    std::optional<ribs::TracedStroke> whole;
    std::vector<PicturePoint> kept = ribs::strokeOnThing(recipe.stroke, {*edges, entry->size, ignored.value().get()},
                                                         recipe.spine, recipe.ribs, cache.ribMemory(), whole);
    if (whole) {
      auto traced = std::make_shared<TracedRibs>(TracedRibs{std::move(whole->spine), std::move(whole->ribs)});
      cache.keepTraced(traceKey(recipe, *entry), std::move(traced), true);
    }
    return kept;
  } catch (const std::bad_alloc&) {
    return recipe.stroke;
  }
}

Result<Derived> deriveWithEdges(const document::Document& document, Cache& cache, const Progress& progress,
                                const Clock& clock, double* edgesMs) {
  const double started = nowMs(clock);
  for (const document::PictureEntry& entry : document.pictures) {
    if (cache.edges(entry.contentHash)) continue;
    const auto pixels = cache.pixels(entry);
    if (!pixels) return pixels.failure();
    Result<image::EdgeMap> edges = vision::detectEdges(*pixels.value(), {}, progress);
    if (!edges) return edges.failure();
    cache.keepEdges(entry.contentHash, std::make_shared<const image::EdgeMap>(std::move(edges).value()));
  }
  if (edgesMs != nullptr) *edgesMs = nowMs(clock) - started;
  return derive(document, cache, clock);
}

}  // namespace spineloft::pipeline
