// The search for cut-outs as a WebAssembly program of its own: a worker of the page (web/shell/cut_out) loads it when
// it is needed, so that the engine comes without OpenCV.
#include "engine/vision/cut_out.h"

#include <cstdint>
#include <new>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "engine/image/image.h"
#include "engine/vision/cut_out_numbers.h"

namespace {

using namespace spineloft;

/// The one search of this module: exported C functions have no other place for it.
struct Door {
  image::Picture picture;
  std::optional<Result<vision::CutOutSearch>> search;
  std::vector<double> answer;
};
Door& door() {
  static Door instance;
  return instance;
}

vision::CutOutSearch* running() {
  auto& search = door().search;
  return search && *search ? &search->value() : nullptr;
}

}  // namespace

extern "C" {

/// Room for the RGBA pixels of the picture that is searched from now on; null where there is no memory for it.
std::uint8_t* spl_picture(int width, int height, int originalWidth, int originalHeight) {
  image::Picture& picture = door().picture;
  door().search.reset();
  picture = {};
  try {
    picture.working.pixels.resize(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
  picture.working.width = width;
  picture.working.height = height;
  picture.width = originalWidth;
  picture.height = originalHeight;
  return picture.working.pixels.data();
}

/// Begins anew, with hints as vision::numbersOf writes them.
void spl_begin(const double* numbers, std::uint32_t count) {
  const std::optional<vision::CutHints> hints = vision::hintsFrom({numbers, count});
  door().search.reset();
  door().search.emplace(hints ? vision::CutOutSearch::begin(door().picture, *hints)
                              : Result<vision::CutOutSearch>(Error::ValueOutOfRange, "hint"));
}

/// One round; 0 when it was the last one, or there is none left.
int spl_step() { return running() != nullptr && running()->step() ? 1 : 0; }

/// 0…1 of the rounds.
double spl_done() { return running() != nullptr ? running()->done() : 1; }

/// How many numbers follow, and those that vision::numbersOf writes of what was found. Valid until the next call.
const double* spl_found() {
  const auto& search = door().search;
  const Result<vision::CutContours> found = running() != nullptr
                                                ? running()->outlines()
                                                : Result<vision::CutContours>(search ? search->failure() : Failure{});
  door().answer = vision::numbersOf(found);
  door().answer.insert(door().answer.begin(), static_cast<double>(door().answer.size()));
  return door().answer.data();
}

}  // extern "C"
