#include "engine/descriptive/model.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "engine/descriptive/contacts.h"
#include "engine/descriptive/dashes.h"
#include "engine/descriptive/right_angles.h"
#include "engine/descriptive/solids.h"
#include "engine/descriptive/square.h"
#include "engine/descriptive/wireframe.h"
#include "engine/geometry/region.h"

namespace spineloft::descriptive {
namespace {

/// Places at which two pieces with a common run are tied.
constexpr int kTiesOfRun = 12;
/// So far from an outline as drawn is its rim, a share of the size.
constexpr double kOffRim = 0.01;
/// Pieces that overlap so few cells away do not lie side by side.
constexpr int kApartCells = 3;

bool isSound(const Drawing& drawing, std::size_t pieces) {
  const auto isPlace = [&](const Place& place) {
    return place.line < drawing.lines.size() && place.share >= 0 && place.share <= 1;
  };
  for (const Piece& piece : drawing.pieces) {
    const bool inRange = piece.stiffness >= kLeastStiffness && piece.stiffness <= kMostStiffness &&
                         piece.front >= kLeastFront && piece.front <= kMostFront && piece.back >= kLeastFront &&
                         piece.back <= kMostFront && piece.thickness >= 0 && std::isfinite(piece.thickness) &&
                         piece.kind < PieceKind::kCount;
    if (!inRange) return false;
  }
  for (const Pin& pin : drawing.pins) {
    if (!isPlace(pin.at) || !std::isfinite(pin.z)) return false;
  }
  for (const GivenOrder& one : drawing.orders) {
    if (one.over >= pieces || one.under >= pieces || one.over == one.under || !isFinite(one.at)) return false;
  }
  return drawing.seenFrom < SeenFrom::kCount && std::ranges::all_of(drawing.folds, isPlace) && drawing.size.width > 0 &&
         drawing.size.height > 0;
}

bool holdsPlace(const Piece& piece, const Place& place) {
  for (const Outline& outline : piece.outlines) {
    for (const Run& run : outline) {
      if (run.line != place.line) continue;
      if (place.share >= std::min(run.from, run.to) && place.share <= std::max(run.from, run.to)) return true;
    }
  }
  return false;
}

/// Makes a model, step by step.
class Maker {
 public:
  Maker(const Drawing& drawing, const ModelOptions& options) : drawing_(drawing), options_(options) {}

  Result<Model> make() {
    model_.size = sizeOf(drawing_.lines);
    // Lines that something names stay as they are.
    const bool isBare = drawing_.pieces.empty() && drawing_.pins.empty() && drawing_.folds.empty();
    std::vector<Line> drawn = isBare ? withoutDashes(drawing_.lines) : drawing_.lines;
    if (Status measured = measure(drawn); !measured) return measured.failure();
    if (drawing_.pieces.empty()) {
      const std::vector<Line> missing = missingEdges(drawn, lines_, model_.nodes);
      drawn.insert(drawn.end(), missing.begin(), missing.end());
      if (Status measured = missing.empty() ? Status(Done{}) : measure(drawn); !measured) return measured.failure();
    }
    if (Status status = choosePieces(); !status) return status.failure();
    findOpenLines();
    makePatches();
    if (patches_.empty()) return model_.lost.empty() ? Failure{Error::RegionEmpty, {}} : model_.lost[0].failure;
    std::vector<GivenOrder> given;
    for (GivenOrder one : drawing_.orders) {
      const auto over = std::ranges::find(made_, one.over), under = std::ranges::find(made_, one.under);
      if (over == made_.end() || under == made_.end()) continue;
      one.over = static_cast<std::uint32_t>(over - made_.begin());
      one.under = static_cast<std::uint32_t>(under - made_.begin());
      given.push_back(one);
    }
    model_.orders = ordersOf(sheets_, given, model_.size);
    tie();
    square();
    pin();
    const DepthInput input{sheets_, pieces_, patches_, model_.orders, ties_, pins_, scale_};
    Result<Depths> depths = solveDepths(input);
    if (!depths) return depths.failure();
    joinContacts(input, depths.value());
    if (model_.up) levelUp(depths.value());
    finish(depths.value());
    return std::move(model_);
  }

