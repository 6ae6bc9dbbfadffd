// Frames along a line in space.
#pragma once

#include <span>
#include <vector>

#include "engine/base/vec.h"

namespace spineloft::geometry {

/// A place on a line in ModelSpace with three orthonormal directions. `across` is to the right of
/// travel for someone whose `depth` direction points at the viewer: tangent = depth × across.
struct Frame {
  ModelPoint at, tangent, across, depth;
  bool operator==(const Frame&) const = default;
};

/// The frame halfway (`t` = 0…1) between two close ones, made orthonormal again.
Frame between(const Frame& a, const Frame& b, double t);

/// Unit tangents of a smooth line at its points, by the parabola through each point and its
/// neighbours; ≥ 2 points, neighbours should be distinct. `closed`: the last point is the first again, and both
/// get the same tangent. Into `tangents`, whose memory is reused.
void tangentsOf(std::span<const ModelPoint> line, bool closed, std::vector<ModelPoint>& tangents);

/// Frames that turn about the tangent as little as a line allows (rotation-minimising frames by
/// double reflection; Wang, Jüttler, Zheng and Liu 2008; with these tangents the error falls with
/// the square of the spacing). Line as for
/// tangentsOf. The first `across` is the direction given, made square to the first tangent; a given
/// direction along the tangent is replaced by any other. On a closed line what the frame has turned by
/// after one round is taken back evenly along the length, so that the last frame is the first.
std::vector<Frame> minimalFrames(std::span<const ModelPoint> line, ModelPoint firstAcross, bool closed);
/// The same into `frames`; `tangents` is memory.
void minimalFrames(std::span<const ModelPoint> line, ModelPoint firstAcross, bool closed,
                   std::vector<ModelPoint>& tangents, std::vector<Frame>& frames);

}  // namespace spineloft::geometry
