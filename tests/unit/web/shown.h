// The controls that a visitor sees, as the page tells them in its state.
#pragma once

#include <string>
#include <vector>

#include "tests/unit/web/rig.h"

namespace spineloft::test {

struct Shown {
  std::string kind, words;
  app::Rect at;
};

inline std::vector<Shown> inSight(Rig& rig) {
  std::vector<Shown> out;
  const app::Json state = rig.state();
  for (const app::Json& one : *state.find("controls")->array()) {
    if (!*one.flag("inSight")) continue;
    const app::Json::Array& at = *one.find("at")->array();
    out.push_back(
        {*one.text("kind"), *one.text("words"), {*at[0].number(), *at[1].number(), *at[2].number(), *at[3].number()}});
  }
  return out;
}

}  // namespace spineloft::test
