// Beginning a preview: the part as it would be, shown instead of the part until the gesture ends.
#pragma once

#include "web/model/studio.h"
#include "web/platform/host.h"
#include "web/ui/ui_state.h"

namespace spineloft::app {

/// Of a puff under the pen, at most.
inline constexpr int kPreviewPoints = 900;

/// A preview of nothing yet, in place of another one.
Preview& beginPreview(UiState& ui);
/// A preview of this part, starting from its recipe; a preview of something else is dropped.
Preview& previewPart(UiState& ui, const document::Part& part);
/// A preview of the next part, made as the panels say, on the picture in view.
Preview& previewNewPart(UiState& ui);
/// The region that a line round a thing, or along one, stands for: closed where its ends are near each
/// other, else a ribbon of a usual width for a picture of this size.
document::Region regionOfLine(PictureId picture, std::vector<PicturePoint> line, image::Size size);
/// Makes the shape of the gesture's preview, as often as its cost allows: no frame waits for it. The exact shape is
/// made once the pointer rests. After the first stroke, strokes of the same size allocate nothing.
void growPreview(UiState& ui, Studio& studio, const platform::Host& host);
/// A gesture on a part of a solid changes the solid, as far as the solver keeps up; one on the depth of a line drawing
/// changes all its pieces.
void growSolid(UiState& ui, Studio& studio, const platform::Host& host);
/// From now on a preview of a standing part is not taken where the part would go through itself, unless it does
/// already.
void guardPreview(UiState& ui, const document::Document& document, const pipeline::Derived& derived);
/// The recipe that is shown while the pointer asks for one that is refused; else null.
const document::LoftRecipe* heldBack(const UiState& ui);
/// The preview that stands for this part on the screen, once it has a shape; else null.
const Preview* previewOf(const UiState& ui, PartId part);

}  // namespace spineloft::app
