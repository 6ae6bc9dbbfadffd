// A finished model as a file: document + derived parts → bytes. The only place that joins pipeline
// and io; the page and the command line both export through it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/progress.h"
#include "engine/base/result.h"
#include "engine/document/document.h"
#include "engine/pipeline/derive.h"

namespace spineloft::publish {

using Bytes = std::vector<std::uint8_t>;

enum class Format : std::uint8_t { Glb, Obj, Stl };
/// "glb", "obj", "stl"; none for anything else (case does not matter).
std::optional<Format> formatFromKey(std::string_view key);
std::string_view formatKey(Format format);
std::string_view mediaType(Format format);

/// ModelSpace → WorldSpace for parts of a picture of this size: the picture's centre goes to the
/// origin and its longer side to length 1. `world = (model − centre) · scale`.
struct WorldFrame {
  double scale = 1;
  ModelPoint centre;
  WorldPoint toWorld(ModelPoint p) const {
    return {(p.x - centre.x) * scale, (p.y - centre.y) * scale, (p.z - centre.z) * scale};
  }
};
WorldFrame worldFrame(image::Size picture);

/// Bounds of all visible derived parts in WorldSpace; none without a part.
struct WorldBounds {
  WorldPoint low, high;
};
std::optional<WorldBounds> worldBounds(const document::Document& document,
                                       const pipeline::Derived& derived);

/// All visible parts as one file. GLB: metres, y up, standing on y = 0 and centred in x and z, the
/// model as tall as Document::height, pictures as base-colour textures. OBJ: WorldSpace scaled in the
/// same way to millimetres is not what modelling programs expect of an OBJ, so it keeps WorldSpace
/// units. STL: millimetres, z up.
/// Errors: NothingToExport, MeshInvalid, Cancelled, OutOfMemory.
Result<Bytes> publish(const document::Document& document, const pipeline::Derived& derived,
                      Format format, const Progress& progress);

/// A file name such as "swan-neck_100mm.glb": the model's name in portable characters and its height.
std::string fileName(const document::Document& document, Format format);

}  // namespace spineloft::publish
