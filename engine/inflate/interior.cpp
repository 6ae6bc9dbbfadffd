#include "engine/inflate/interior.h"

#include <algorithm>
#include <utility>

#include "engine/geometry/pieces.h"

namespace spineloft::inflate {

double finenessFor(int points) {
  constexpr double kFullPoints = 1900, kLeastFineness = 0.4;
  return std::clamp(points / kFullPoints, kLeastFineness, 1.0);
}

Result<Interior> interiorOf(const geometry::Contours& contours, const BoneEdits& edits,
                            std::span<const ProfileSlice> slices, int points) {
  const double fineness = finenessFor(points);
  Interior out{geometry::piecesOf(contours), {}, {}};
  for (const geometry::Contours& piece : out.pieces) {
    Result<EditedSkeleton> bones = editedSkeleton(piece, edits, slices, fineness);
    if (!bones) return bones.failure();
    Result<Fields> fields = fieldsOf(piece, bones.value().skeleton, fineness);
    if (!fields) return fields.failure();
    out.bones.push_back(std::move(bones).value());
    out.fields.push_back(std::move(fields).value());
  }
  return out;
}

std::size_t bytesOf(const std::vector<EditedSkeleton>& bones) {
  std::size_t bytes = 0;
  for (const auto& [skeleton, awake, gone, reached] : bones) {
    bytes += sizeof(EditedSkeleton) + skeleton.points.size() * sizeof(SkeletonPoint);
    for (const auto& branch : skeleton.branches) bytes += branch.size() * sizeof(branch[0]);
    for (const GoneBranch& branch : gone) bytes += branch.line.size() * sizeof(SectionPoint);
  }
  return bytes;
}

std::size_t bytesOf(const Interior& interior) {
  std::size_t bytes = bytesOf(interior.bones);
  for (const geometry::Contours& piece : interior.pieces) {
    for (const auto& contour : piece) bytes += contour.size() * sizeof(contour[0]);
  }
  for (const Fields& fields : interior.fields) bytes += bytesOf(fields);
  return bytes;
}

}  // namespace spineloft::inflate
