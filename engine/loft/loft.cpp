#include "engine/loft/loft.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <ranges>

#include "engine/base/limits.h"
#include "engine/geometry/polygon.h"
#include "engine/loft/caps.h"
#include "engine/loft/chords.h"
#include "engine/loft/section_track.h"
#include "engine/loft/stations.h"
#include "engine/loft/straight_end.h"
#include "engine/loft/sweep.h"
#include "engine/loft/workspace.h"

namespace spineloft::loft {

namespace {

/// Ribs as chords, ready for repair, in the order and direction in which they sweep a positive
/// area.
struct Input {
  std::vector<Chord> chords;
  std::vector<PicturePoint> startFan, endFan;
  double diagonal = 0;  ///< of the box round all rib ends, picture pixels
  double farthest = 0;  ///< largest absolute coordinate
};

/// The stretch between the caps, and the tips that ribs without width made.
struct Body {
  std::vector<Chord> chords;
  std::optional<PicturePoint> startTip, endTip;
  ChordMemory memory;
};

}  // namespace

struct LoftWorkspace::Tables {
  // The section of these params.
  LoftParams params;
  bool ring = false;
  std::optional<SectionTrack> track;
  // One loft, step by step.
  std::vector<double> places;  ///< of ribs, as shares of the spine
  Input input;
  Body body;
  CentreLine line;
  std::vector<PicturePoint> fan;  ///< of the start, seen from the other end
  CapMemory caps;
  Cap cap;
  Outline outline;
  StationMemory stations;
  Sweep sweep;
  SweepMemory rings;
};

namespace {

PicturePoint clamped(PicturePoint p) {
  return {std::clamp(p.x, -kFarthest, kFarthest), std::clamp(p.y, -kFarthest, kFarthest)};
}

/// `place`: share of the spine's length at which a rib stands.
template <class Place>
void readRibs(const ribs::RibSet& set, const Place& place, Input& input) {
  input.chords.clear();
  input.startFan.clear();
  input.endFan.clear();
  input.diagonal = input.farthest = 0;
  input.chords.reserve(set.ribs.size());
  PicturePoint low{kFarthest, kFarthest}, high{-kFarthest, -kFarthest};
  for (const ribs::Rib& rib : set.ribs) {
    if (!isFinite(rib.left) || !isFinite(rib.right)) continue;
    const Chord chord{clamped(rib.left), clamped(rib.right), place(rib)};
    input.chords.push_back(chord);
    for (const PicturePoint& p : {chord.left, chord.right}) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
      input.farthest = std::max({input.farthest, std::abs(p.x), std::abs(p.y)});
    }
  }
  if (input.chords.empty()) return;
  input.diagonal = distance(low, high);
  const auto readFan = [](const ribs::EndFan& fan, std::vector<PicturePoint>& points) {
    for (const PicturePoint& p : fan.points) {
      if (isFinite(p)) points.push_back(clamped(p));
    }
  };
  readFan(set.startFan, input.startFan);
  readFan(set.endFan, input.endFan);
  double swept = 0;
  for (std::size_t i = 1; i < input.chords.size(); ++i) {
    swept += sweptArea(input.chords[i - 1], input.chords[i]);
  }
  if (swept < 0) {  // left and right are swapped throughout
    for (Chord& chord : input.chords) chord = flipped(chord);
    std::reverse(input.startFan.begin(), input.startFan.end());
    std::reverse(input.endFan.begin(), input.endFan.end());
  }
}

/// Limits below which float coordinates or the mesh laws would make triangles without area.
ChordLimits limitsFor(const Input& input, double shortestEdge, double strictness) {
  constexpr double kSpacingShare = 2e-5, kWidthShare = 2e-4;  // of the diagonal
  constexpr double kSteps = 16;                               // float steps that a triangle's edge spans at least
  const double step = input.farthest * static_cast<double>(std::numeric_limits<float>::epsilon()) * kSteps;
  ChordLimits limits;
  limits.spacing = strictness * std::max(kSpacingShare * input.diagonal, step);
  limits.width =
      strictness * std::max(kWidthShare * input.diagonal, step / (shortestEdge * kLeastDepth * (1 - sections::kWall)));
  return limits;
}

void repairBody(std::span<const Chord> given, const ChordLimits& limits, Body& body) {
  std::vector<Chord>& chords = body.chords;
  chords.assign(given.begin(), given.end());
  body.startTip.reset();
  body.endTip.reset();
  const auto isTip = [&](const Chord& chord) { return chord.width() < limits.width / 2; };
  if (chords.size() >= 2 && isTip(chords.front()) && !isTip(chords[1])) {
    body.startTip = chords.front().middle();
    chords.erase(chords.begin());
  }
  if (chords.size() >= 2 && isTip(chords.back()) && !isTip(chords[chords.size() - 2])) {
    body.endTip = chords.back().middle();
    chords.pop_back();
  }
  widenChords(chords, limits);
  orderChords(chords, limits, body.memory);
  const auto ahead = [&](const Chord& chord, PicturePoint tip) {
    return dot(tip - chord.middle(), normalized(forwardOf(chord.across()))) > 2 * limits.spacing;
  };
  if (body.startTip && !ahead(flipped(body.chords.front()), *body.startTip)) body.startTip.reset();
  if (body.endTip && !ahead(body.chords.back(), *body.endTip)) body.endTip.reset();
}

/// A single chord becomes a thin slab.
void thicken(std::vector<Chord>& chords, const ChordLimits& limits) {
  const Chord chord = chords.front();
  const double half = std::max(2 * limits.spacing, 0.05 * chord.width());
  const PicturePoint step = normalized(forwardOf(chord.across())) * half;
  chords = {{chord.left - step, chord.right - step, chord.at}, {chord.left + step, chord.right + step, chord.at}};
}

/// A cap's direction: along the centre line, unless that runs along the rib.
PicturePoint capTravel(const Chord& chord, PicturePoint travel) {
  constexpr double kSlanted = 0.5;  // cosine: ribs more slanted than 60° are not believed
  const PicturePoint square = normalized(forwardOf(chord.across()));
  return dot(square, travel) < kSlanted ? square : travel;
}

/// The chord before the last of `chords`, nearest to it, whose ends are both half its width away; else
/// the first.
template <class Chords>
Chord shoulderOf(const Chords& chords) {
  const Chord last = chords.back();
  const double away = last.width() / 2;
  for (const Chord& chord : chords | std::views::reverse) {
    if (distance(chord.left, last.left) >= away && distance(chord.right, last.right) >= away) {
      return chord;
    }
  }
  return chords.front();
}

void addCaps(const LoftParams& params, const ChordLimits& limits, LoftWorkspace::Tables& tables) {
  const Body& body = tables.body;
  const Input& input = tables.input;
  const std::vector<Chord>& chords = body.chords;
  const std::size_t n = chords.size();
  Outline& outline = tables.outline;
  outline.chords.assign(chords.begin(), chords.end());
  outline.startTip = body.startTip;
  outline.endTip = body.endTip;
  outline.startOpen = outline.endOpen = false;
  outline.bodyBegin = 0;
  tables.line.follow(outline, params.centring);
  const std::vector<PicturePoint>& travel = tables.line.travel;
  const std::size_t first = body.startTip ? 1 : 0;
  Cap& cap = tables.cap;
  if (!body.startTip) {
    const Chord last = flipped(chords.front()), before = flipped(chords[std::min<std::size_t>(1, n - 1)]);
    tables.fan.assign(input.startFan.rbegin(), input.startFan.rend());
    planCap(
        {last, before, flipped(shoulderOf(chords | std::views::reverse)), capTravel(last, -travel[first]), tables.fan},
        {params.startCap, params.capRings, limits}, tables.caps, cap);
    std::ranges::reverse(cap.chords);
    for (Chord& chord : cap.chords) chord = flipped(chord);
    outline.chords.insert(outline.chords.begin(), cap.chords.begin(), cap.chords.end());
    outline.bodyBegin = cap.chords.size();
    outline.startTip = cap.tip;
    outline.startOpen = params.startCap == sections::CapStyle::Open;
  }
  outline.bodyEnd = outline.bodyBegin + n;
  if (!body.endTip) {
    const Chord last = chords.back(), before = chords[n >= 2 ? n - 2 : 0];
    planCap({last, before, shoulderOf(chords), capTravel(last, travel[first + n - 1]), input.endFan},
            {params.endCap, params.capRings, limits}, tables.caps, cap);
    outline.chords.insert(outline.chords.end(), cap.chords.begin(), cap.chords.end());
    outline.endTip = cap.tip;
    outline.endOpen = params.endCap == sections::CapStyle::Open;
  }
}

/// Strict repair: every chord clearly ahead of the one before, tips ahead of their chords.
void spread(Outline& outline, const ChordLimits& limits) {
  spreadChords(outline.chords, limits);
  outline.bodyBegin = outline.bodyEnd = 0;
  if (outline.chords.size() == 1 && !outline.startTip && !outline.endTip) {
    thicken(outline.chords, limits);
  }
  const auto push = [&](const Chord& chord, std::optional<PicturePoint>& tip) {
    if (!tip) return;
    const PicturePoint forward = normalized(forwardOf(chord.across()));
    const double lead = dot(*tip - chord.middle(), forward);
    if (lead < 2 * limits.spacing) *tip += forward * (2 * limits.spacing - lead);
  };
  push(flipped(outline.chords.front()), outline.startTip);
  push(outline.chords.back(), outline.endTip);
}

/// Touches x = ±1 and stays in [−1, 1]².
bool spansTheSquare(const sections::Section& section) {
  constexpr double kClose = 1e-6;
  double low = 0, high = 0;
  for (const SectionPoint& p : section.points) {
    if (!isFinite(p) || std::abs(p.x) > 1 + kClose || std::abs(p.y) > 1 + kClose) return false;
    low = std::min(low, p.x);
    high = std::max(high, p.x);
  }
  return low < -1 + kClose && high > 1 - kClose;
}

Status checkInput(image::Size picture, const LoftParams& params) {
  if (picture.width < 1 || picture.height < 1) return {Error::ValueOutOfRange, "picture size"};
  return checkParams(params);
}

/// Everything a loft is made from; all of it is known to be good. `spine` may be null.
struct Plan {
  const ribs::RibSet& ribs;
  image::Size picture;
  const SectionTrack& track;
  const PosedSpine* spine;
};

/// Shares of the spine's length at which ribs stand: on the spine where it is known, else along the
/// line of their centres.
void findPlaces(const ribs::RibSet& set, const PosedSpine* spine, std::vector<double>& places) {
  places.clear();
  double length = 0, last = 0;
  const ribs::Rib* before = nullptr;
  for (const ribs::Rib& rib : set.ribs) {
    if (isFinite(rib.center) && before != nullptr) length += distance(before->center, rib.center);
    if (isFinite(rib.center)) before = &rib;
    if (spine != nullptr && isFinite(rib.center)) last = std::max(last, shareAt(*spine, rib.center));
    places.push_back(spine != nullptr ? last : length);
  }
  if (spine != nullptr) return;
  const double steps = static_cast<double>(std::max<std::size_t>(1, places.size() - 1));
  for (std::size_t i = 0; i < places.size(); ++i) {
    places[i] = length > 0 && std::isfinite(length) ? places[i] / length : static_cast<double>(i) / steps;
  }
}

/// The section on the points of `params`, which `tables` may know already.
Result<const SectionTrack*> trackOf(const LoftParams& params, bool ring, LoftWorkspace::Tables& tables) {
  const bool known = tables.track && tables.ring == ring && tables.params.sectionPoints == params.sectionPoints &&
                     tables.params.sections == params.sections;
  if (!known) {
    tables.track.reset();
    Result<SectionTrack> made = SectionTrack::along(params.sections, params.sectionPoints, ring);
    if (!made) return made.failure();
    tables.track = std::move(made).value();
    tables.ring = ring;
  }
  tables.params = params;
  return &*tables.track;
}

/// `params`: the plan's own, whose ends may become flat.
Status loftPlan(const Plan& plan, LoftParams& params, LoftWorkspace::Tables& tables, mesh::TriMesh& mesh) {
  const ribs::Rib* first = plan.ribs.ribs.data();
  // Nothing looks at the places of ribs unless something changes along the spine.
  const StationMaker maker{plan.track, params, plan.spine};
  std::vector<double>& places = tables.places;
  places.clear();
  if (maker.changes()) findPlaces(plan.ribs, plan.spine, places);
  const Input& input = tables.input;
  readRibs(
      plan.ribs,
      [&](const ribs::Rib& rib) { return places.empty() ? 0.0 : places[static_cast<std::size_t>(&rib - first)]; },
      tables.input);
  if (input.chords.size() < 2) return Error::TooFewRibs;
  if (input.diagonal < kSamePoint) return {Error::TooFewRibs, "all in one point"};
  const bool many = plan.track.sizes().size() > 1, ring = maker.ring();
  for (sections::CapStyle* cap : {&params.startCap, &params.endCap}) {
    if (many || ring || (*cap == sections::CapStyle::Open && !plan.track.hollow())) *cap = sections::CapStyle::Flat;
  }
  // Nearly always the first try is valid. Ribs that touch or lie in one line need the stricter
  // ones.
  constexpr std::array kStrictness = {1.0, 1.0, 8.0, 64.0};
  for (std::size_t attempt = 0; attempt < kStrictness.size(); ++attempt) {
    const ChordLimits limits = limitsFor(input, plan.track.shortestEdge(), kStrictness[attempt]);
    Body& body = tables.body;
    repairBody(input.chords, limits, body);
    if (!ring) cutStraightEnds(body.chords, plan.ribs, params);
    if (many || ring) {
      body.startTip.reset();
      body.endTip.reset();
    }
    if (body.chords.size() == 1 && !body.startTip && !body.endTip) thicken(body.chords, limits);
    addCaps(params, limits, tables);
    if (attempt > 0) spread(tables.outline, limits);
    maker.sweep(tables.outline, tables.stations, tables.sweep);
    if (sweepMesh(tables.sweep, plan.picture, tables.rings, mesh)) return Done{};
  }
  return {Error::SectionInvalid, "too fine for ribs of this size"};
}

}  // namespace

