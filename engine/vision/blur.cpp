#include "engine/vision/blur.h"

#include <cmath>
#include <new>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "engine/vision/one_thread.h"

namespace spineloft::vision {

Result<image::Image> blurred(const image::Image& image, double sigma) {
  if (image.empty()) return Error::PictureEmpty;
  if (!(sigma > 0 && sigma <= 1000)) return Error::ValueOutOfRange;
  try {
    useOneThread();
    image::Image out = image;
    const int side = 2 * static_cast<int>(std::ceil(3 * sigma)) + 1;
    cv::Mat pixels(out.height, out.width, CV_8UC4, out.pixels.data());
    cv::GaussianBlur(pixels, pixels, {side, side}, sigma, sigma, cv::BORDER_REPLICATE);
    return out;
  } catch (const cv::Exception& problem) {
    return {Error::OutOfMemory, problem.err};
  } catch (const std::bad_alloc&) {
    return Error::OutOfMemory;
  }
}

}  // namespace spineloft::vision
