// Binary STL, for 3D printers.
#pragma once

#include <span>

#include "engine/base/result.h"
#include "engine/io/export_part.h"

namespace spineloft::io {

/// All triangles of all parts in one solid, in millimetres (placements scale to millimetres),
/// little endian: 80 bytes of header, a count, then 50 bytes a triangle (unit normal, three
/// corners, 0). Printers have z up, so the model is stood up: (x, y, z) is written as (x, −z, y);
/// its front looks towards −y. Triangles two of whose corners fall into one place as floats are left out:
/// by places the solid stays closed. Errors: those of checkParts (pictures are not looked at),
/// OutOfMemory (also above 2³² − 1 triangles).
Result<Bytes> writeStl(std::span<const ExportPart> parts);

}  // namespace spineloft::io
