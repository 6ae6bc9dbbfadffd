#include "web/edit/puff_bones.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "engine/geometry/line_distance.h"
#include "engine/geometry/pieces.h"
#include "engine/geometry/polyline.h"
#include "engine/inflate/profile.h"
#include "engine/inflate/rows.h"
#include "web/edit/placing.h"
#include "web/edit/preview.h"
#include "web/words/words.h"

namespace spineloft::app {
namespace {

PicturePoint down(SectionPoint p) { return {p.x, -p.y}; }
SectionPoint up(PicturePoint p) { return {p.x, -p.y}; }

constexpr double kKnobApart = 2.5, kLeastKnob = 1;  // half widths of a bone that has one
constexpr double kSamePlace = 1e-3;                 // picture pixels
constexpr double kSliceRoom = 12;                   // CSS pixels between the outline and where a slice is held

/// CSS pixels that a knob stands over its place: with the root of the thickness, so that the thinnest and the thickest
/// one are in reach.
constexpr double kFoot = 10, kRise = 38;
double stemOf(double factor) { return kFoot + kRise * std::sqrt(factor); }

/// A branch as a line with its length.
struct Line {
  std::vector<PicturePoint> points;
  std::vector<double> s;
};
Line lineOf(const inflate::Skeleton& skeleton, const std::vector<std::uint32_t>& branch) {
  Line line;
  for (const std::uint32_t p : branch) line.points.push_back(down(skeleton.points[p].at));
  line.s = geometry::arcLengths(std::span<const PicturePoint>(line.points));
  return line;
}
/// The point of a branch nearest to a share of its length.
std::uint32_t pointOf(const std::vector<std::uint32_t>& branch, const Line& line, double share) {
  const auto at = std::ranges::lower_bound(line.s, share * line.s.back());
  return branch[std::min(static_cast<std::size_t>(at - line.s.begin()), branch.size() - 1)];
}

std::vector<int> degreesOf(const inflate::Skeleton& skeleton) {
  std::vector<int> degree(skeleton.points.size(), 0);
  for (const auto& branch : skeleton.branches) {
    for (std::size_t i = 1; i < branch.size(); ++i) ++degree[branch[i - 1]], ++degree[branch[i]];
  }
  return degree;
}

/// A point of a skeleton and, where it has neighbours, the way square to it.
struct Found {
  const inflate::SkeletonPoint* point = nullptr;
  PicturePoint across{1, 0};
};
Found nearest(const std::vector<inflate::EditedSkeleton>& bones, PicturePoint p) {
  Found best;
  double least = std::numeric_limits<double>::infinity();
  for (const inflate::EditedSkeleton& piece : bones) {
    for (const auto& branch : piece.skeleton.branches) {
      for (std::size_t i = 0; i < branch.size(); ++i) {
        const inflate::SkeletonPoint& point = piece.skeleton.points[branch[i]];
        const double off = distance(point.at, up(p));
        if (off >= least) continue;
        least = off;
        const auto at = [&](std::size_t k) { return down(piece.skeleton.points[branch[k]].at); };
        const PicturePoint along = at(std::min(i + 1, branch.size() - 1)) - at(i > 0 ? i - 1 : 0);
        const double length = norm(along);
        best = {&point, length > 0 ? PicturePoint{-along.y, along.x} / length : PicturePoint{1, 0}};
      }
    }
  }
  return best;
}

BoneHandle handleOn(BoneHold hold, const inflate::SkeletonPoint& point) {
  BoneHandle out;
  out.hold = hold;
  out.at = out.named = down(point.at);
  out.half = point.radius;
  out.factor = point.over.factor;
  return out;
}

void addNodes(const BonedPuff& puff, std::vector<BoneHandle>& out) {
  for (const inflate::EditedSkeleton& piece : puff.shape->bones) {
    const std::vector<int> degree = degreesOf(piece.skeleton);
    for (std::size_t i = 0; i < degree.size(); ++i) {
      if (degree[i] != 2) out.push_back(handleOn(BoneHold::Node, piece.skeleton.points[i]));
    }
  }
}

void addKnobs(const BonedPuff& puff, std::vector<BoneHandle>& out) {
  const std::size_t first = out.size();
  const auto& heights = puff.params->bones.heights;
  for (std::size_t i = 0; i < heights.size(); ++i) {
    if (!inflate::isAwake(puff.shape->bones, &inflate::AwakeEdits::heights, i)) continue;
    out.push_back(handleOn(BoneHold::Knob, *nearest(puff.shape->bones, heights[i].at).point));
    out.back().named = heights[i].at;
  }
  for (const inflate::EditedSkeleton& piece : puff.shape->bones) {
    for (const auto& branch : piece.skeleton.branches) {
      const Line line = lineOf(piece.skeleton, branch);
      const double half = piece.skeleton.points[pointOf(branch, line, 0.5)].radius;
      if (branch.size() > 1 && line.s.back() < kLeastKnob * half) continue;
      const int count = std::clamp(static_cast<int>(line.s.back() / (kKnobApart * half)), 1, 3);
      for (int k = 0; k < count; ++k) {
        const BoneHandle knob =
            handleOn(BoneHold::Knob, piece.skeleton.points[pointOf(branch, line, (k + 0.5) / count)]);
        const bool taken = std::any_of(out.begin() + static_cast<std::ptrdiff_t>(first), out.end(),
                                       [&](const BoneHandle& o) { return distance(o.at, knob.at) < knob.half; });
        if (!taken) out.push_back(knob);
      }
    }
  }
}

void addSlices(const BonedPuff& puff, std::vector<BoneHandle>& out) {
  const auto& slices = puff.params->profile.slices;
  for (std::size_t k = 0; k < slices.size(); ++k) {
    if (!slices[k].at || !inflate::isAwake(puff.shape->bones, &inflate::AwakeEdits::slices, k)) continue;
    const Found found = nearest(puff.shape->bones, *slices[k].at);
    out.push_back(handleOn(BoneHold::Slice, *found.point));
    out.back().across = found.across;
    out.back().edit = k;
  }
}

void addBones(const BonedPuff& puff, std::vector<BoneHandle>& out) {
  for (const inflate::EditedSkeleton& piece : puff.shape->bones) {
    for (const auto& branch : piece.skeleton.branches) {
      if (branch.size() < 2) continue;
      Line line = lineOf(piece.skeleton, branch);
      BoneHandle& bone = out.emplace_back(handleOn(BoneHold::Bone, piece.skeleton.points[pointOf(branch, line, 0.5)]));
      bone.at = bone.named = geometry::pointAt(std::span<const PicturePoint>(line.points),
                                               std::span<const double>(line.s), line.s.back() / 2);
      bone.line = std::move(line.points);
      for (std::size_t i = 0; i < piece.reached.size(); ++i) {
        if (piece.reached[i] == branch.front() || piece.reached[i] == branch.back()) bone.added = i;
      }
    }
  }
  for (const inflate::EditedSkeleton& piece : puff.shape->bones) {
    for (const inflate::GoneBranch& gone : piece.gone) {
      BoneHandle& bone = out.emplace_back();
      bone.hold = BoneHold::Gone;
      bone.edit = gone.drop;
      for (const SectionPoint p : gone.line) bone.line.push_back(down(p));
      bone.at = bone.named = bone.line[bone.line.size() / 2];
    }
  }
}

}  // namespace

BonedPuff bonedPuff(const document::Document& document, const document::Part& part, const pipeline::PartShape* shape) {
  const document::InflateRecipe* puff = document::inflateOf(part);
  const bool boned = puff != nullptr && !puff->inflate.profile.isSoft() && shape != nullptr && !shape->bones.empty();
  if (!boned) return {};
  const document::PictureEntry* entry = document::findPicture(document, document::pictureOf(part));
  return {&part, &puff->inflate, shape, entry ? entry->size : image::Size()};
}

BonedPuff bonedPuff(const document::Document& document, const pipeline::Derived& derived, PartId id) {
  const std::size_t count = std::min(document.parts.size(), derived.parts.size());
  for (std::size_t i = 0; i < count; ++i) {
    if (document.parts[i]->id == id) return bonedPuff(document, document.parts[i], derived.parts[i].shape.get());
  }
  return {};
}

BonedPuff bonesInHand(const document::Document& document, const pipeline::Derived& derived, const UiState& ui) {
  if (ui.tool != ToolKind::Spine) return {};
  const BonedPuff puff = bonedPuff(document, derived, ui.selection);
  return puff && document::pictureOf(*puff.part) == ui.picture ? puff : BonedPuff{};
}

BonedPuff bonesShown(const BonedPuff& puff, const UiState& ui) {
  const Preview* preview = puff ? previewOf(ui, puff.part->id) : nullptr;
  const auto* recipe = preview ? std::get_if<document::InflateRecipe>(&preview->recipe) : nullptr;
  if (recipe == nullptr || preview->shape->bones.empty()) return puff;
  return {puff.part, &recipe->inflate, &*preview->shape, puff.picture};
}

std::string_view holdKey(BoneHold hold) {
  static constexpr std::array<std::string_view, 5> kKeys = {"node", "knob", "slice", "bone", "gone"};
  return kKeys[static_cast<std::size_t>(hold)];
}

std::vector<BoneHandle> boneHandles(const BonedPuff& puff) {
  std::vector<BoneHandle> out;
  if (!puff) return out;
  addNodes(puff, out);
  addKnobs(puff, out);
  addSlices(puff, out);
  addBones(puff, out);
  return out;
}

ClientPoint holdOnCanvas(const BoneHandle& handle, const UiState& ui) {
  const ClientPoint at = ui.pictureView.toClient(handle.at, ui.layout.picture);
  if (handle.hold == BoneHold::Knob) return at - ClientPoint{0, stemOf(handle.factor)};
  if (handle.hold != BoneHold::Slice) return at;
  const double out = handle.half * ui.pictureView.zoom + kSliceRoom;
  return at + ClientPoint{handle.across.x, handle.across.y} * out;
}

double pulledFactor(double before, double by) {
  const double root = std::max(0.0, std::sqrt(before) + by / kRise);
  return std::clamp(root * root, inflate::kLeastFactor, inflate::kMostFactor);
}

int boneAt(const std::vector<BoneHandle>& handles, const UiState& ui, ClientPoint at, double reach, double lineReach) {
  int best = -1;
  for (std::size_t i = 0; i < handles.size(); ++i) {
    if (!handles[i].line.empty()) continue;
    const double off = distance(holdOnCanvas(handles[i], ui), at);
    if (off > reach) continue;
    reach = off;
    best = static_cast<int>(i);
  }
  if (best >= 0) return best;
  const PicturePoint p = ui.pictureView.toPicture(at, ui.layout.picture);
  for (std::size_t i = 0; i < handles.size(); ++i) {
    if (handles[i].line.empty()) continue;
    const double off =
        geometry::distanceToLine(p, std::span<const PicturePoint>(handles[i].line)) * ui.pictureView.zoom;
    if (off > lineReach) continue;
    lineReach = off;
    best = static_cast<int>(i);
  }
  return best;
}

std::vector<std::vector<ModelPoint>> sliceLines(const BonedPuff& puff, const BoneHandle& slice) {
  const inflate::InflateParams& params = *puff.params;
  const auto curves = inflate::profileCurves(params.profile.slices[slice.edit].shape, params.sides);
  if (!curves) return {};
  double widest = 0;
  for (const inflate::EditedSkeleton& piece : puff.shape->bones) {
    for (const inflate::SkeletonPoint& point : piece.skeleton.points) widest = std::max(widest, point.radius);
  }
  const bool rim = params.profile.across == inflate::Across::Length;
  const double reach = params.profile.reach * std::max(puff.picture.width, puff.picture.height);
  const double width = rim ? std::min(slice.half, reach) : slice.half;
  if (rim) widest = std::min(widest, reach);
  inflate::RowParams rows;
  rows.follow = params.profile.follow;
  rows.widest = widest;
  const double high = inflate::thicknessOf(width, rows) * slice.factor * params.height;
  std::vector<std::vector<ModelPoint>> lines;
  for (const auto& [points, closed] : curves.value()) {
    for (const double side : {1.0, -1.0}) {
      std::vector<ModelPoint>& line = lines.emplace_back();
      const auto put = [&](double out, double z) {
        const PicturePoint at = slice.at + slice.across * (side * out);
        line.push_back({at.x, -at.y, z * high});
      };
      for (std::size_t i = 0; i < points.size() + (closed ? 1 : 0); ++i) {
        const SectionPoint p = points[i % points.size()];
        const bool flat = p.x == 0 && width < slice.half;  // from there to the bone
        if (flat && i == 0) put(0, p.y);
        put(slice.half - width * (1 - p.x), p.y);
        if (flat && i > 0) put(0, p.y);
      }
    }
  }
  return lines;
}

namespace {
pipeline::ToWorld inWorld(const BonedPuff& puff, const UiState& ui) {
  return *shownCopies(ui, *puff.part, puff.picture).begin();
}
}  // namespace

std::optional<ClientPoint> holdInSolid(const BonedPuff& puff, const BoneHandle& slice, const UiState& ui) {
  ModelPoint top{slice.at.x, -slice.at.y, 0};
  for (const auto& line : sliceLines(puff, slice)) {
    for (const ModelPoint& p : line) {
      if (p.z > top.z) top = p;
    }
  }
  return pointOnCanvas(ui.camera, ui.layout.solid, inWorld(puff, ui)(top));
}

int sliceInSolid(const BonedPuff& puff, const UiState& ui, ClientPoint at, double reach) {
  int best = -1;
  const std::vector<BoneHandle> handles = boneHandles(puff);
  for (std::size_t i = 0; i < handles.size(); ++i) {
    if (handles[i].hold != BoneHold::Slice) continue;
    const auto hold = holdInSolid(puff, handles[i], ui);
    if (!hold || distance(*hold, at) > reach) continue;
    reach = distance(*hold, at);
    best = static_cast<int>(i);
  }
  return best;
}

std::optional<PicturePoint> onBonesInSolid(const BonedPuff& puff, const UiState& ui, ClientPoint at) {
  std::optional<PicturePoint> best;
  double least = std::numeric_limits<double>::infinity();
  const pipeline::ToWorld toWorld = inWorld(puff, ui);
  for (const inflate::EditedSkeleton& piece : puff.shape->bones) {
    for (const inflate::SkeletonPoint& point : piece.skeleton.points) {
      const auto seen = pointOnCanvas(ui.camera, ui.layout.solid, toWorld(ModelPoint{point.at.x, point.at.y, 0}));
      if (!seen || distance(*seen, at) >= least) continue;
      least = distance(*seen, at);
      best = down(point.at);
    }
  }
  return best;
}

std::string boneSentence(const std::vector<BoneHandle>& handles, int handle) {
  if (handle < 0 || handle >= static_cast<int>(handles.size())) return {};
  const BoneHandle& own = handles[static_cast<std::size_t>(handle)];
  int number = 0, all = 0;
  for (std::size_t i = 0; i < handles.size(); ++i) {
    if (handles[i].hold != own.hold) continue;
    ++all;
    if (static_cast<int>(i) <= handle) ++number;
  }
  const auto say = [&](const char* sentence) {
    return std::string(words::tr(
        sentence, {{"n", number}, {"all", all}, {"percent", static_cast<int>(std::lround(100 * own.factor))}}));
  };
  switch (own.hold) {
    case BoneHold::Node:
      return say("End or fork {n} of {all} of the bones. Drag it, or move it with the arrows.");
    case BoneHold::Knob:
      return say("Knob {n} of {all}: {percent} % thick. Pull it up for thicker, down for thinner.");
    case BoneHold::Slice:
      return say("Slice {n} of {all} at a place. Drag it along the bones.");
    case BoneHold::Bone:
      return say("Bone {n} of {all}. A tap or Delete leaves it out.");
    case BoneHold::Gone:
      return say("Bone {n} of {all} that is left out. A tap or Delete takes it back.");
  }
  return {};
}

BoneEdit dropBone(const inflate::InflateParams& puff, PicturePoint at) {
  BoneEdit edit{puff, &inflate::AwakeEdits::drop, puff.bones.drop.size()};
  edit.params.bones.drop.push_back(at);
  return edit;
}

BoneEdit addBone(const inflate::InflateParams& puff, const std::vector<PicturePoint>& line) {
  BoneEdit edit{puff, &inflate::AwakeEdits::add, puff.bones.add.size()};
  constexpr std::size_t kPoints = 64;  // that a hand's line needs
  const bool many = line.size() > kPoints;
  edit.params.bones.add.push_back(many ? geometry::resample(std::span<const PicturePoint>(line), kPoints) : line);
  return edit;
}

BoneEdit moveBone(const inflate::InflateParams& puff, PicturePoint from, PicturePoint to) {
  BoneEdit edit{puff, &inflate::AwakeEdits::move, 0};
  auto& moves = edit.params.bones.move;
  const auto same = std::ranges::find_if(moves, [&](const auto& m) { return distance(m.to, from) < kSamePlace; });
  edit.number = static_cast<std::size_t>(same - moves.begin());
  if (same == moves.end()) {
    moves.push_back({from, to});
  } else {
    same->to = to;
  }
  return edit;
}

BoneEdit raiseBone(const inflate::InflateParams& puff, PicturePoint at, double factor) {
  BoneEdit edit{puff, &inflate::AwakeEdits::heights, 0};
  auto& heights = edit.params.bones.heights;
  const auto same = std::ranges::find_if(heights, [&](const auto& h) { return distance(h.at, at) < kSamePlace; });
  edit.number = static_cast<std::size_t>(same - heights.begin());
  if (same == heights.end()) {
    heights.push_back({at, factor});
  } else {
    same->factor = factor;
  }
  return edit;
}

BoneEdit moveSlice(const inflate::InflateParams& puff, std::size_t slice, PicturePoint to) {
  BoneEdit edit{puff, &inflate::AwakeEdits::slices, slice};
  edit.params.profile.slices[slice].at = to;
  return edit;
}

inflate::ProfileParams withBase(const inflate::ProfileParams& puff, const inflate::ProfileParams& next) {
  if (next.isSoft()) return next;
  inflate::ProfileParams out = next;
  out.across = puff.across;
  out.reach = puff.reach;
  if (puff.slices.size() < 2) return out;
  out.slices = puff.slices;
  const auto base = std::ranges::find_if(out.slices, [](const auto& slice) { return !slice.at; });
  (base == out.slices.end() ? out.slices.front() : *base).shape = next.slices.front().shape;
  return out;
}

std::size_t pickedSlice(const BonedPuff& puff, const UiState& ui) {
  if (!puff) return 0;
  const std::vector<BoneHandle> handles = boneHandles(puff);
  const bool chosen =
      ui.tool == ToolKind::Spine && ui.chosen.bone >= 0 && ui.chosen.bone < static_cast<int>(handles.size());
  if (chosen && handles[static_cast<std::size_t>(ui.chosen.bone)].hold == BoneHold::Slice)
    return handles[static_cast<std::size_t>(ui.chosen.bone)].edit;
  const auto& slices = puff.params->profile.slices;
  const auto base = std::ranges::find_if(slices, [](const auto& slice) { return !slice.at; });
  return base == slices.end() ? 0 : static_cast<std::size_t>(base - slices.begin());
}

std::optional<BoneEdit> dragged(const BonedPuff& puff, const BoneHandle& handle, PicturePoint from, PicturePoint to,
                                double zoom) {
  switch (handle.hold) {
    case BoneHold::Node:
      return moveBone(*puff.params, handle.named, handle.at + (to - from));
    case BoneHold::Knob:
      return raiseBone(*puff.params, handle.named, pulledFactor(handle.factor, (from.y - to.y) * zoom));
    case BoneHold::Slice: {
      const auto place = onBones(*puff.shape, handle.at + (to - from));
      return place ? std::optional(moveSlice(*puff.params, handle.edit, *place)) : std::nullopt;
    }
    case BoneHold::Bone:
    case BoneHold::Gone:
      break;
  }
  return std::nullopt;
}

bool findsPlace(const pipeline::PartShape& shape, const BoneEdit& edit) {
  std::vector<inflate::EditedSkeleton> bones;
  for (const geometry::Contours& piece : geometry::piecesOf(shape.contours)) {
    auto made = inflate::editedSkeleton(piece, edit.params.bones, edit.params.profile.slices);
    if (!made) return false;
    bones.push_back(std::move(made).value());
  }
  return inflate::isAwake(bones, edit.kind, edit.number);
}

std::optional<PicturePoint> onBones(const pipeline::PartShape& shape, PicturePoint p) {
  const Found found = nearest(shape.bones, p);
  return found.point ? std::optional(down(found.point->at)) : std::nullopt;
}

}  // namespace spineloft::app
