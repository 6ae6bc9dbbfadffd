#include "web/platform/browser_host.h"

#include <GLFW/glfw3.h>
#include <emscripten.h>
#include <emscripten/html5.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

// clang-format off
EM_JS(void, splSend, (const char* json), {
  const host = Module['host'];
  if (host && host.onEvent) host.onEvent(UTF8ToString(json));
});

EM_JS(void, splSolve, (const char* json, const void* meshes), {
  const host = Module['host'];
  if (host) host.onSolve(UTF8ToString(json), meshes);
});

EM_JS(void, splCutOut, (unsigned id, const double* hints, int count, const char* key, const unsigned char* rgba,
                         const int* sizes), {
  const host = Module['host'];
  if (host) host.onCutOut(id, hints, count, UTF8ToString(key), rgba, sizes);
});

EM_JS_DEPS(spl_words, "$stringToNewUTF8");
EM_JS(char*, splTranslated, (const char* english, const char* args), {
  return stringToNewUTF8(Module['host'].translated(UTF8ToString(english), UTF8ToString(args)));
});

EM_JS(char*, splDrawn, (const char* text), {
  return stringToNewUTF8(Module['host'].drawn(UTF8ToString(text)));
});

EM_JS(int, splReducedMotion, (), {
  return window.matchMedia('(prefers-reduced-motion: reduce)').matches ? 1 : 0;
});

EM_JS(int, splSoftwareGl, (), {
  // A context of its own, dropped at once: the page's must know before it is made.
  // `sharp` asks for full quality all the same: for screenshots.
  if (Module['sharp']) return 0;
  const gl = document.createElement('canvas').getContext('webgl2');
  if (!gl) return 0;
  const info = gl.getExtension('WEBGL_debug_renderer_info');
  const name = info ? gl.getParameter(info.UNMASKED_RENDERER_WEBGL) : "";
  const lose = gl.getExtension('WEBGL_lose_context');
  if (lose) lose.loseContext();
  return /swiftshader|llvmpipe|software|basic render/i.test(name) ? 1 : 0;
});

EM_JS(void, splDropGlfwListeners, (), {
  const canvas = Module['canvas'];
  const drop = (target, names) => {
    for (const [name, listener] of names) target.removeEventListener(name, listener, true);
  };
  drop(window, [['keydown', GLFW.onKeydown], ['keypress', GLFW.onKeyPress],
                ['keyup', GLFW.onKeyup], ['blur', GLFW.onBlur],
                ['gamepadconnected', GLFW.onGamepadConnected],
                ['gamepaddisconnected', GLFW.onGamepadDisconnected]]);
  drop(canvas, [['touchmove', GLFW.onMousemove], ['touchstart', GLFW.onMouseButtonDown],
                ['touchcancel', GLFW.onMouseButtonUp], ['touchend', GLFW.onMouseButtonUp],
                ['mousemove', GLFW.onMousemove], ['mousedown', GLFW.onMouseButtonDown],
                ['mouseup', GLFW.onMouseButtonUp], ['wheel', GLFW.onMouseWheel],
                ['mousewheel', GLFW.onMouseWheel], ['mouseenter', GLFW.onMouseenter],
                ['mouseleave', GLFW.onMouseleave], ['drop', GLFW.onDrop],
                ['dragover', GLFW.onDragover]]);
  if (GLFW.devicePixelRatioMQL) {
    GLFW.devicePixelRatioMQL.removeEventListener('change', GLFW.onDevicePixelRatioChange);
  }
  canvas.style.removeProperty('width');
  canvas.style.removeProperty('height');
});

EM_JS(void, splSetBackingStore, (int width, int height), {
  const canvas = Module['canvas'];
  if (canvas.width !== width) canvas.width = width;
  if (canvas.height !== height) canvas.height = height;
});
// clang-format on

