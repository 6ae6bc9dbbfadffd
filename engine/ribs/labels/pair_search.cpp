#include "engine/ribs/labels/pair_search.h"

#include <algorithm>
#include <cmath>

#include "engine/ribs/labels/min_plus_step.h"

namespace spineloft::ribs {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

// out = in transposed; in has `rows` × `columns` entries.
void transpose(const float* in, std::size_t rows, std::size_t columns, float* out) {
  constexpr std::size_t kBlock = 16;
  for (std::size_t i0 = 0; i0 < rows; i0 += kBlock) {
    const std::size_t i1 = std::min(rows, i0 + kBlock);
    for (std::size_t j0 = 0; j0 < columns; j0 += kBlock) {
      const std::size_t j1 = std::min(columns, j0 + kBlock);
      for (std::size_t j = j0; j < j1; ++j) {
        for (std::size_t i = i0; i < i1; ++i) out[j * rows + i] = in[i * columns + j];
      }
    }
  }
}

// The tables of the search alternate: rib i is stored with the left label as row where i is even,
// else with the right label, so that each step needs one transposition only.
class PairSearch {
 public:
  PairSearch(const LengthProblem& p, const LabelBounds& bounds, LengthWorkspace& workspace)
      : p_(p), bounds_(bounds), w_(workspace), n_(index(p.levels)) {
    w_.starts.resize(index(p.ribs) + 1);
    std::size_t size = 0, largest = 0;
    for (int i = 0; i < p.ribs; ++i) {
      w_.starts[index(i)] = size;
      size += index(left(i).size()) * index(right(i).size());
      // Between two ribs a table has one side's labels of either.
      if (i > 0) {
        largest = std::max({largest, index(left(i - 1).size()) * index(right(i - 1).size()),
                            index(rowRun(i).size()) * index(columnRun(i - 1).size()),
                            index(left(i).size()) * index(right(i - 1).size()),
                            index(right(i).size()) * index(left(i - 1).size())});
      }
    }
    data_ = w_.pairTable(size);
    if (w_.first.size() < largest) w_.first.resize(largest);
    if (w_.second.size() < largest) w_.second.resize(largest);
  }

  void run(LengthLabels& labels) {
    std::fill(of(0), of(0) + rowRun(0).size() * columnRun(0).size(), 0.f);
    addCosts(0);
    for (int i = 1; i < p_.ribs; ++i) {
      // Rows of the rib before become columns of this one.
      const bool rowsLeft = leftRows(i - 1);
      const LabelRun rows = rowRun(i - 1), columns = columnRun(i - 1);
      const LabelRun newRows = rowRun(i), newColumns = columnRun(i);
      convolveRows(runStep(rowsLeft, i, newColumns, rows), {rows.size(), newColumns.size(), columns.size()}, of(i - 1),
                   w_.first.data(), w_.step);
      transpose(w_.first.data(), index(newColumns.size()), index(columns.size()), w_.second.data());
      convolveRows(runStep(!rowsLeft, i, newRows, columns), {columns.size(), newRows.size(), newColumns.size()},
                   w_.second.data(), of(i), w_.step);
      addCosts(i);
    }
    labels.left.resize(index(p_.ribs));
    labels.right.resize(index(p_.ribs));
    const int last = p_.ribs - 1;
    const std::size_t width = index(columnRun(last).size());
    const std::size_t area = index(rowRun(last).size()) * width;
    const auto best = static_cast<std::size_t>(std::min_element(of(last), of(last) + area) - of(last));
    int row = rowRun(last).low + static_cast<int>(best / width);
    int column = columnRun(last).low + static_cast<int>(best % width);
    for (int i = last;; --i) {
      labels.left[index(i)] = leftRows(i) ? row : column;
      labels.right[index(i)] = leftRows(i) ? column : row;
      if (i == 0) break;
      std::swap(row, column);  // as the rib before is stored
      stepBack(i, row, column);
    }
  }

 private:
  bool leftRows(int rib) const { return rib % 2 == 0; }
  const LabelRun& left(int rib) const { return bounds_.left[index(rib)]; }
  const LabelRun& right(int rib) const { return bounds_.right[index(rib)]; }
  const LabelRun& rowRun(int rib) const { return leftRows(rib) ? left(rib) : right(rib); }
  const LabelRun& columnRun(int rib) const { return leftRows(rib) ? right(rib) : left(rib); }
  float* of(int rib) const { return data_ + w_.starts[index(rib)]; }

