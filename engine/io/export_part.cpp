#include "engine/io/export_part.h"

#include <algorithm>
#include <cmath>

#include "engine/base/text.h"
#include "engine/mesh/laws.h"

namespace spineloft::io {
namespace {

bool inRange(const ExportPart& part) {
  constexpr double kSmallest = 1e-9, kLargest = 1e9;
  const Placement& placement = part.placement;
  return placement.scale >= kSmallest && placement.scale <= kLargest &&
         std::all_of(placement.origin.begin(), placement.origin.end(),
                     [](double c) { return std::abs(c) <= kLargest; }) &&
         part.roughness >= 0 && part.roughness <= 1 && part.metallic >= 0 && part.metallic <= 1 &&
         std::all_of(part.colour.begin(), part.colour.end(), [](float c) { return c >= 0 && c <= 1; });
}

}  // namespace

Status checkParts(std::span<const ExportPart> parts, std::size_t pictures) {
  if (parts.empty()) return Error::NothingToExport;
  for (const ExportPart& part : parts) {
    const std::string name = cleanName(part.name);
    if (part.mesh == nullptr) return {Error::MeshInvalid, name + ": no mesh"};
    const mesh::MeshReport report = mesh::inspect(*part.mesh);
    const bool sound = report.finite && report.indexed && report.uvInRange;
    const std::string broken = part.ofSolid && sound ? std::string() : mesh::brokenLaw(report);
    if (!broken.empty()) return {Error::MeshInvalid, name + ": " + broken};
    if (!inRange(part)) return {Error::ValueOutOfRange, name};
    if (!part.picture) continue;
    if (*part.picture >= pictures) return {Error::NoSuchPicture, name};
    if (part.mesh->uv.empty()) return {Error::MeshInvalid, name + ": no texture coordinates"};
  }
  return Done{};
}

std::string cleanName(const std::string& text) {
  std::string clean;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = utf8CharacterAt(text, at);
    if (length == 0) {
      clean += '?';
      ++at;
      continue;
    }
    const unsigned char first = static_cast<unsigned char>(text[at]);
    if (first < 0x20 || first == 0x7f) {
      clean += ' ';
    } else {
      clean.append(text, at, length);
    }
    at += length;
  }
  return clean;
}

}  // namespace spineloft::io
