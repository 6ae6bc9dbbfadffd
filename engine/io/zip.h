// ZIP archives (PKWARE APPNOTE 6.3.3, the part of it that everything reads), and the DEFLATE in them.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "engine/base/result.h"
#include "engine/io/export_part.h"

namespace spineloft::io {

/// A file of an archive. Bytes must outlive the call.
struct ZipEntry {
  std::string name;  ///< UTF-8, folders with '/', at most 65,535 bytes
  std::span<const std::uint8_t> bytes;
  bool squeeze = true;  ///< false for what is compressed already
};

/// An archive with the files in this order, dated 1 January 1980 (there is no clock here): equal input
/// gives equal bytes. Error: OutOfMemory (also above 2 GiB, or 65,535 files).
Result<Bytes> writeZip(std::span<const ZipEntry> files);

}  // namespace spineloft::io