 private:
  Status measure(std::span<const Line> drawn) {
    Result<std::vector<MeasuredLine>> lines = meetingLines(drawn);
    if (!lines) return lines.failure();
    lines_ = std::move(lines).value();
    model_.nodes = nodesOf(lines_, model_.size);
    return Done{};
  }
  Status choosePieces() {
    model_.pieces = drawing_.pieces;
    if (model_.pieces.empty()) {
      model_.pieces = proposePieces(lines_, model_.nodes, model_.size);
    }
    if (model_.pieces.size() > kMostPieces || !isSound(drawing_, model_.pieces.size())) return Error::ValueOutOfRange;
    for (std::size_t i = 0; i < model_.pieces.size(); ++i) {
      if (model_.pieces[i].name.empty()) model_.pieces[i].name = "Piece " + std::to_string(i + 1);
    }
    if (model_.pieces.empty()) return Error::RegionEmpty;
    return Done{};
  }
  void findOpenLines() {
    for (std::uint32_t i = 0; i < lines_.size(); ++i) {
      const bool used = std::ranges::any_of(model_.pieces, [&](const Piece& piece) {
        return std::ranges::any_of(piece.outlines, [&](const Outline& outline) {
          return std::ranges::any_of(outline, [&](const Run& run) { return run.line == i; });
        });
      });
      if (!used) model_.openLines.push_back(i);
    }
  }
  void makePatches() {
    PicturePoint low{INFINITY, INFINITY}, high{-INFINITY, -INFINITY};
    for (const MeasuredLine& line : lines_) {
      for (const PicturePoint p : line.points) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
      }
    }
    scale_ = {(low + high) / 2, model_.size};
    for (std::uint32_t i = 0; i < model_.pieces.size(); ++i) {
      Result<Sheet> sheet = sheetOf(lines_, model_.pieces[i], model_.size, drawing_.size);
      if (!sheet) {
        model_.lost.push_back({i, sheet.failure()});
        continue;
      }
      Patch::Kept kept;
      for (const Place& fold : drawing_.folds) {
        if (holdsPlace(model_.pieces[i], fold)) kept.folds.push_back(lines_[fold.line].at(fold.share));
      }
      for (const Pin& pin : drawing_.pins) {
        if (holdsPlace(model_.pieces[i], pin.at)) kept.others.push_back(lines_[pin.at.line].at(pin.at.share));
      }
      Result<Patch> patch = patchOf(sheet.value(), model_.pieces[i], kept);
      if (!patch) {
        model_.lost.push_back({i, patch.failure()});
        continue;
      }
      made_.push_back(i);
      pieces_.push_back(model_.pieces[i]);
      sheets_.push_back(std::move(sheet).value());
      patches_.push_back(std::move(patch).value());
    }
  }
  Result<Patch> patchOf(const Sheet& sheet, const Piece& piece, const Patch::Kept& kept) const {
    if (piece.kind != PieceKind::Solid) return Patch::make(sheet, piece, kept, scale_, options_.points);
    const Result<Wireframe> wireframe = wireframeOf(lines_, piece.outlines, model_.size);
    if (!wireframe) return wireframe.failure();
    const Result<FacedSolid> faced = squared(wireframe.value(), scale_);
    if (!faced) return faced.failure();
    return Patch::make(faced.value(), scale_);
  }
  /// The place of a piece's rim that is nearest to p.
  PiecePlace rimAt(std::uint32_t piece, PicturePoint p) const { return {piece, patches_[piece].onRim({p.x, -p.y})}; }
  /// Runs of one line that two pieces share, and touches.
  void tie() {
    for (std::uint32_t a = 0; a < pieces_.size(); ++a) {
      for (std::uint32_t b = a + 1; b < pieces_.size(); ++b) {
        forRuns(pieces_[a], [&](const Run& one) {
          forRuns(pieces_[b], [&](const Run& other) {
            if (one.line == other.line) tieRun(a, b, one, other);
          });
        });
      }
    }
    for (const Node& node : model_.nodes) {
      if (node.kind != NodeKind::Touch) continue;
      for (std::uint32_t a = 0; a < pieces_.size(); ++a) {
        for (std::uint32_t b = 0; b < pieces_.size(); ++b) {
          if (a == b || !holdsPlace(pieces_[a], node.places[0]) || !holdsPlace(pieces_[b], node.places[1])) continue;
          if (model_.orders.overlaps.at(a, b, node.at, kApartCells)) continue;  // they touch from inside
          ties_.push_back({rimAt(a, node.at), rimAt(b, node.at), kTouchWeight});
        }
      }
    }
  }
  template <class Do>
  static void forRuns(const Piece& piece, const Do& each) {
    for (const Outline& outline : piece.outlines) {
      for (const Run& run : outline) each(run);
    }
  }
  void tieRun(std::uint32_t a, std::uint32_t b, const Run& one, const Run& other) {
    const double from = std::max(std::min(one.from, one.to), std::min(other.from, other.to));
    const double to = std::min(std::max(one.from, one.to), std::max(other.from, other.to));
    if (!(to > from)) return;
    for (int i = 0; i < kTiesOfRun; ++i) {
      const PicturePoint p = lines_[one.line].at(from + (to - from) * i / (kTiesOfRun - 1));
      ties_.push_back({rimAt(a, p), rimAt(b, p), 1.0 / kTiesOfRun});
    }
  }
  /// What goes along one of three axes at right angles is as deep as they say.
  void square() {
    const RightAngles angles = rightAnglesOf(sheets_, pieces_, model_.size, drawing_.seenFrom);
    model_.up = angles.up;
    for (const Rise& one : angles.rises) {
      const PiecePlace from = rimAt(one.piece, one.from), to = rimAt(one.piece, one.to);
      // What the board cuts off is at no rim.
      if (isThere(from, one.from) && isThere(to, one.to)) {
        ties_.push_back({to, from, kAxisTie, one.nearer / model_.size});
      }
    }
  }
  bool isThere(const PiecePlace& place, PicturePoint p) const {
    const SectionPoint at = place.at.of(patches_[place.piece].mesh().points());
    return distance(at, {p.x, -p.y}) <= kOffRim * model_.size;
  }
  /// A later pin at the same place wins.
  void pin() {
    for (const Pin& pin : drawing_.pins) {
      for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
        if (!holdsPlace(pieces_[i], pin.at)) continue;
        const PicturePoint p = lines_[pin.at.line].at(pin.at.share);
        // What has plane faces is moved as a whole: its edges, also those inside, are as deep as they are.
        const FacedSolid* faced = patches_[i].faced();
        const PiecePlace place = faced != nullptr ? PiecePlace{i, {{0, 0, 0}, {1, 0, 0}}} : rimAt(i, p);
        const double more = faced != nullptr ? patches_[i].riseAt(place.at) - depthOnEdge(*faced, scale_.of(p)) : 0.0;
        std::erase_if(pins_, [&](const DepthPin& other) { return other.at.piece == i && other.at.at == place.at; });
        pins_.push_back({place, pin.z / scale_.size + more});
      }
    }
  }
  void finish(const Depths& depths) {
    for (std::size_t i = 0; i < patches_.size(); ++i) {
      ModelPiece piece{made_[i],
                       solidOf(patches_[i], pieces_[i], depths.pieces[i], scale_, drawing_.size),
                       sheets_[i].region,
                       {},
                       {},
                       offPlane(patches_[i], depths.pieces[i])};
      if (patches_[i].faced() != nullptr) piece.up = patches_[i].faced()->up;
      piece.rim = rimOf(patches_[i], depths.pieces[i], piece.mesh);
      model_.solids.push_back(std::move(piece));
      for (OutlinePath& outline : sheets_[i].outlines) {
        std::ranges::move(outline.completed, std::back_inserter(model_.completed));
      }
    }
    for (const std::uint32_t overlap : depths.conflict) {
      const Order& order = model_.orders.orders[overlap];
      model_.conflicts.push_back({order.over, order.under});
    }
    model_.depth = depths.stats;
  }
  std::vector<ModelPoint> rimOf(const Patch& patch, const PieceDepth& depth, const mesh::TriMesh& mesh) const {
    std::vector<ModelPoint> rim;
    if (patch.faced() != nullptr) {
      for (const auto& p : mesh.positions) rim.push_back({p[0], p[1], p[2]});
      return rim;
    }
    for (std::size_t i = 0; i < patch.mesh().rim(); ++i) {
      const SectionPoint p = patch.mesh().points()[i];
      rim.push_back({p.x, p.y, depth.middle[i] * scale_.size});
    }
    return rim;
  }
  double offPlane(const Patch& patch, const PieceDepth& depth) const {
    if (patch.faced() != nullptr) return patch.faced()->offPlane;
    const PlaneFit fit = planeOf(patch, depth);
    return fit.off / std::sqrt(1 + fit.right * fit.right + fit.up * fit.up);
  }
  /// z = right · x + up · y + c, by least squares over its rim.
  struct PlaneFit {
    double right = 0, up = 0, off = 0;  ///< off: how far z is from it, the most; a share of the size
  };
  PlaneFit planeOf(const Patch& patch, const PieceDepth& depth) const {
    const auto n = static_cast<Eigen::Index>(patch.mesh().rim());
    Eigen::MatrixXd plane(n, 3);
    Eigen::VectorXd z(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      const SectionPoint at = patch.mesh().points()[static_cast<std::size_t>(i)], p = scale_.of({at.x, -at.y});
      plane.row(i) << p.x, p.y, 1;
      z[i] = depth.middle[static_cast<std::size_t>(i)];
    }
    const Eigen::Vector3d fit = plane.colPivHouseholderQr().solve(z);
    return {fit[0], fit[1], (plane * fit - z).cwiseAbs().maxCoeff()};
  }
  /// Off the largest flat piece that lies within 20° across what right angles say: in a drawing that no view looks like
  /// the two differ, and what is put on a table shall not slide.
  void levelUp(const Depths& depths) {
    constexpr double kLevel = 0.94;  // cosine of 20°
    double most = 0;
    const ModelPoint drawn = *model_.up;
    for (std::size_t i = 0; i < patches_.size(); ++i) {
      if (pieces_[i].kind != PieceKind::Flat) continue;
      const PlaneFit fit = planeOf(patches_[i], depths.pieces[i]);
      ModelPoint normal = normalized(ModelPoint{-fit.right, -fit.up, 1});
      if (dot(normal, drawn) < 0) normal = normal * -1.0;
      const double area = geometry::areaOf(sheets_[i].region);
      if (dot(normal, drawn) < kLevel || area <= most) continue;
      most = area;
      model_.up = normal;
    }
  }

  const Drawing& drawing_;
  ModelOptions options_;
  Model model_;
  std::vector<MeasuredLine> lines_;
  DepthScale scale_;
  std::vector<std::uint32_t> made_;  ///< pieces with a patch
  std::vector<Piece> pieces_;        ///< those, and what belongs to them
  std::vector<Sheet> sheets_;
  std::vector<Patch> patches_;
  std::vector<Tie> ties_;
  std::vector<DepthPin> pins_;
};

}  // namespace

Result<Model> modelOf(const Drawing& drawing, const ModelOptions& options) {
  if (options.points < 200 || options.points > 16000) return Error::ValueOutOfRange;
  return Maker(drawing, options).make();
}

}  // namespace spineloft::descriptive
