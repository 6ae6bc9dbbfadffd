#include "tests/bench/report.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <iostream>
#include <vector>

#ifdef __EMSCRIPTEN__
#include <emscripten.h>
#endif

namespace spineloft::bench {
namespace {

double nowMs() {
  using Ms = std::chrono::duration<double, std::milli>;
  return Ms(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// What the process took of the processor: on a machine that others use, too, the steadier number.
double processorMs() {
#ifdef __EMSCRIPTEN__
  return EM_ASM_DOUBLE({
    const used = process.cpuUsage();
    return (used.user + used.system) / 1000;
  });
#else
  return 1000.0 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
#endif
}

}  // namespace

Report::Report() { std::cout << "{\n"; }
Report::~Report() { std::cout << "\n}\n"; }

void Report::begin(const std::string& name) {
  std::cout << (first_ ? "" : ",\n") << "  \"" << name << "\": ";
  first_ = false;
}

double Report::stage(const std::string& name, int runs, const std::function<void(int)>& work) {
  std::vector<double> times, ofProcessor;
  for (int i = -2; i < runs; ++i) {
    const double started = nowMs(), used = processorMs();
    work(std::max(0, i));
    if (i < 0) continue;
    times.push_back(nowMs() - started);
    ofProcessor.push_back(processorMs() - used);
  }
  std::ranges::sort(times);
  std::ranges::sort(ofProcessor);
  const auto at = [](const std::vector<double>& sorted, double share) {
    return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1) + 0.5)];
  };
  begin(name);
  std::cout << "{\"median_ms\": " << at(times, 0.5) << ", \"p95_ms\": " << at(times, 0.95)
            << ", \"p99_ms\": " << at(times, 0.99) << ", \"min_ms\": " << times.front()
            << ", \"cpu_ms\": " << at(ofProcessor, 0.5) << ", \"cpu_p99_ms\": " << at(ofProcessor, 0.99)
            << ", \"runs\": " << runs << "}" << std::flush;
  return at(times, 0.5);
}

void Report::value(const std::string& name, double number) {
  begin(name);
  std::cout << "{\"value\": " << number << "}" << std::flush;
}

}  // namespace spineloft::bench
