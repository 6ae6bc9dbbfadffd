// The document: only what a person authored. A few kilobytes without the pictures; a value that is
// compared, copied and kept in the history. Everything else is derived (pipeline/).
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "engine/base/ids.h"
#include "engine/base/units.h"
#include "engine/base/vec.h"
#include "engine/image/image.h"
#include "engine/loft/loft.h"
#include "engine/ribs/ribs.h"

namespace spineloft::document {

/// A picture on the board. The pixels are immutable and shared by every document that shows them;
/// two entries are equal when their content hashes are.
struct PictureEntry {
  PictureId id;
  std::string name;  ///< file name or title, UTF-8
  std::shared_ptr<const image::Picture> picture;  ///< never null in a document
  std::uint64_t contentHash = 0;
  bool operator==(const PictureEntry& other) const {
    return id == other.id && name == other.name && contentHash == other.contentHash;
  }
};

/// Recipe of a part made by one stroke: the authored input of spine → ribs → loft.
struct LoftRecipe {
  PictureId picture;                 ///< on which the stroke was drawn
  std::vector<PicturePoint> stroke;  ///< as drawn
  ribs::SpineParams spine;
  ribs::RibParams ribs;
  loft::LoftParams loft;
  bool operator==(const LoftRecipe&) const = default;
};

/// How a part's surface looks.
struct Look {
  bool textured = true;                              ///< the picture on the surface, else `colour`
  std::array<std::uint8_t, 3> colour{236, 158, 92};  ///< sRGB
  bool operator==(const Look&) const = default;
};

struct Part {
  PartId id;
  std::string name;  ///< UTF-8, at most kMaxNameBytes
  LoftRecipe recipe;
  Look look;
  bool visible = true;
  bool operator==(const Part&) const = default;
};

struct Document {
  std::string name = "Model";
  std::vector<PictureEntry> pictures;  ///< in the order they were added
  std::vector<Part> parts;             ///< in the order of the part list
  Millimetres height{100};             ///< "How tall?": of the whole model when exported
  std::uint32_t lastPictureId = 0, lastPartId = 0;  ///< ids are never reused
  bool operator==(const Document&) const = default;
};

inline constexpr std::size_t kMaxNameBytes = 200;
inline constexpr double kMinHeightMm = 1, kMaxHeightMm = 10000;

/// The entry, or null.
const PictureEntry* findPicture(const Document& document, PictureId id);
const Part* findPart(const Document& document, PartId id);

/// Hash of a picture's pixels and sizes, as PictureEntry::contentHash holds it.
std::uint64_t contentHash(const image::Picture& picture);

}  // namespace spineloft::document
