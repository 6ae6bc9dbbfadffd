#include "engine/pipeline/relief_shape.h"

#include <new>
#include <utility>

#include "engine/pipeline/cache.h"
#include "engine/pipeline/keys.h"
#include "engine/relief/heights.h"
#include "engine/relief/raise.h"

namespace spineloft::pipeline {
namespace {

bool isQuick(const relief::Relief& relief) { return relief.mode != relief::Mode::Shade; }

std::shared_ptr<const relief::Raised> raisedAs(const relief::Surface& surface, const relief::Heights& heights,
                                               const relief::Relief& relief, std::size_t most) {
  if (!heights.found()) return std::make_shared<const relief::Raised>();
  return std::make_shared<const relief::Raised>(
      relief::raisedBy(surface, heights.front, relief::finished(heights, relief.smooth), most));
}

// The heights and what they raise, as far as they are known or may be looked for.
struct Found {
  std::shared_ptr<const relief::Heights> heights;
  std::shared_ptr<const relief::Raised> raised;
};
Found find(const relief::Surface& surface, const relief::Relief& relief, const document::PictureEntry& from,
           HeightsKey key, Search search, Cache& cache) {
  Found found;
  const RaisedKey raised = key ? raisedKey(key, relief) : RaisedKey{};
  if (key) found = {cache.heights(key), cache.raised(raised)};
  if (found.heights && found.raised) return found;
  if (search == Search::Known || (!found.heights && search == Search::Live && !isQuick(relief))) return {};
  if (!found.heights) {
    const auto pixels = cache.pixels(from);
    if (!pixels) return {};
    found.heights = std::make_shared<const relief::Heights>(relief::heightsOf(surface, relief, pixels.value()));
  }
  const bool keeps = key && search == Search::All;
  found.raised = raisedAs(surface, *found.heights, relief,
                          search == Search::Live ? relief::kLiveTriangles : relief::kMostTriangles);
  if (keeps) {
    cache.keepHeights(key, found.heights);
    cache.keepRaised(raised, found.raised);
  }
  return found;
}

}  // namespace

const document::PictureEntry* reliefPicture(const document::Document& document, const relief::Relief& relief,
                                            const document::PictureEntry& own) {
  return relief.laid ? findPicture(document, relief.laid->picture) : &own;
}

Status reliefStage(const relief::Relief& relief, const document::PictureEntry& own, const document::Document& document,
                   ShapeKey smooth, Search search, Cache& cache, PartShape& shape) {
  const document::PictureEntry* from = reliefPicture(document, relief, own);
  if (from == nullptr) return Error::NoSuchPicture;
  try {
    const HeightsKey key = smooth ? heightsKey(smooth, relief, *from) : HeightsKey{};
    const auto [heights, raised] = find({shape.mesh, sizeOf(own), shape.scale}, relief, *from, key, search, cache);
    if (!heights || !raised) {
      shape.wantedHeights = key;
      shape.wantedRaised = key ? raisedKey(key, relief) : RaisedKey{};
      return Done{};
    }
    ReliefFound found{heights->mode, heights->found(), !raised->moved.empty(), heights->explained, 1};
    if (found.raises) {
      mesh::TriMesh out;
      if (search == Search::Live) {
        relief::moveMesh(*raised, relief.height, out);
      } else {
        found.share = relief::raiseMesh(*raised, relief.height, out);
      }
      shape.smooth = std::make_shared<const mesh::TriMesh>(std::exchange(shape.mesh, std::move(out)));
    }
    shape.relief = found;
    return Done{};
  } catch (const std::bad_alloc&) {
    return Error::OutOfMemory;
  }
}

ReliefJob::ReliefJob(WantedRelief wanted, mesh::PictureSize picture, const relief::Relief& relief,
                     std::shared_ptr<const image::Picture> pixels)
    : wanted_(std::move(wanted)), picture_(picture), relief_(relief) {
  if (wanted_.known) return;
  const relief::Surface surface{wanted_.smooth->mesh, picture_, wanted_.smooth->scale};
  steps_ = std::make_unique<relief::HeightSteps>(surface, relief_, std::move(pixels));
}
ReliefJob::~ReliefJob() = default;

bool ReliefJob::search() {
  if (steps_ && steps_->step()) return true;
  if (steps_) {
    wanted_.known = std::make_shared<const relief::Heights>(steps_->take());
    steps_.reset();
    return true;
  }
  raised_ = raisedAs({wanted_.smooth->mesh, picture_, wanted_.smooth->scale}, *wanted_.known, relief_,
                     relief::kMostTriangles);
  return false;
}

bool ReliefJob::step() {
  try {
    return search();
  } catch (const std::bad_alloc&) {
    return false;
  }
}

bool ReliefJob::keepIn(Cache& cache) const {
  if (!raised_) return false;
  cache.keepHeights(wanted_.heights, wanted_.known);
  cache.keepRaised(wanted_.raised, raised_);
  return true;
}

}  // namespace spineloft::pipeline
