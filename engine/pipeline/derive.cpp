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
void mix(Hasher& hasher, const loft::LoftParams& params) {
  const auto& [section, startCap, endCap, sectionPoints, capRings, centring] = params;
  mixAll(hasher, section, startCap, endCap, sectionPoints, capRings, centring);
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
  shape.ribs = std::move(ribSet).value();
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

std::uint64_t shapeKey(const document::LoftRecipe& recipe, std::uint64_t contentHash) {
  const auto& [picture, stroke, spine, ribs, loft] = recipe;
  Hasher hasher;
  hasher.number(contentHash).number(picture.value).number(stroke.size());
  for (const PicturePoint& p : stroke) hasher.number(p.x).number(p.y);
  mix(hasher, spine);
  mix(hasher, ribs);
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

void Cache::endRound(const std::vector<std::uint64_t>& usedEdges) {
  ++round_;
  std::erase_if(shapes_, [&](const ShapeSlot& s) { return s.lastRound + kKeptRounds < round_; });
  std::erase_if(edges_, [&](const EdgeSlot& slot) {
    return std::ranges::find(usedEdges, slot.contentHash) == usedEdges.end();
  });
}

Derived derive(const document::Document& document, Cache& cache, const Clock& clock) {
  Derived derived;
  std::vector<std::uint64_t> usedEdges;
  for (const document::PictureEntry& entry : document.pictures) {
    usedEdges.push_back(entry.contentHash);
    if (!cache.edges(entry.contentHash)) derived.wantedEdges.push_back(entry.id);
  }
  for (const document::Part& part : document.parts) {
    DerivedPart result{part.id, nullptr, std::nullopt, false};
    const document::PictureEntry* entry = findPicture(document, part.recipe.picture);
    if (entry == nullptr) {
      result.failure = Failure{Error::NoSuchPicture, part.name};
      derived.parts.push_back(std::move(result));
      continue;
    }
    const std::uint64_t key = shapeKey(part.recipe, entry->contentHash);
    result.shape = cache.shape(key);
    const std::shared_ptr<const image::EdgeMap> edges = cache.edges(entry->contentHash);
    if (!result.shape && !edges) result.waiting = true;
    if (!result.shape && edges) {
      const image::Size size{entry->picture->width, entry->picture->height};
      Result<PartShape> made = shapePart(part.recipe, *edges, size, Progress{}, clock);
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
    Result<image::EdgeMap> edges = vision::detectEdges(*entry.picture, {}, progress);
    if (!edges) return edges.failure();
    cache.keepEdges(entry.contentHash,
                    std::make_shared<const image::EdgeMap>(std::move(edges).value()));
  }
  if (edgesMs != nullptr) *edgesMs = nowMs(clock) - started;
  return derive(document, cache, clock);
}

}  // namespace spineloft::pipeline
