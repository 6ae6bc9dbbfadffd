// assets/docs/commands.json, from which the page about the API is made, has the rows of the command table. With
// SPINELOFT_WRITE_DOCS=1 the test writes it anew: arguments and remarks, which are written by hand, stay.
#include <doctest/doctest.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/support/test_files.h"
#include "tests/unit/web/rig.h"

using namespace spineloft;
using Rows = nlohmann::ordered_json;

namespace {

/// The rows as the table has them, with what is written by hand in `old`.
Rows rowsOfTable(const Rows& old) {
  Rows rows = Rows::array();
  for (const app::Command& command : app::commandTable()) {
    Rows row{{"id", command.id},     {"label", command.label}, {"group", command.group}, {"shortcut", command.shortcut},
             {"hint", command.hint}, {"arguments", ""}};
    for (const Rows& known : old) {
      if (known["id"] != command.id) continue;
      for (const char* key : {"arguments", "about"})
        if (known.contains(key)) row[key] = known[key];
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace

TEST_CASE("the documents describe every command of the table, and no other") {
  const auto bytes = testing::testFile("../assets/docs/commands.json");
  const std::string text(bytes.begin(), bytes.end());
  const Rows documented = Rows::parse(text);
  const Rows wanted = rowsOfTable(documented);
  if (std::getenv("SPINELOFT_WRITE_DOCS") != nullptr) {
    std::ofstream(testing::testPath("../assets/docs/commands.json")) << wanted.dump(2) << '\n';
  } else {
    CHECK(documented.size() == wanted.size());
    for (std::size_t i = 0; i < std::min(documented.size(), wanted.size()); ++i) CHECK(documented[i] == wanted[i]);
  }
  for (const app::Command& command : app::commandTable()) {
    if (command.argument.key.empty()) continue;
    CAPTURE(command.id);
    for (const Rows& row : wanted) {
      if (row["id"] != command.id) continue;
      CHECK(row["arguments"].get<std::string>().find(command.argument.key) != std::string::npos);
    }
  }
}
