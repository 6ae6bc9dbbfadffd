// From the document, its shapes and the views to what the renderer draws.
#pragma once

#include "engine/document/document.h"
#include "engine/pipeline/derive.h"
#include "web/gl/renderer.h"
#include "web/ui/ui_state.h"

namespace spineloft::app {

/// Fills `scene`, reusing its memory. Its pointers stay valid while document, derived and ui do.
void buildScene(const document::Document& document, const pipeline::Derived& derived, const UiState& ui,
                gl::Scene& scene);

}  // namespace spineloft::app
