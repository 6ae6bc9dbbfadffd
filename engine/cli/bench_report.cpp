#include "engine/cli/bench_report.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <functional>
#include <iomanip>
#include <optional>
#include <ostream>
#include <system_error>
#include <utility>

#include "engine/cli/bench_cases.h"
#include "engine/cli/score.h"

namespace spineloft::cli {
namespace {

/// Value of a row's number, if it has it.
std::optional<double> numberIn(const io::BenchRow& row, std::string_view name) {
  for (const auto& [key, value] : row.numbers) {
    if (key == name) return value;
  }
  return std::nullopt;
}

double shareOf(const std::vector<double>& values, const std::function<bool(double)>& test) {
  const auto count = std::count_if(values.begin(), values.end(), test);
  return values.empty() ? 0 : static_cast<double>(count) / static_cast<double>(values.size());
}

io::NamedNumbers summarise(const RowGroup& rows) {
  io::NamedNumbers out{{"cases", static_cast<double>(rows.size())}};
  for (const char* name : {"iou", "iou_body", "rib_mean_pct", "rib_p95_pct", "rib_within_tol", "iou_between_strokes",
                           "iou_body_between_strokes"}) {
    out.emplace_back(name, mean(column(rows, name)));
  }
  const std::vector<double> p95 = column(rows, "rib_p95_pct");
  out.emplace_back("median_rib_p95_pct", p95.empty() ? 0 : percentile(p95, 0.5));
  const std::vector<double> body = column(rows, "iou_body");
  out.emplace_back("least_iou_body", body.empty() ? 0 : *std::ranges::min_element(body));
  out.emplace_back("share_iou_body_0.9", shareOf(body, [](double v) { return v >= 0.9; }));
  out.emplace_back("share_iou_body_0.8", shareOf(body, [](double v) { return v >= 0.8; }));
  out.emplace_back("share_iou_body_below_0.5", shareOf(body, [](double v) { return v < 0.5; }));
  for (const char* name : {"edges_ms", "ribs_ms", "loft_ms"}) {
    const std::vector<double> values = column(rows, name);
    out.emplace_back(std::string("median_") + name, values.empty() ? 0 : percentile(values, 0.5));
  }
  double ends = 0;
  for (const char* name : {"ends_edge", "ends_bridged", "ends_guessed"}) {
    for (const double value : column(rows, name)) ends += value;
  }
  for (const char* name : {"ends_edge", "ends_bridged", "ends_guessed"}) {
    double sum = 0;
    for (const double value : column(rows, name)) sum += value;
    out.emplace_back(std::string("share_") + name, ends > 0 ? sum / ends : 0);
  }
  const auto failed = std::count_if(rows.begin(), rows.end(), [](const auto* row) { return !row->failure.empty(); });
  out.emplace_back("failed", static_cast<double>(failed));
  return out;
}

struct Column {
  const char* title;
  const char* key;
  int decimals;
};

void printTable(std::ostream& out, std::span<const Column> columns, const io::NamedLines& lines) {
  std::size_t longest = 0;
  for (const auto& line : lines) longest = std::max(longest, line.first.size());
  const int nameWidth = static_cast<int>(longest) + 2;
  out << std::left << std::setw(nameWidth) << "" << std::right;
  for (const Column& column : columns) out << std::setw(9) << column.title;
  out << '\n';
  for (const auto& [name, numbers] : lines) {
    out << std::left << std::setw(nameWidth) << name << std::right << std::fixed;
    for (const Column& column : columns) {
      const auto at =
          std::find_if(numbers.begin(), numbers.end(), [&](const auto& number) { return number.first == column.key; });
      if (at == numbers.end()) {
        out << std::setw(9) << '-';
      } else {
        out << std::setw(9) << std::setprecision(column.decimals) << at->second;
      }
    }
    out << '\n';
  }
}

constexpr std::array kRowColumns{Column{"iou", "iou", 3},
                                 Column{"body", "iou_body", 3},
                                 Column{"rib %", "rib_mean_pct", 1},
                                 Column{"p95 %", "rib_p95_pct", 1},
                                 Column{"in tol", "rib_within_tol", 2},
                                 Column{"edge", "ends_edge", 0},
                                 Column{"bridged", "ends_bridged", 0},
                                 Column{"guessed", "ends_guessed", 0},
                                 Column{"edges ms", "edges_ms", 1},
                                 Column{"ribs ms", "ribs_ms", 1},
                                 Column{"loft ms", "loft_ms", 1}};
constexpr std::array kSummaryColumns{Column{"cases", "cases", 0},
                                     Column{"iou", "iou", 3},
                                     Column{"body", "iou_body", 3},
                                     Column{">=0.9", "share_iou_body_0.9", 2},
                                     Column{">=0.8", "share_iou_body_0.8", 2},
                                     Column{"<0.5", "share_iou_body_below_0.5", 2},
                                     Column{"rib %", "rib_mean_pct", 1},
                                     Column{"p95 %", "rib_p95_pct", 1},
                                     Column{"in tol", "rib_within_tol", 2},
                                     Column{"agree", "iou_between_strokes", 3},
                                     Column{"agr.body", "iou_body_between_strokes", 3},
                                     Column{"edges ms", "median_edges_ms", 1},
                                     Column{"ribs ms", "median_ribs_ms", 1},
                                     Column{"loft ms", "median_loft_ms", 1},
                                     Column{"failed", "failed", 0}};

}  // namespace

std::vector<double> column(const RowGroup& rows, std::string_view name) {
  std::vector<double> values;
  for (const io::BenchRow* row : rows) {
    if (const auto value = numberIn(*row, name)) values.push_back(*value);
  }
  return values;
}

double mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return values.empty() ? 0 : sum / static_cast<double>(values.size());
}

