// A model as a link holds it, with small copies of its photos.
#pragma once

#include "engine/io/share_text.h"
#include "engine/publish/share_model.h"

namespace spineloft::publish {

/// As shareModel without copies; a part that shows a photo of which there is a copy goes on to show it, and has the
/// mean colour besides, for whoever cannot decode the copy. Error: OutOfMemory.
Result<SharedModel> shareModel(const document::Document& document, const pipeline::Derived& derived,
                               const io::PhotoCopies& copies);

}  // namespace spineloft::publish
