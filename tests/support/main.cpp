// The test program: doctest's own, but that a test case which checked nothing has failed.
#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h>

#include <iostream>

namespace {

int emptyCases = 0;

/// Sees every test case that ran.
struct Watcher : doctest::IReporter {
  explicit Watcher(const doctest::ContextOptions&) {}
  void test_case_start(const doctest::TestCaseData& one) override { current_ = &one; }
  void test_case_end(const doctest::CurrentTestCaseStats& stats) override {
    if (stats.numAssertsCurrentTest > 0) return;
    ++emptyCases;
    std::cout << current_->m_file.c_str() << ':' << current_->m_line << ": the test case \"" << current_->m_name
              << "\" checked nothing\n";
  }
  void report_query(const doctest::QueryData&) override {}
  void test_run_start() override {}
  void test_run_end(const doctest::TestRunStats&) override {}
  void test_case_reenter(const doctest::TestCaseData&) override {}
  void test_case_exception(const doctest::TestCaseException&) override {}
  void subcase_start(const doctest::SubcaseSignature&) override {}
  void subcase_end() override {}
  void log_assert(const doctest::AssertData&) override {}
  void log_message(const doctest::MessageData&) override {}
  void test_case_skipped(const doctest::TestCaseData&) override {}

 private:
  const doctest::TestCaseData* current_ = nullptr;
};

REGISTER_LISTENER("watcher", 1, Watcher);

}  // namespace

int main(int argc, char** argv) {
  doctest::Context context(argc, argv);
  const int failed = context.run();
  return failed != 0 ? failed : (emptyCases > 0 ? 1 : 0);
}
