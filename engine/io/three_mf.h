// 3MF (3D Manufacturing Format, Core Specification 1.2 and Materials Extension 1.1): what slicers read,
// with its unit and its colours.
#pragma once

#include <span>

#include "engine/base/result.h"
#include "engine/io/export_part.h"

namespace spineloft::io {

/// One object a part, or one for all parts that join to a solid, which is closed by its vertices' numbers;
/// put together to one object that is printed as one thing, in millimetres
/// (placements scale to millimetres), z up, front towards −y as in an STL, in the corner of the positive
/// octant. A part's colour is a base material, its picture a 2D texture. Equal input gives equal bytes.
/// Errors: those of checkParts, PictureUnreadable (a used picture is neither PNG nor JPEG),
/// OutOfMemory.
Result<Bytes> write3mf(std::span<const ExportPart> parts, std::span<const ExportPicture> pictures);

}  // namespace spineloft::io
