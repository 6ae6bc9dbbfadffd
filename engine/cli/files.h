// Files of the command line: read whole, written all or none.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/base/result.h"

namespace spineloft::cli {

using Bytes = std::vector<std::uint8_t>;

/// The whole file, at least one byte. Error: FileUnreadable (missing, a folder, no permission, empty, over
/// 1 GiB), OutOfMemory.
Result<Bytes> readFile(const std::string& path);
Result<std::string> readText(const std::string& path);

inline Bytes bytesOf(const std::string& text) { return Bytes(text.begin(), text.end()); }

/// One file to write; a file of that name is replaced.
struct OutputFile {
  std::string path;
  Bytes bytes;
};

/// Writes every file beside its final name first and then gives all of them their names, so that a
/// reader never sees half a file, and after a failure every file is as it was before. A signal that is to end the
/// program waits until then, and counts as a failure. Error: FileUnwritable with the file's name.
Status writeAll(const std::vector<OutputFile>& files);

/// Whether both paths lead to the same file, whether or not it exists.
bool samePlace(const std::string& a, const std::string& b);

}  // namespace spineloft::cli
