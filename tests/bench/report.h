// What a benchmark writes: one JSON object, stage by stage.
#pragma once

#include <functional>
#include <string>

namespace spineloft::bench {

/// Writes to standard output while it lives.
class Report {
 public:
  Report();
  ~Report();
  Report(const Report&) = delete;
  Report& operator=(const Report&) = delete;
  /// Least, median, 95th and 99th percentile of the times of `work(i)`, i = 0 … runs − 1, after two
  /// warm-up runs; and median and 99th percentile of what it takes of the processor, in all threads. Returns the
  /// median.
  double stage(const std::string& name, int runs, const std::function<void(int)>& work);
  /// Any other number.
  void value(const std::string& name, double number);

 private:
  void begin(const std::string& name);
  bool first_ = true;
};

}  // namespace spineloft::bench
