// Named limits and tolerances that more than one module relies on. Each says its unit and reason.
#pragma once

namespace spineloft {

/// Shortest side of a picture, in pixels: below it an edge detector has nothing to work on.
inline constexpr int kMinPictureSide = 16;
/// Longest side of a picture, in pixels: beyond it even the header is not believed.
inline constexpr int kMaxPictureSide = 32768;
/// Most pixels a picture may declare: a 108-megapixel phone photo fits.
inline constexpr long long kMaxPicturePixels = 120'000'000;
/// Pixels of the working copy: enough for a sharp texture, small enough for a tablet.
inline constexpr long long kWorkingPixels = 4'000'000;
/// Long side of the copy on which edges are sought, in pixels.
inline constexpr int kEdgeLongSide = 1024;
/// Two stroke points closer than this are one point, in picture pixels.
inline constexpr double kSamePoint = 1e-6;

}  // namespace spineloft
