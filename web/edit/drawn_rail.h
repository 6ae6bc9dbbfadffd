// A line drawn across the solid view as the rail of a part made of layers.
#pragma once

#include <span>

#include "engine/base/result.h"
#include "web/edit/layers.h"
#include "web/edit/picker.h"

namespace spineloft::app {

/// Whether the next line in the solid view becomes the rail of the sheet's part.
bool drawsRail(const document::Document& document, const UiState& ui);

/// The rail of the sheet's part along a line of the canvas. Where the line lies before other parts it goes along their
/// surfaces, lifted off them so that of what is drawn on the layers, on average, a tenth of the size is within them,
/// and between and beside these places it is as deep as at those next to it. Bends tighter than 1.2 times the mean
/// radius of the layers become wider. Where it meets no part it lies in the plane of the view through the middle of the
/// rail before. It is closed where its ends come within a tenth of its length, and straight where it is nearly so.
/// Error: StackInvalid for a line that is too short.
Result<stack::Rail> railAlong(const document::Document& document, const pipeline::Derived& derived, const UiState& ui,
                              Picker& picker, const Sheet& sheet, std::span<const ClientPoint> line);

}  // namespace spineloft::app