Status checkParams(const LoftParams& params) {
  if (params.startCap >= sections::CapStyle::kCount || params.endCap >= sections::CapStyle::kCount) {
    return {Error::ValueOutOfRange, "cap"};
  }
  if (params.sectionPoints < sections::kMinSectionPoints || params.sectionPoints > sections::kMaxSectionPoints) {
    return {Error::ValueOutOfRange, "section points"};
  }
  if (params.capRings < 1 || params.capRings > 64) return {Error::ValueOutOfRange, "cap rings"};
  if (!(params.centring >= 0 && params.centring <= 10)) return {Error::ValueOutOfRange, "centring"};
  if (!geometry::isValid(params.twist, -kMostTwist, kMostTwist) ||
      !geometry::isValid(params.squash, kLeastSquash, kMostSquash) ||
      !geometry::isValid(params.tilt, -kMostTilt, kMostTilt) || !geometry::isValid(params.bulge, -1, 1)) {
    return {Error::ValueOutOfRange, "curve along the spine"};
  }
  return checkSectionKeys(params.sections);
}

LoftWorkspace::LoftWorkspace() = default;
LoftWorkspace::~LoftWorkspace() = default;
LoftWorkspace::LoftWorkspace(LoftWorkspace&&) noexcept = default;
LoftWorkspace& LoftWorkspace::operator=(LoftWorkspace&&) noexcept = default;
LoftWorkspace::Tables& LoftWorkspace::tables() {
  if (!tables_) tables_ = std::make_unique<Tables>();
  return *tables_;
}

