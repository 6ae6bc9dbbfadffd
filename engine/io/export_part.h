// What the writers of 3D files are given.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/mesh/tri_mesh.h"

namespace spineloft::io {

using Bytes = std::vector<std::uint8_t>;

/// From the mesh's space to the file's: written = (position − origin) · scale, then the format's
/// own axes. `origin` in the mesh's units; `scale` in the file's units (metres, millimetres, …) per
/// unit of the mesh, 1e-9…1e9. Parts of one model share their placement when they share their
/// space.
struct Placement {
  std::array<double, 3> origin{};
  double scale = 1;
  bool operator==(const Placement&) const = default;
};

/// A part to write. The mesh is in any right-handed space with y up and +z to the viewer
/// (ModelSpace or WorldSpace); it must outlive the call and be lawful (mesh/laws.h).
struct ExportPart {
  std::string name;  ///< UTF-8; what is not valid becomes '?'
  const mesh::TriMesh* mesh = nullptr;
  Placement placement;
  std::optional<std::size_t> picture;             ///< index of the picture on its surface; needs UV
  std::array<float, 3> colour{0.8f, 0.8f, 0.8f};  ///< sRGB 0…1, where there is no picture
  double roughness = 0.8, metallic = 0;           ///< 0…1
  bool faceted = false;                           ///< every triangle flat, where the format has normals
  bool ofSolid = false;                           ///< some faces of a closed solid: open by itself
  bool joins = false;                             ///< belongs to the same node as the part before it
};

/// An encoded picture file (PNG or JPEG) as it shall lie in the 3D file; bytes must outlive the
/// call.
struct ExportPicture {
  std::string name;  ///< UTF-8
  std::span<const std::uint8_t> bytes;
};

/// Whether the parts can be written. Errors: NothingToExport (no part), MeshInvalid (no mesh, a
/// mesh law broken, or a picture without UV; the detail says which part and law), ValueOutOfRange
/// (placement or colour), NoSuchPicture.
Status checkParts(std::span<const ExportPart> parts, std::size_t pictures);

/// The text with every byte that is not part of valid UTF-8 replaced by '?', control characters
/// (line ends among them) by spaces.
std::string cleanName(const std::string& text);

/// A placed position before the format's own axes.
inline std::array<double, 3> placed(const Placement& placement, const std::array<float, 3>& p) {
  return {(p[0] - placement.origin[0]) * placement.scale, (p[1] - placement.origin[1]) * placement.scale,
          (p[2] - placement.origin[2]) * placement.scale};
}

}  // namespace spineloft::io
