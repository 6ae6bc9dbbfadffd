// Text for a terminal: names of files and models may hold bytes that would move its cursor or worse.
#pragma once

#include <ostream>
#include <streambuf>
#include <string>

namespace spineloft::cli {

/// The text with spaces for its line breaks.
std::string onOneLine(std::string text);

/// Hands text on to `terminal`, which outlives it, with every control character but the line break (C0, DEL and, in
/// UTF-8, C1) as "\xNN".
class Printable : public std::ostream {
 public:
  explicit Printable(std::ostream& terminal) : std::ostream(nullptr), buffer_(terminal) { rdbuf(&buffer_); }

 private:
  class Buffer : public std::streambuf {
   public:
    explicit Buffer(std::ostream& terminal) : out_(terminal) {}

   protected:
    int_type overflow(int_type c) override;
    int sync() override;

   private:
    void put(unsigned char byte);
    std::ostream& out_;
    bool afterC2_ = false;  ///< the first byte of U+0080 … U+00BF is held back
  };
  Buffer buffer_;
};

}  // namespace spineloft::cli
