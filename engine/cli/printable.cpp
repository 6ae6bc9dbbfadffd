#include "engine/cli/printable.h"

#include <algorithm>
#include <utility>

namespace spineloft::cli {
namespace {

constexpr unsigned char kFirstOfLatin1 = 0xC2;

void putEscaped(std::ostream& out, unsigned char byte) {
  constexpr char kDigits[] = "0123456789abcdef";
  out << "\\x" << kDigits[byte >> 4] << kDigits[byte & 15];
}

}  // namespace

std::string onOneLine(std::string text) {
  std::ranges::replace_if(text, [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return text;
}

void Printable::Buffer::put(unsigned char byte) {
  if (std::exchange(afterC2_, false)) {
    const bool control = byte >= 0x80 && byte < 0xA0;
    if (!control) out_.put(static_cast<char>(kFirstOfLatin1));
    if (control) return putEscaped(out_, byte);
  }
  if (byte == kFirstOfLatin1) {
    afterC2_ = true;
  } else if ((byte < 0x20 && byte != '\n') || byte == 0x7F) {
    putEscaped(out_, byte);
  } else {
    out_.put(static_cast<char>(byte));
  }
}

Printable::Buffer::int_type Printable::Buffer::overflow(int_type c) {
  if (!traits_type::eq_int_type(c, traits_type::eof())) put(static_cast<unsigned char>(c));
  return traits_type::not_eof(c);
}

int Printable::Buffer::sync() {
  if (std::exchange(afterC2_, false)) putEscaped(out_, kFirstOfLatin1);
  out_.flush();
  return out_ ? 0 : -1;
}

}  // namespace spineloft::cli
