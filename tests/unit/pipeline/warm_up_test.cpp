#include "engine/pipeline/warm_up.h"

#include <doctest/doctest.h>

using namespace spineloft;

TEST_CASE("warming up runs every stage without failing, however often") {
  CHECK(pipeline::warmUp(1).ok());
  CHECK(pipeline::warmUp(3).ok());
  CHECK(pipeline::warmUp(-1).ok());
}
