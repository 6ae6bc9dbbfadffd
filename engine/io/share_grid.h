// What of a document a share text keeps, and how it tells rib ends (share_text.h). Internal to io/.
#pragma once

#include "engine/document/document.h"
#include "engine/io/json_fields.h"

namespace spineloft::io {

/// The version from which on ends at ribs are told beside their curves, and the text is the shorter by its zeros.
inline constexpr int kFirstOnCurves = 3;

/// The document with its places on their grids, and its rib ends as a text tells them.
document::Document onGrids(const document::Document& document);
/// In the JSON of such a document rib ends at a rib come to where a text of this version says that they are.
void findEnds(Json& document, int version);
/// Every number that has more digits than a text keeps and is on no grid is rounded.
void roundNumbers(Json& json);

inline constexpr const char* kPicturesKey = "pictures";
/// The list with this key; null where there is none.
Json* listOf(Json& json, const char* key);

}  // namespace spineloft::io