namespace spineloft::platform {
namespace {

constexpr double kMaxDpr = 2;
constexpr double kSoftwarePixels = 1.6e6;  // what a processor draws fast enough
constexpr int kSamples = 4;

bool softwareGl() {
  static const bool software = splSoftwareGl() != 0;
  return software;
}

int backing(double css, double dpr) { return std::max(1, static_cast<int>(std::lround(css * dpr))); }

void appendQuoted(std::string& json, std::string_view text) {
  json += '"';
  for (const char c : text) {
    if (c == '"' || c == '\\') json += '\\';
    if (static_cast<unsigned char>(c) >= 0x20) json += c;
  }
  json += '"';
}

/// A string that JavaScript made for us.
std::string taken(char* text) {
  std::string out = text;
  std::free(text);
  return out;
}

}  // namespace

std::string BrowserWords::translated(std::string_view english, std::string_view args) {
  return taken(splTranslated(std::string(english).c_str(), std::string(args).c_str()));
}

std::string BrowserWords::drawn(std::string_view text) { return taken(splDrawn(std::string(text).c_str())); }

double BrowserHost::nowMs() const { return emscripten_get_now(); }

void BrowserHost::onFrame(void* host) {
  auto* self = static_cast<BrowserHost*>(host);
  self->framePending_ = false;
  if (self->page != nullptr) self->page->frame();
}

void BrowserHost::requestFrame() {
  if (framePending_) return;
  framePending_ = true;
  emscripten_request_animation_frame(
      [](double, void* host) {
        onFrame(host);
        return EM_FALSE;
      },
      this);
}

void BrowserHost::wakeAfter(double milliseconds) {
  emscripten_set_timeout(
      [](void* host) {
        Page* woken = static_cast<BrowserHost*>(host)->page;
        if (woken != nullptr) woken->wake();
      },
      milliseconds, this);
}

void BrowserHost::send(std::string_view json) { splSend(std::string(json).c_str()); }

void BrowserHost::solve(std::string_view json, std::span<const SolverMesh> meshes) {
  // The shell reads five numbers a mesh (web/shell/engine.ts).
  static_assert(sizeof(SolverMesh) == 5 * sizeof(std::uint32_t));
  splSolve(std::string(json).c_str(), meshes.data());
}

void BrowserHost::cutOut(const CutRequest& request) {
  const image::Picture& picture = request.picture;
  // The shell reads four numbers (web/shell/engine_workers.ts).
  const int sizes[] = {picture.working.width, picture.working.height, picture.width, picture.height};
  splCutOut(request.id, request.hints.data(), static_cast<int>(request.hints.size()),
            std::string(request.pictureKey).c_str(), picture.working.pixels.data(), sizes);
}

void BrowserHost::sendFile(std::string_view name, std::string_view mediaType, std::span<const std::uint8_t> bytes) {
  std::string json = R"({"type":"file","name":)";
  appendQuoted(json, name);
  json += R"(,"mediaType":)";
  appendQuoted(json, mediaType);
  json += ",\"ptr\":" + std::to_string(reinterpret_cast<std::uintptr_t>(bytes.data()));
  json += ",\"length\":" + std::to_string(bytes.size()) + "}";
  splSend(json.c_str());
}

bool BrowserHost::drawsSlowly() const { return softwareGl(); }

void BrowserHost::setPixels(const CanvasSize& size) { resizeCanvas(size); }

bool BrowserHost::reducedMotion() const { return splReducedMotion() != 0; }

bool openWindow(const CanvasSize& size) {
  if (!glfwInit()) return false;
  glfwWindowHint(GLFW_CLIENT_API, GLFW_OPENGL_ES_API);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_ALPHA_BITS, 0);
  glfwWindowHint(GLFW_DEPTH_BITS, 24);
  glfwWindowHint(GLFW_STENCIL_BITS, 0);
  glfwWindowHint(GLFW_SAMPLES, softwareGl() ? 0 : kSamples);
  GLFWwindow* window =
      glfwCreateWindow(backing(size.width, size.dpr), backing(size.height, size.dpr), "SpineLoft", nullptr, nullptr);
  splDropGlfwListeners();
  if (window == nullptr) return false;
  glfwMakeContextCurrent(window);
  resizeCanvas(size);
  return true;
}

void resizeCanvas(const CanvasSize& size) {
  static int width = 0, height = 0;
  const int wanted[] = {backing(size.width, size.dpr), backing(size.height, size.dpr)};
  if (wanted[0] == width && wanted[1] == height) return;  // it would be blank
  splSetBackingStore(width = wanted[0], height = wanted[1]);
}

double usableDpr(const CanvasSize& wanted) {
  const double dpr = std::clamp(wanted.dpr, 0.5, kMaxDpr);
  if (dpr <= 1 || !softwareGl()) return dpr;
  const double affordable = std::sqrt(kSoftwarePixels / std::max(1.0, wanted.width * wanted.height));
  return std::clamp(affordable, 1.0, dpr);
}

}  // namespace spineloft::platform
