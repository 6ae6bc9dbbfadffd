#include "engine/geometry/view.h"

#include <doctest/doctest.h>

#include <limits>

#include "engine/base/rng.h"

using namespace spineloft;
using namespace spineloft::geometry;

TEST_CASE("a place is where its pixel says, in every view") {
  Rng rng(1);
  for (int from = 0; from < static_cast<int>(ViewFrom::kCount); ++from) {
    for (int round = 0; round < 20; ++round) {
      const View view{static_cast<ViewFrom>(from), rng.uniform(-50, 50), rng.uniform(0.3, 3), rng.uniform(-90, 90)};
      const PicturePoint p{rng.uniform(0, 300), rng.uniform(0, 300)};
      const PicturePoint again = inView(view, inModel(view, p));
      CHECK(again.x == doctest::Approx(p.x));
      CHECK(again.y == doctest::Approx(p.y));
    }
  }
}

TEST_CASE("what is nearer to the viewer lies left as seen from the right, right from the left, low from the top") {
  const ModelPoint far{40, -30, 0}, near{40, -30, 10};
  CHECK(inView({ViewFrom::Right}, near).x < inView({ViewFrom::Right}, far).x);
  CHECK(inView({ViewFrom::Left}, near).x > inView({ViewFrom::Left}, far).x);
  CHECK(inView({ViewFrom::Top}, near).y > inView({ViewFrom::Top}, far).y);
  const ModelPoint right{50, -30, 0};
  CHECK(inView({ViewFrom::Back}, right).x < inView({ViewFrom::Back}, far).x);
  CHECK(inView({ViewFrom::Right}, far).y == 30);
  CHECK(inView({ViewFrom::Back}, far).y == 30);
  CHECK(inView({ViewFrom::Top}, far).x == 40);
}

TEST_CASE("numbers of a view are in range") {
  CHECK(isValid(View{}));
  CHECK_FALSE(isValid(View{ViewFrom::kCount, 0, 1, 0}));
  CHECK_FALSE(isValid(View{ViewFrom::Right, 0, 0, 0}));
  CHECK_FALSE(isValid(View{ViewFrom::Right, 1e9, 1, 0}));
  CHECK_FALSE(isValid(View{ViewFrom::Right, 0, 1, std::numeric_limits<double>::quiet_NaN()}));
}
