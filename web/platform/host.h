// What the page asks of the world outside: time, frames, messages. The browser's is made of
// JavaScript calls, the desktop's of GLFW, the tests' of vectors.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "engine/image/image.h"

namespace spineloft::platform {

struct CanvasSize;

/// A mesh that the solver of solids is given: the engine's own arrays, which the shell copies at once.
struct SolverMesh {
  std::uint32_t vertices = 0, triangles = 0;
  const float* positions = nullptr;        ///< three a vertex
  const float* uv = nullptr;               ///< two a vertex; null: it has none
  const std::uint32_t* corners = nullptr;  ///< three a triangle
};

/// What is to be cut out of which picture: the engine's own, which the shell copies at once.
struct CutRequest {
  std::uint32_t id = 0;           ///< not 0
  std::span<const double> hints;  ///< vision::numbersOf
  std::string_view pictureKey;    ///< equal keys, equal pictures
  const image::Picture& picture;
};

class Host {
 public:
  virtual ~Host() = default;

  /// Milliseconds from any start; never goes back.
  virtual double nowMs() const = 0;
  /// Asks for one call of Page::frame soon; more asks before it still give one.
  virtual void requestFrame() = 0;
  /// Asks for one call of Page::wake after that many milliseconds, even in a hidden tab.
  virtual void wakeAfter(double milliseconds) = 0;
  /// Hands one event of the contract to the shell, as JSON.
  virtual void send(std::string_view json) = 0;
  /// Asks the solver of solids: {type: 'solve', id, meshes, nodes, wanted} with the meshes behind the keys in its list.
  virtual void solve(std::string_view json, std::span<const SolverMesh> meshes) = 0;
  /// Asks for a cut-out in place of the one that was asked for before; Page::cutOutAnswered answers, never from within.
  virtual void cutOut(const CutRequest& request) = 0;
  /// Hands a finished file to the shell, which copies the bytes at once and offers them as
  /// download.
  virtual void sendFile(std::string_view name, std::string_view mediaType, std::span<const std::uint8_t> bytes) = 0;
  /// A processor draws: pixels take time.
  virtual bool drawsSlowly() const = 0;
  /// The canvas has so many pixels from now on; it is blank where it had others.
  virtual void setPixels(const CanvasSize& size) = 0;
  /// The visitor asked the system for less motion.
  virtual bool reducedMotion() const = 0;
};

}  // namespace spineloft::platform
