// spineloft: a picture and one stroke become a solid part, on the command line.
#include <iostream>
#include <string_view>
#include <vector>

#include "engine/cli/program.h"

int main(int count, char** words) {
  const std::vector<std::string_view> arguments(words + (count > 0 ? 1 : 0), words + count);
  return spineloft::cli::run(arguments, {std::cout, std::cerr});
}
