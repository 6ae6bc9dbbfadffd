#include "engine/io/export_part.h"

#include <algorithm>
#include <cmath>

#include "engine/mesh/laws.h"

namespace spineloft::io {
namespace {

/// Bytes of the valid UTF-8 character that begins at `at`; 0 when there is none.
std::size_t characterAt(const std::string& text, std::size_t at) {
  const auto byte = [&](std::size_t i) {
    return i < text.size() ? static_cast<unsigned>(static_cast<unsigned char>(text[i])) : 0u;
  };
  const unsigned lead = byte(at);
  if (lead < 0x80) return 1;
  const std::size_t length = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
  if (lead < 0xc2 || lead > 0xf4) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(at + i) & 0xc0) != 0x80) return 0;
  }
  // Overlong forms, surrogates and what lies beyond Unicode.
  const unsigned second = byte(at + 1);
  if ((lead == 0xe0 && second < 0xa0) || (lead == 0xed && second > 0x9f) ||
      (lead == 0xf0 && second < 0x90) || (lead == 0xf4 && second > 0x8f)) {
    return 0;
  }
  return length;
}

bool inRange(const ExportPart& part) {
  constexpr double kSmallest = 1e-9, kLargest = 1e9;
  const Placement& placement = part.placement;
  return placement.scale >= kSmallest && placement.scale <= kLargest &&
         std::all_of(placement.origin.begin(), placement.origin.end(),
                     [](double c) { return std::abs(c) <= kLargest; }) &&
         std::all_of(part.colour.begin(), part.colour.end(),
                     [](float c) { return c >= 0 && c <= 1; });
}

}  // namespace

Status checkParts(std::span<const ExportPart> parts, std::size_t pictures) {
  if (parts.empty()) return Error::NothingToExport;
  for (const ExportPart& part : parts) {
    const std::string name = cleanName(part.name);
    if (part.mesh == nullptr) return {Error::MeshInvalid, name + ": no mesh"};
    const std::string broken = mesh::brokenLaw(mesh::inspect(*part.mesh));
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
    const std::size_t length = characterAt(text, at);
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
