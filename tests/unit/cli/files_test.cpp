#include "engine/cli/files.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include <unistd.h>

using namespace spineloft;
using namespace spineloft::cli;

namespace {

namespace fs = std::filesystem;

/// A folder that is gone after the test.
class Folder {
 public:
  Folder() {
    static int count = 0;
    path_ = fs::temp_directory_path() / ("spineloft-files-" + std::to_string(getpid()) + "-" + std::to_string(count++));
    fs::create_directories(path_);
  }
  ~Folder() { fs::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::string operator()(const std::string& name) const { return (path_ / name).string(); }
  int count() const {
    int found = 0;
    for (const auto& entry : fs::directory_iterator(path_)) found += entry.path().empty() ? 0 : 1;
    return found;
  }

 private:
  fs::path path_;
};

Bytes bytes(const std::string& text) { return Bytes(text.begin(), text.end()); }
std::string textOf(const std::string& path) {
  const auto text = readText(path);
  REQUIRE(text.ok());
  return text.value();
}

}  // namespace

TEST_CASE("what is written reads back, and an empty file is told apart from one that cannot be read") {
  const Folder folder;
  Bytes large(300000);
  for (std::size_t i = 0; i < large.size(); ++i) large[i] = static_cast<std::uint8_t>(i * 7);
  REQUIRE(writeAll({{folder("empty"), {}}, {folder("large"), large}}).ok());
  CHECK(readFile(folder("large")).value() == large);
  CHECK(fs::file_size(folder("empty")) == 0);
  CHECK(readFile(folder("empty")).failure().detail == folder("empty") + " is empty");
  CHECK(readText(folder("empty")).failure().detail == folder("empty") + " is empty");
  CHECK(readFile(folder("none")).failure().detail == folder("none"));
  CHECK(folder.count() == 2);
  REQUIRE(writeAll({}).ok());
}

TEST_CASE("a file that is there is replaced, also through a second name") {
  const Folder folder;
  REQUIRE(writeAll({{folder("a"), bytes("old")}}).ok());
  REQUIRE(writeAll({{folder("a"), bytes("new")}, {folder("b"), bytes("more")}}).ok());
  CHECK(textOf(folder("a")) == "new");
  CHECK(textOf(folder("b")) == "more");
  CHECK(folder.count() == 2);
}

TEST_CASE("when any file cannot be placed all are as before") {
  const Folder folder;
  fs::create_directories(folder("taken/inside"));
  REQUIRE(writeAll({{folder("a"), bytes("old")}}).ok());
  for (const std::string& bad : {folder("taken"), folder("missing/x"), folder("a/x")}) {
    for (const bool last : {true, false}) {
      std::vector<OutputFile> files{{folder("a"), bytes("new")}, {folder("fresh"), bytes("new")}};
      files.insert(last ? files.end() : files.begin(), {bad, bytes("new")});
      const Status status = writeAll(files);
      REQUIRE_FALSE(status.ok());
      CHECK(status.error() == Error::FileUnwritable);
      CHECK(status.failure().detail == bad);
      CHECK(textOf(folder("a")) == "old");
      CHECK(folder.count() == 2);
    }
  }
}

TEST_CASE("what cannot be read is named") {
  const Folder folder;
  for (const std::string& path : {folder("missing"), folder(""), std::string()}) {
    const auto file = readFile(path);
    REQUIRE_FALSE(file.ok());
    CHECK(file.error() == Error::FileUnreadable);
  }
}

TEST_CASE("two paths to one place are known as such") {
  const Folder folder;
  CHECK(samePlace(folder("x"), folder("./y/../x")));
  CHECK_FALSE(samePlace(folder("x"), folder("y")));
  REQUIRE(writeAll({{folder("real"), bytes("1")}}).ok());
  fs::create_symlink(folder("real"), folder("link"));
  CHECK(samePlace(folder("real"), folder("link")));
}
