#include "engine/cli/files.h"

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <new>
#include <system_error>

#include <unistd.h>

namespace spineloft::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kLargestFile = std::uintmax_t{1} << 30;

/// A name beside `path` that nobody else uses: hidden, and marked with this process.
fs::path besideOf(const std::string& path, const char* what) {
  const fs::path final(path);
  std::string name = ".";
  name += final.filename().string();
  name += '.';
  name += std::to_string(static_cast<long>(getpid()));
  name += '.';
  name += what;
  return final.parent_path() / name;
}

bool writeBytes(const fs::path& path, const Bytes& bytes) {
  const auto close = [](std::FILE* file) { std::fclose(file); };
  // "x": never write into something that is already there.
  std::unique_ptr<std::FILE, decltype(close)> file(std::fopen(path.c_str(), "wbx"), close);
  if (!file) return false;
  const bool whole = std::fwrite(bytes.data(), 1, bytes.size(), file.get()) == bytes.size();
  const bool kept = std::fflush(file.get()) == 0 && ::fsync(fileno(file.get())) == 0;
  return std::fclose(file.release()) == 0 && whole && kept;
}

/// Keeps the signals that people and systems end programs with waiting while files are half written.
class HeldSignals {
 public:
  HeldSignals() {
    sigset_t held;
    sigemptyset(&held);
    for (const int signal : kEnding) sigaddset(&held, signal);
    pthread_sigmask(SIG_BLOCK, &held, &before_);
  }
  HeldSignals(const HeldSignals&) = delete;
  HeldSignals& operator=(const HeldSignals&) = delete;
  /// What came meanwhile takes effect.
  ~HeldSignals() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  /// Whether one has come.
  bool any() const {
    sigset_t waiting;
    sigpending(&waiting);
    return std::ranges::any_of(kEnding, [&](int signal) { return sigismember(&waiting, signal) == 1; });
  }

 private:
  static constexpr std::array<int, 3> kEnding = {SIGINT, SIGTERM, SIGHUP};
  sigset_t before_{};
};

/// One output on its way to its name.
struct Pending {
  fs::path final, fresh, old;
  bool written = false, hadOld = false, placed = false;
};

void undo(std::vector<Pending>& pending) {
  std::error_code ignored;
  for (Pending& file : pending) {
    if (file.placed) fs::remove(file.final, ignored);
    if (file.hadOld) fs::rename(file.old, file.final, ignored);
    if (file.written) fs::remove(file.fresh, ignored);
  }
}

/// Sets the old file aside and gives the fresh one its name.
bool place(Pending& file) {
  std::error_code problem;
  if (fs::is_directory(file.final, problem)) return false;
  if (fs::exists(fs::symlink_status(file.final, problem))) {
    fs::rename(file.final, file.old, problem);
    if (problem) return false;
    file.hadOld = true;
  }
  fs::rename(file.fresh, file.final, problem);
  file.placed = !problem;
  return file.placed;
}

fs::path resolved(const std::string& path) {
  std::error_code problem;
  const fs::path whole = fs::weakly_canonical(fs::absolute(path, problem), problem);
  return problem ? fs::path(path).lexically_normal() : whole;
}

}  // namespace

Result<Bytes> readFile(const std::string& path) {
  std::error_code problem;
  const fs::file_status status = fs::status(path, problem);
  if (problem || !fs::exists(status) || fs::is_directory(status)) return {Error::FileUnreadable, path};
  std::ifstream file(path, std::ios::binary);
  if (!file) return {Error::FileUnreadable, path};
  try {
    Bytes bytes;
    std::vector<char> block(1 << 16);
    while (file.read(block.data(), static_cast<std::streamsize>(block.size())), file.gcount() > 0) {
      bytes.insert(bytes.end(), block.begin(), block.begin() + file.gcount());
      if (bytes.size() > kLargestFile) return {Error::FileUnreadable, path + " is too large"};
    }
    if (file.bad()) return {Error::FileUnreadable, path};
    if (bytes.empty()) return {Error::FileUnreadable, path + " is empty"};
    return bytes;
  } catch (const std::bad_alloc&) {
    return {Error::OutOfMemory, path};
  }
}

Result<std::string> readText(const std::string& path) {
  Result<Bytes> bytes = readFile(path);
  if (!bytes.ok()) return bytes.failure();
  return std::string(bytes.value().begin(), bytes.value().end());
}

Status writeAll(const std::vector<OutputFile>& files) {
  const HeldSignals signals;
  std::vector<Pending> pending;
  for (const OutputFile& file : files) {
    pending.push_back({file.path, besideOf(file.path, "new"), besideOf(file.path, "old")});
  }
  const auto fail = [&](std::size_t i) -> Status {
    undo(pending);
    return {Error::FileUnwritable, files[i].path};
  };
  for (std::size_t i = 0; i < files.size(); ++i) {
    std::error_code problem;
    if (fs::is_directory(pending[i].final, problem)) return fail(i);
    pending[i].written = true;
    if (!writeBytes(pending[i].fresh, files[i].bytes) || signals.any()) return fail(i);
  }
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (!place(pending[i])) return fail(i);
  }
  std::error_code ignored;
  for (const Pending& file : pending) {
    if (file.hadOld) fs::remove(file.old, ignored);
  }
  return Done{};
}

bool samePlace(const std::string& a, const std::string& b) { return resolved(a) == resolved(b); }

}  // namespace spineloft::cli
