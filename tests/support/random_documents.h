// Seeded random documents and actions for property tests.
#pragma once

#include <memory>

#include "engine/base/rng.h"
#include "engine/document/action.h"

namespace spineloft::testing {

/// A small picture with one filled ellipse; different seeds give different pixels.
std::shared_ptr<const image::Picture> ellipsePicture(int width, int height, std::uint64_t seed = 0);

/// A stroke through the middle of a picture of that size: 2…60 points, wavy, inside.
std::vector<PicturePoint> randomStroke(Rng& rng, int width, int height);

/// Anywhere near, turned, 0.2 to 4.5 times as large, sometimes mirrored.
document::Placement randomPlacement(Rng& rng);

/// Any action of the variant, mostly one that applies to this document, sometimes one that does not.
document::Action randomAction(Rng& rng, const document::Document& document);

}  // namespace spineloft::testing
