// What of a document a share text keeps (share_text.h). Internal to io/.
#pragma once

#include "engine/document/document.h"
#include "engine/io/json_fields.h"

namespace spineloft::io {

/// The document with its places on their grids, and its rib ends as a text tells them (share_ends.h).
document::Document onGrids(const document::Document& document);
/// Every number that has more digits than a text keeps and is on no grid is rounded, and whole ones of keys that are
/// not known stand without a point, as all others do.
void roundNumbers(Json& json);

inline constexpr const char* kPicturesKey = "pictures";
/// The list with this key; null where there is none.
Json* listOf(Json& json, const char* key);

}  // namespace spineloft::io
