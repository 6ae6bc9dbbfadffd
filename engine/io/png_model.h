// A PNG picture with a file inside: in a chunk of its own, which other programs leave alone or leave out (Portable
// Network Graphics specification, third edition, 5.3 and 5.4).
#pragma once

#include <cstdint>
#include <span>

#include "engine/base/result.h"
#include "engine/io/export_part.h"

namespace spineloft::io {

/// Whether it begins as a PNG.
bool isPng(std::span<const std::uint8_t> file);
/// The picture with `model` behind its header, in place of one that is there. Errors: PictureUnreadable (no PNG),
/// PictureTruncated (a PNG whose chunks end early), OutOfMemory (2 GiB and more).
Result<Bytes> withModel(std::span<const std::uint8_t> png, std::span<const std::uint8_t> model);
/// What withModel put in; it lies in `png`. Errors: NoProjectInside (also when it is no PNG), ProjectInvalid (its end
/// is missing, or its checksum is wrong).
Result<std::span<const std::uint8_t>> modelInPng(std::span<const std::uint8_t> png);

}  // namespace spineloft::io
