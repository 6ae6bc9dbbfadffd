// What the page asks of the world outside: time, frames, messages. The browser's is made of
// JavaScript calls, the desktop's of GLFW, the tests' of vectors.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace spineloft::platform {

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
  /// Hands a finished file to the shell, which copies the bytes at once and offers them as
  /// download.
  virtual void sendFile(std::string_view name, std::string_view mediaType, std::span<const std::uint8_t> bytes) = 0;
  /// The visitor asked the system for less motion.
  virtual bool reducedMotion() const = 0;
};

}  // namespace spineloft::platform
