#include "engine/base/sorted_window.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

#include "engine/base/rng.h"

using namespace spineloft;

TEST_CASE("a window that moves along a row has the ranks of its values sorted anew, equal ones included") {
  Rng rng(5);
  std::vector<float> memory{7, 3};
  for (int round = 0; round < 20; ++round) {
    std::vector<float> row;
    for (int i = 0; i < 60; ++i) row.push_back(static_cast<float>(rng.below(round % 2 == 0 ? 6 : 100000)) - 2);
    SortedWindow window(memory);
    const std::size_t width = 1 + rng.below(12);
    for (std::size_t i = 0; i < row.size(); ++i) {
      window.add(row[i]);
      if (i >= width) window.remove(row[i - width]);
      const auto last = row.begin() + static_cast<std::ptrdiff_t>(i + 1);
      std::vector<float> sorted(last - static_cast<std::ptrdiff_t>(std::min(width, i + 1)), last);
      std::ranges::sort(sorted);
      REQUIRE(window.size() == sorted.size());
      for (std::size_t rank = 0; rank < sorted.size(); ++rank) REQUIRE(window.at(rank) == sorted[rank]);
    }
  }
}
