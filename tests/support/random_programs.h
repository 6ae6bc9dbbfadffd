// Random convex quadratic programs that have a solution.
#pragma once

#include <Eigen/Dense>
#include <cstdint>

#include "engine/geometry/qp.h"

namespace spineloft::testing {

/// A program with a solution: its rows hold at a random point. Some rows touch that point, so that many bind together;
/// a few are multiples of the row before.
struct RandomProgram {
  geometry::Qp qp;
  Eigen::MatrixXd energy;  ///< as in qp, whole
  Eigen::VectorXd linear;
};
RandomProgram randomProgram(std::uint64_t seed);

}  // namespace spineloft::testing