namespace {

Status loftAlong(const Source& source, const PosedSpine* spine, LoftWorkspace& memory, mesh::TriMesh& mesh) {
  if (const Status status = checkInput(source.picture, source.params); !status.ok()) return status.failure();
  LoftWorkspace::Tables& tables = memory.tables();
  const bool ring = spine != nullptr && spine->closed;
  const Result<const SectionTrack*> track = trackOf(source.params, ring, tables);
  if (!track.ok()) return track.failure();
  return loftPlan({source.ribs, source.picture, *track.value(), spine}, tables.params, tables, mesh);
}

}  // namespace

Result<mesh::TriMesh> loftRibs(const ribs::RibSet& ribs, image::Size picture, const LoftParams& params) {
  LoftWorkspace memory;
  mesh::TriMesh mesh;
  if (const Status status = loftAlong({ribs, picture, params}, nullptr, memory, mesh); !status.ok())
    return status.failure();
  return mesh;
}

Result<mesh::TriMesh> loftRibs(const ribs::RibSet& ribs, image::Size picture, const LoftParams& params,
                               const PosedSpine& spine) {
  LoftWorkspace memory;
  mesh::TriMesh mesh;
  if (const Status status = loftRibs({ribs, picture, params}, spine, memory, mesh); !status.ok())
    return status.failure();
  return mesh;
}

Status loftRibs(const Source& source, const PosedSpine& spine, LoftWorkspace& memory, mesh::TriMesh& mesh) {
  return loftAlong(source, &spine, memory, mesh);
}

Result<mesh::TriMesh> loftSection(const ribs::RibSet& ribs, image::Size picture, const LoftParams& params,
                                  const sections::Section& section) {
  if (const Status status = checkInput(picture, params); !status.ok()) return status.failure();
  const std::span<const SectionPoint> points(section.points);
  if (points.size() < 3) return {Error::SectionInvalid, "fewer than 3 points"};
  if (!spansTheSquare(section)) return {Error::SectionInvalid, "does not span the square"};
  if (!geometry::isSimple(points)) return {Error::SectionInvalid, "touches itself"};
  if (geometry::signedArea(points) <= 0) return {Error::SectionInvalid, "runs clockwise"};
  const SectionTrack track = SectionTrack::fixed(section.points);
  LoftWorkspace::Tables tables;
  LoftParams own = params;
  mesh::TriMesh mesh;
  if (const Status status = loftPlan({ribs, picture, track, nullptr}, own, tables, mesh); !status.ok())
    return status.failure();
  return mesh;
}

}  // namespace spineloft::loft
