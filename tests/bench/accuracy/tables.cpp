#include "tests/bench/accuracy/tables.h"

#include <iomanip>
#include <sstream>

namespace spineloft::accuracy {

std::string markdownOf(const io::NamedLines& lines) {
  std::ostringstream out;
  out << "| |";
  for (const auto& [name, value] : lines.front().second) out << ' ' << name << " |";
  out << "\n|:--|";
  for (std::size_t i = 0; i < lines.front().second.size(); ++i) out << "--:|";
  for (const auto& [title, numbers] : lines) {
    out << "\n| " << title << " |" << std::fixed;
    for (const auto& [name, value] : numbers) {
      out << ' ' << std::setprecision(name.back() == '%' ? 1 : 3) << value << " |";
    }
  }
  out << '\n';
  return out.str();
}

}  // namespace spineloft::accuracy
