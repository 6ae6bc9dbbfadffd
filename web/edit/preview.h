// Beginning a preview: the part as it would be, shown instead of the part until the gesture ends.
#pragma once

#include "web/model/studio.h"
#include "web/platform/host.h"
#include "web/ui/ui_state.h"

namespace spineloft::app {

/// A preview of nothing yet, in place of another one.
Preview& beginPreview(UiState& ui);
/// A preview of this part, starting from its recipe; a preview of something else is dropped.
Preview& previewPart(UiState& ui, const document::Part& part);
/// A preview of the next part, made as the panels say, on the picture in view.
Preview& previewNewPart(UiState& ui);
/// The region that a line round a thing, or along one, stands for: closed where its ends are near each
/// other, else a ribbon of a usual width for a picture of this size.
document::Region regionOfLine(PictureId picture, std::vector<PicturePoint> line, image::Size size);
/// Makes the shape of what the gesture in hand makes: as often as the time allows, so that the hand never
/// waits; an exact one once it rests. Once it was warm, a stroke like an earlier one asks for no memory.
void growPreview(UiState& ui, Studio& studio, const platform::Host& host);
/// From now on a preview of a standing part is not taken where the part would go through itself, unless it does
/// already.
void guardPreview(UiState& ui, const document::Document& document, const pipeline::Derived& derived);
/// The recipe that is shown, where the hand asks for one that is not taken; else null.
const document::LoftRecipe* heldBack(const UiState& ui);
/// The preview that stands for this part on the screen, once it has a shape; else null.
const Preview* previewOf(const UiState& ui, PartId part);

}  // namespace spineloft::app
