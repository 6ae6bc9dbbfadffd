// Seeded random values of recipes and of the parts of a document that they name, for property tests: mostly good ones.
#pragma once

#include <optional>
#include <vector>

#include "engine/base/rng.h"
#include "engine/document/action.h"

namespace spineloft::testing {

/// Of the pictures that they are made for, pixels.
inline constexpr int kWidth = 96, kHeight = 72;

PartId anyPart(Rng& rng, const document::Document& document);
PictureId anyPicture(Rng& rng, const document::Document& document);
std::vector<SectionPoint> anyContour(Rng& rng);
sections::SectionShape anySection(Rng& rng);
geometry::AlongCurve anyCurve(Rng& rng, double low, double high);
std::vector<ribs::IgnoreMark> anyMarks(Rng& rng);
sections::CapStyle anyCap(Rng& rng);
std::vector<PicturePoint> anyStroke(Rng& rng);
document::Region anyRegion(Rng& rng, const document::Document& d);
document::RegionSolid anySolid(Rng& rng);
std::vector<stack::Plane> anyPlanes(Rng& rng);
stack::Rail anyRail(Rng& rng);
stack::StackParams anyStackParams(Rng& rng);
std::vector<document::Outline> anyOutlines(Rng& rng, const document::Document& d);
shape::ShapeParams anyShape(Rng& rng);
std::vector<descriptive::Stretch> anyStretches(Rng& rng);
std::optional<relief::Relief> anyRelief(Rng& rng, const document::Document& d);

}  // namespace spineloft::testing
