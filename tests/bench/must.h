// A benchmark ends where what it measures fails.
#pragma once

#include <cstdlib>
#include <iostream>
#include <utility>

#include "engine/base/result.h"

namespace spineloft::bench {

template <class T>
T must(Result<T> result) {
  if (!result.ok()) {
    std::cerr << "spineloft_bench: " << failureSentence(result.failure()) << '\n';
    std::exit(1);
  }
  return std::move(result).value();
}

}  // namespace spineloft::bench
