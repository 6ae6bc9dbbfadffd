// What the shell asks for to keep models on the device (web/shell/keep): the history as text, photos by
// their content hash, and a history that takes the place of the one there is.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "engine/base/result.h"
#include "engine/image/image.h"
#include "web/model/studio.h"

namespace spineloft::app {

class Keeping {
 public:
  explicit Keeping(Studio& studio) : studio_(studio) {}

  /// The whole history, as a base of the journal.
  std::string history() const;
  /// Content hashes of all photos of the history, each once: 16 hexadecimal digits.
  std::vector<std::string> photos() const;
  /// A photo of the history; null when no step shows it.
  std::shared_ptr<const image::Picture> photo(std::string_view hash) const;

  /// Lays a photo by for the next `restore` or `openProject`; its content hash.
  std::string layBy(image::Picture photo);
  /// Replaces the history by what `base` and `records` say and photos laid by show; an empty base is a
  /// new, empty model. What was laid by is given back in any case. The number of records at the end
  /// that were damaged and are left out. Errors: those of io::readHistory; then nothing has changed.
  Result<std::size_t> restore(std::string_view base, std::span<const std::string> records);
  /// Replaces the history by one that begins with the document of a project file; the sentence says what
  /// had to be mended and is empty when nothing had. A link may stand for the file; pictures of it show photos laid by
  /// whose hashes `photos` names. What was laid by is given back in any case. Errors: those of io::readProject and
  /// io::readShareText; then nothing has changed.
  Result<std::string> openProject(std::span<const std::uint8_t> file, const std::map<PictureId, std::string>& photos);

 private:
  Studio& studio_;
  std::unordered_map<std::uint64_t, std::shared_ptr<const image::Picture>> laidBy_;
};

}  // namespace spineloft::app
