// What every use of OpenCV begins with. Internal to vision/.
#pragma once

#include <opencv2/core.hpp>

namespace spineloft::vision {

/// OpenCV's own worker threads stay off: work is spread over pictures, not inside one, and the
/// result of a run must not depend on the number of processors.
inline void useOneThread() {
  static const bool kDone = [] {
    cv::setNumThreads(0);
    return true;
  }();
  static_cast<void>(kDone);
}

}  // namespace spineloft::vision
