#include "tests/bench/report.h"

#include <algorithm>
#include <chrono>
#include <iostream>
#include <vector>

namespace spineloft::bench {
namespace {

double nowMs() {
  using Ms = std::chrono::duration<double, std::milli>;
  return Ms(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

Report::Report() { std::cout << "{\n"; }
Report::~Report() { std::cout << "\n}\n"; }

void Report::begin(const std::string& name) {
  std::cout << (first_ ? "" : ",\n") << "  \"" << name << "\": ";
  first_ = false;
}

void Report::stage(const std::string& name, int runs, const std::function<void(int)>& work) {
  std::vector<double> times;
  for (int i = -2; i < runs; ++i) {
    const double started = nowMs();
    work(std::max(0, i));
    if (i >= 0) times.push_back(nowMs() - started);
  }
  std::sort(times.begin(), times.end());
  const auto at = [&](double share) {
    return times[static_cast<std::size_t>(share * static_cast<double>(times.size() - 1) + 0.5)];
  };
  begin(name);
  std::cout << "{\"median_ms\": " << at(0.5) << ", \"p95_ms\": " << at(0.95)
            << ", \"p99_ms\": " << at(0.99) << ", \"min_ms\": " << times.front()
            << ", \"runs\": " << runs << "}" << std::flush;
}

void Report::value(const std::string& name, double number) {
  begin(name);
  std::cout << "{\"value\": " << number << "}" << std::flush;
}

}  // namespace spineloft::bench
