#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <set>
#include <string>

#include "engine/base/hash.h"
#include "engine/base/lanes.h"
#include "engine/base/progress.h"
#include "engine/base/result.h"
#include "engine/base/rng.h"
#include "engine/base/vec.h"

using namespace spineloft;

TEST_CASE("every error has its own name and a sentence that ends") {
  std::set<std::string> names, sentences;
  for (int i = 0; i < static_cast<int>(Error::kCount); ++i) {
    const Error error = static_cast<Error>(i);
    const std::string sentence(errorSentence(error));
    CHECK(names.insert(std::string(errorName(error))).second);
    CHECK(sentences.insert(sentence).second);
    REQUIRE_FALSE(sentence.empty());
    CHECK(sentence.back() == '.');
  }
}

TEST_CASE("a result is a value or a failure, and a failure keeps its detail") {
  const Result<int> good = 7;
  const Result<int> bad{Error::FileUnreadable, "cat.png"};
  CHECK(good.ok());
  CHECK(good.value() == 7);
  CHECK_FALSE(bad.ok());
  CHECK(bad.error() == Error::FileUnreadable);
  CHECK(failureSentence(bad.failure()).find("cat.png") != std::string::npos);
}

TEST_CASE("equal input hashes alike, and order, length and type matter") {
  const auto of = [](auto... numbers) {
    Hasher hasher;
    (hasher.number(numbers), ...);
    return hasher.value();
  };
  CHECK(of(1, 2) == of(1, 2));
  CHECK(of(1, 2) != of(2, 1));
  CHECK(of(1) != of(1, 0));
  CHECK(of(0.0) == of(-0.0));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(of(nan) == of(-nan));
  CHECK(Hasher().text("ab").text("c").value() != Hasher().text("a").text("bc").value());
}

TEST_CASE("a hundred thousand different inputs hash differently") {
  std::set<std::uint64_t> seen;
  for (int i = 0; i < 100000; ++i) seen.insert(Hasher().number(i).value());
  CHECK(seen.size() == 100000);
}

TEST_CASE("progress never goes back and cancel is seen by every copy") {
  const Progress watcher;
  const Progress worker = watcher;
  CHECK(worker.advance(0.5));
  CHECK(worker.advance(0.2));
  CHECK(watcher.done() == 0.5);
  watcher.cancel();
  CHECK_FALSE(worker.advance(0.9));
}

TEST_CASE("the generator repeats its numbers and fills its range") {
  Rng a(5), b(5);
  double low = 1, high = 0;
  for (int i = 0; i < 10000; ++i) {
    const double u = a.uniform();
    REQUIRE(u == b.uniform());
    low = std::min(low, u);
    high = std::max(high, u);
  }
  CHECK(low >= 0);
  CHECK(low < 0.01);
  CHECK(high < 1);
  CHECK(high > 0.99);
}

TEST_CASE(
    "the quick arctangent is the exact one within a relative 2e-7, from next to nothing to next to a right angle") {
  for (double q = 1e-6; q < 1e6; q *= 1.01) {
    CAPTURE(q);
    CHECK(std::abs(quickArctan(q) / std::atan(q) - 1) < 2e-7);
    if (q > 1) continue;
    const auto z = static_cast<float>(q);
    CHECK(std::abs(static_cast<double>(z * arctanOverArgument(all4(z * z))[0]) / std::atan(q) - 1) < 5e-7);
  }
}
