// The renderer of the page: WebGL2 (or OpenGL ES 3 in the desktop window).
#pragma once

#include <memory>

#include "web/gl/renderer.h"

namespace spineloft::gl {

/// Needs a current context and an ImGui context; null when a shader does not build.
std::unique_ptr<Renderer> makeWebGlRenderer();

}  // namespace spineloft::gl
