// A model as a link holds it: as a text that says all of it, without its photos.
#pragma once

#include <string>

#include "engine/base/result.h"
#include "engine/document/document.h"
#include "engine/pipeline/derive.h"

namespace spineloft::publish {

/// The document without its photos. White pictures of their sizes stand in their places; what was found in a photo is
/// fixed: each end of each rib of a loft on one is put where it stands (ribs/edit/edits.h), and a part that shows the
/// photo gets the mean colour of what it shows of it. Documents without photos come back as they are.
document::Document withoutPhotos(const document::Document& document, const pipeline::Derived& derived);

/// Longest text that most programs take as a link and that a QR code holds well, characters.
inline constexpr std::size_t kMostLinkText = 1900;

struct SharedModel {
  std::string text;            ///< io/share_text.h
  std::size_t photosLeft = 0;  ///< photos that are not in it
};
/// Error: OutOfMemory.
Result<SharedModel> shareModel(const document::Document& document, const pipeline::Derived& derived);

}  // namespace spineloft::publish
