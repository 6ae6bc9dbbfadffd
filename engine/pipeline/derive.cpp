#include "engine/pipeline/derive.h"

#include <algorithm>
#include <new>

#include "engine/base/hash.h"
#include "engine/loft/loft.h"
#include "engine/ribs/spine.h"

namespace spineloft::pipeline {
namespace {

double nowMs(const Clock& clock) { return clock ? clock() : 0.0; }

/// Mixes the members of a parameter struct. Each is taken apart by a structured binding, so that a
/// member added later does not compile until it is part of the key.
template <class... Members>
void mixAll(Hasher& hasher, const Members&... members) {
  (hasher.number(members), ...);
}
void mix(Hasher& hasher, const ribs::SpineParams& params) {
  const auto& [ribs, minSpacing, smoothness] = params;
  mixAll(hasher, ribs, minSpacing, smoothness);
}
void mix(Hasher& hasher, const ribs::EvidenceParams& params) {
  const auto& [proximityWeight, contrastWeight, localContrastWeight, beyondWeight, insideWeight,
               outsideWeight, contrastReach, knownShare, doubt, weight] = params;
  mixAll(hasher, proximityWeight, contrastWeight, localContrastWeight, beyondWeight, insideWeight,
         outsideWeight, contrastReach, knownShare, doubt, weight);
}
void mix(Hasher& hasher, const ribs::RibParams& params) {
  const auto& [levels, maxLevelShare, neighbourWeight, neighbourFreedom, neighbourCap,
               oppositeWeight, leanCost, priorWeight, evidence] = params;
  mixAll(hasher, levels, maxLevelShare, neighbourWeight, neighbourFreedom, neighbourCap,
         oppositeWeight, leanCost, priorWeight);
  mix(hasher, evidence);
}
template <class Point>
void mix(Hasher& hasher, const std::vector<Point>& points) {
  hasher.number(points.size());
  for (const Point& p : points) hasher.number(p.x).number(p.y);
}
void mix(Hasher& hasher, const geometry::AlongCurve& curve) {
  hasher.number(curve.points.size());
  for (const auto& [at, value] : curve.points) mixAll(hasher, at, value);
}
void mix(Hasher& hasher, const loft::SectionStop& stop) {
  const auto& [at, shape, blend] = stop;
  const auto& [preset, contours] = shape;
  const auto& [kind, custom] = blend;
  mixAll(hasher, at, preset, kind);
  hasher.number(contours.size());
  for (const auto& contour : contours) mix(hasher, contour);
  mix(hasher, custom);
}
void mix(Hasher& hasher, const loft::LoftParams& params) {
  const auto& [sections, twist, squash, tilt, bulge, startCap, endCap, sectionPoints, capRings,
               centring] = params;
  hasher.number(sections.size());
  for (const loft::SectionStop& stop : sections) mix(hasher, stop);
  for (const auto* curve : {&twist, &squash, &tilt, &bulge}) mix(hasher, *curve);
  mixAll(hasher, startCap, endCap, sectionPoints, capRings, centring);
}
void mix(Hasher& hasher, const ribs::RibEdits& edits) {
  const auto& [ends, added, removed] = edits;
  hasher.number(ends.size()).number(added.size()).number(removed.size());
  for (const ribs::EndEdit& end : ends) {
    const auto& [at, side, along, out, reach, locked] = end;
    mixAll(hasher, at, side, along, out, reach, locked);
  }
  for (const double at : added) hasher.number(at);
  for (const double at : removed) hasher.number(at);
}
void mix(Hasher& hasher, const std::vector<ribs::IgnoreMark>& marks) {
  hasher.number(marks.size());
  for (const ribs::IgnoreMark& mark : marks) {
    const auto& [stroke, radius] = mark;
    mix(hasher, stroke);
    hasher.number(radius);
  }
}
void mix(Hasher& hasher, const loft::Pose& pose) {
  const auto& [stroke, depth, coilTurns, coilRadius, closed] = pose;
  mix(hasher, stroke);
  mix(hasher, depth);
  mixAll(hasher, coilTurns, coilRadius, closed);
}

Result<PartShape> makeShape(const document::LoftRecipe& recipe, const image::EdgeMap& edges,
                            image::Size picture, const Progress& progress, const Clock& clock) {
  PartShape shape;
  const double started = nowMs(clock);
  Result<ribs::Spine> spine = ribs::cleanSpine(recipe.stroke, picture, recipe.spine);
  if (!spine) return spine.failure();
  shape.spine = std::move(spine).value();
  Result<ribs::RibSet> ribSet = ribs::traceRibs(shape.spine, edges, picture, recipe.ribs, progress);
  if (!ribSet) return ribSet.failure();
  shape.generated = std::move(ribSet).value();
  shape.ribs = ribs::applyEdits(shape.spine, shape.generated, recipe.edits);
  shape.shown = shape.ribs;
  for (const PicturePoint& p : shape.spine.points) shape.centreLine.push_back({p.x, -p.y, 0});
  const double traced = nowMs(clock);
  Result<mesh::TriMesh> solid = loft::loftRibs(shape.ribs, picture, recipe.loft);
  if (!solid) return solid.failure();
  shape.mesh = std::move(solid).value();
  shape.ms.ribs = traced - started;
  shape.ms.loft = nowMs(clock) - traced;
  return shape;
}

}  // namespace

Result<PartShape> shapePart(const document::LoftRecipe& recipe, const image::EdgeMap& edges,
                            image::Size picture, const Progress& progress, const Clock& clock) {
  try {
    return makeShape(recipe, edges, picture, progress, clock);
  } catch (const std::bad_alloc&) {
    return Error::OutOfMemory;
  }
}

std::uint64_t shapeKey(const document::LoftRecipe& recipe, const document::PictureEntry& entry) {
  const auto& [picture, stroke, spine, ribs, edits, ignored, pose, loft] = recipe;
  Hasher hasher;
  hasher.number(entry.contentHash).number(picture.value);
  mix(hasher, entry.ignored);
  mix(hasher, stroke);
  mix(hasher, spine);
  mix(hasher, ribs);
  mix(hasher, edits);
  mix(hasher, ignored);
  mix(hasher, pose);
  mix(hasher, loft);
  return hasher.value();
}

std::shared_ptr<const image::EdgeMap> Cache::edges(std::uint64_t contentHash) const {
  const auto at = std::ranges::find(edges_, contentHash, &EdgeSlot::contentHash);
  return at == edges_.end() ? nullptr : at->edges;
}

void Cache::keepEdges(std::uint64_t contentHash, std::shared_ptr<const image::EdgeMap> edges) {
  std::erase_if(edges_, [&](const EdgeSlot& slot) { return slot.contentHash == contentHash; });
  edges_.push_back({contentHash, std::move(edges)});
}

std::shared_ptr<const PartShape> Cache::shape(std::uint64_t key) {
  for (ShapeSlot& slot : shapes_) {
    if (slot.shape->key == key) {
      slot.lastRound = round_;
      return slot.shape;
    }
  }
  return nullptr;
}

void Cache::keepShape(std::shared_ptr<const PartShape> shape) {
  shapes_.push_back({std::move(shape), round_});
}

Result<std::shared_ptr<const image::Picture>> Cache::pixels(const document::PictureEntry& entry) {
  if (!entry.isSketch()) return entry.picture;
  const auto at = std::ranges::find(sketches_, entry.contentHash, &SketchSlot::contentHash);
  if (at != sketches_.end()) return at->picture;
  Result<image::Picture> drawn = image::drawSketch(entry.size, entry.sketch);
  if (!drawn) return drawn.failure();
  auto picture = std::make_shared<const image::Picture>(std::move(drawn).value());
  sketches_.push_back({entry.contentHash, picture});
  return picture;
}

void Cache::endRound(const std::vector<std::uint64_t>& usedEdges) {
  ++round_;
  std::erase_if(shapes_, [&](const ShapeSlot& s) { return s.lastRound + kKeptRounds < round_; });
  const auto unused = [&](const auto& slot) {
    return std::ranges::find(usedEdges, slot.contentHash) == usedEdges.end();
  };
  std::erase_if(edges_, unused);
  std::erase_if(sketches_, unused);
}

const image::Picture* pixelsOf(const document::Document& document, const Derived& derived,
                               PictureId id) {
  const std::size_t count = std::min(document.pictures.size(), derived.pictures.size());
  for (std::size_t i = 0; i < count; ++i) {
    if (document.pictures[i]->id == id) return derived.pictures[i].get();
  }
  return nullptr;
}

Derived derive(const document::Document& document, Cache& cache, const Clock& clock) {
  Derived derived;
  std::vector<std::uint64_t> usedEdges;
  for (const document::PictureEntry& entry : document.pictures) {
    usedEdges.push_back(entry.contentHash);
    if (!cache.edges(entry.contentHash)) derived.wantedEdges.push_back(entry.id);
    const auto pixels = cache.pixels(entry);
    derived.pictures.push_back(pixels ? pixels.value() : nullptr);
  }
  for (const document::Part& part : document.parts) {
    DerivedPart result{part.id, nullptr, std::nullopt, false};
    const document::PictureEntry* entry = findPicture(document, part.recipe.picture);
    if (entry == nullptr) {
      result.failure = Failure{Error::NoSuchPicture, part.name};
      derived.parts.push_back(std::move(result));
      continue;
    }
    const std::uint64_t key = shapeKey(part.recipe, *entry);
    result.shape = cache.shape(key);
    const std::shared_ptr<const image::EdgeMap> edges = cache.edges(entry->contentHash);
    if (!result.shape && !edges) result.waiting = true;
    if (!result.shape && edges) {
      Result<PartShape> made = shapePart(part.recipe, *edges, entry->size, Progress{}, clock);
      if (made) {
        made.value().key = key;
        result.shape = std::make_shared<const PartShape>(std::move(made).value());
        cache.keepShape(result.shape);
      } else {
        result.failure = made.failure();
      }
    }
    derived.parts.push_back(std::move(result));
  }
  cache.endRound(usedEdges);
  return derived;
}

Result<Derived> deriveWithEdges(const document::Document& document, Cache& cache,
                                const Progress& progress, const Clock& clock, double* edgesMs) {
  const double started = nowMs(clock);
  for (const document::PictureEntry& entry : document.pictures) {
    if (cache.edges(entry.contentHash)) continue;
    const auto pixels = cache.pixels(entry);
    if (!pixels) return pixels.failure();
    Result<image::EdgeMap> edges = vision::detectEdges(*pixels.value(), {}, progress);
    if (!edges) return edges.failure();
    cache.keepEdges(entry.contentHash,
                    std::make_shared<const image::EdgeMap>(std::move(edges).value()));
  }
  if (edgesMs != nullptr) *edgesMs = nowMs(clock) - started;
  return derive(document, cache, clock);
}

}  // namespace spineloft::pipeline