RowGroups groupsOf(const std::vector<io::BenchRow>& rows) {
  RowGroups groups;
  const auto add = [&](const std::string& name, const io::BenchRow& row) {
    const auto at = std::find_if(groups.begin(), groups.end(), [&](const auto& group) { return group.first == name; });
    if (at == groups.end()) {
      groups.push_back({name, {&row}});
    } else {
      at->second.push_back(&row);
    }
  };
  for (const io::BenchRow& row : rows) add("all " + row.stroke, row);
  for (const io::BenchRow& row : rows) add(row.category + ' ' + row.stroke, row);
  for (const std::string_view name : difficultyOrder()) {
    for (const io::BenchRow& row : rows) {
      if (std::ranges::find(row.difficulty, name) != row.difficulty.end())
        add(std::string(name) + ", " + row.stroke, row);
    }
  }
  return groups;
}

io::NamedLines summaries(const RowGroups& groups) {
  io::NamedLines out;
  for (const auto& [name, members] : groups) out.emplace_back(name, summarise(members));
  return out;
}

void printReport(std::ostream& out, const io::BenchReport& report) {
  io::NamedLines lines;
  for (const io::BenchRow& row : report.rows) {
    const std::string note = row.failure.empty() ? "" : " (" + row.failure + ")";
    lines.emplace_back(row.name + ' ' + row.stroke + note, row.numbers);
  }
  printTable(out, kRowColumns, lines);
  out << '\n';
  printTable(out, kSummaryColumns, report.summary);
}

Status prepareOutputs(std::span<const std::string> files, const std::string& overlays) {
  std::error_code problem;
  for (const std::string& file : files) {
    const std::filesystem::path parent = std::filesystem::path(file).parent_path();
    if (!parent.empty() && !std::filesystem::is_directory(parent, problem)) return {Error::FileUnwritable, file};
  }
  if (overlays.empty()) return Done{};
  std::filesystem::create_directories(overlays, problem);
  if (problem) return {Error::FileUnwritable, overlays};
  return Done{};
}

}  // namespace spineloft::cli