  // The step of one side onto a run of labels of `rib` from a run of the rib before.
  MinPlusStep runStep(bool ofLeft, int rib, const LabelRun& to, const LabelRun& from) const {
    MinPlusStep step = stepTo(p_, ofLeft ? p_.left : p_.right, rib);
    step.to += to.low;
    step.from += from.low;
    return step;
  }

  // Adds both sides' unary costs and the opposite cost of a rib to its table.
  void addCosts(int rib) {
    const bool rowsLeft = leftRows(rib);
    const LabelRun rows = rowRun(rib), columns = columnRun(rib);
    const std::size_t at = index(rib) * n_, width = index(columns.size());
    const SideCosts& rowSide = rowsLeft ? p_.left : p_.right;
    const SideCosts& columnSide = rowsLeft ? p_.right : p_.left;
    const float scale = p_.medialOffsetScale.empty() ? 0.f : p_.medialOffsetScale[index(rib)];
    const float rowScale = scale * (rowsLeft ? 1 - p_.medialOffset : 1 + p_.medialOffset);
    const float columnScale = scale * (rowsLeft ? 1 + p_.medialOffset : 1 - p_.medialOffset);
    const float* unary = &columnSide.unary[at + index(columns.low)];
    const float* places = &columnSide.place[at + index(columns.low)];
    float* row = of(rib);
    for (int i = rows.low; i < rows.high; ++i, row += width) {
      const float own = rowSide.unary[at + index(i)], place = rowScale * rowSide.place[at + index(i)];
      for (std::size_t j = 0; j < width; ++j) {
        const float apart = std::abs(place - columnScale * places[j]);
        row[j] += own + unary[j] + (apart < p_.medialOffsetCap ? apart : p_.medialOffsetCap);
      }
      if (p_.opposite.empty()) continue;
      for (std::size_t j = 0; j < width; ++j) {
        const std::size_t column = index(columns.low) + j;
        row[j] += rowsLeft ? p_.opposite[index(i) * n_ + column] : p_.opposite[column * n_ + index(i)];
      }
    }
  }

  // Costs of coming to `label` of rib from the labels `from` of the rib before.
  void stepCosts(bool ofLeft, int rib, int label, const LabelRun& from, std::vector<float>& costs) const {
    const SideCosts& side = ofLeft ? p_.left : p_.right;
    const std::size_t row = index(rib) * n_, before = row - n_;
    costs.resize(index(from.size()));
    for (int k = from.low; k < from.high; ++k) {
      costs[index(k - from.low)] = neighbourCost(p_, side.place[before + index(k)], side.place[row + index(label)],
                                                 side.spacing[index(rib - 1)]);
    }
  }

  // The pair of labels at rib − 1 through which the pair (row, column) at `rib` was reached, rows
  // and columns as at rib − 1.
  void stepBack(int rib, int& row, int& column) {
    const bool rowsLeft = leftRows(rib - 1);
    const LabelRun rows = rowRun(rib - 1), columns = columnRun(rib - 1);
    stepCosts(rowsLeft, rib, row, rows, w_.rowCosts);
    stepCosts(!rowsLeft, rib, column, columns, w_.columnCosts);
    const std::size_t width = index(columns.size());
    const float* table = of(rib - 1);
    w_.columns.assign(width, kUnreachable);
    for (std::size_t i = 0; i < w_.rowCosts.size(); ++i) {
      for (std::size_t j = 0; j < width; ++j)
        w_.columns[j] = std::min(w_.columns[j], table[i * width + j] + w_.rowCosts[i]);
    }
    std::size_t bestRow = 0, best = 0;
    for (std::size_t j = 1; j < width; ++j) {
      if (w_.columns[j] + w_.columnCosts[j] < w_.columns[best] + w_.columnCosts[best]) best = j;
    }
    for (std::size_t i = 1; i < w_.rowCosts.size(); ++i) {
      if (table[i * width + best] + w_.rowCosts[i] < table[bestRow * width + best] + w_.rowCosts[bestRow]) bestRow = i;
    }
    row = rows.low + static_cast<int>(bestRow);
    column = columns.low + static_cast<int>(best);
  }

  const LengthProblem& p_;
  const LabelBounds& bounds_;
  LengthWorkspace& w_;
  std::size_t n_;
  float* data_ = nullptr;
};

}  // namespace

void optimalPairs(const LengthProblem& problem, const LabelBounds& bounds, LengthWorkspace& workspace,
                  LengthLabels& labels) {
  PairSearch(problem, bounds, workspace).run(labels);
}

}  // namespace spineloft::ribs
