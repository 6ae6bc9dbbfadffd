// What the rows of a benchmark come to: means by group, tables for people, and the report's file.
#pragma once

#include <iosfwd>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/base/result.h"
#include "engine/io/json_values.h"

namespace spineloft::cli {

using RowGroup = std::vector<const io::BenchRow*>;
using RowGroups = std::vector<std::pair<std::string, RowGroup>>;

/// Every stroke over all cases, then over each category, then over all that are hard in one way; categories and
/// strokes in order of first appearance. They point into `rows`.
RowGroups groupsOf(const std::vector<io::BenchRow>& rows);

/// One number of all rows that have it.
std::vector<double> column(const RowGroup& rows, std::string_view name);
/// 0 of nothing.
double mean(const std::vector<double>& values);

/// The means of every group, under its name.
io::NamedLines summaries(const RowGroups& groups);

/// The rows and the means, as two tables.
void printReport(std::ostream& out, const io::BenchReport& report);

/// Before minutes of work, not after them: whether the folders of the files exist (empty names are none), and makes
/// that of the overlays. Error: FileUnwritable with the name.
Status prepareOutputs(std::span<const std::string> files, const std::string& overlays);

}  // namespace spineloft::cli
