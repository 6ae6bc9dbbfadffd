#include "web/model/print_report.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "web/model/messages.h"
#include "web/words/words.h"

namespace spineloft::app {
namespace {

/// Models up to here are measured in millimetres.
constexpr double kSmallMm = 20;

double rounded(double value, int digits) {
  const double scale = std::pow(10, digits);
  return std::round(value * scale) / scale;
}

std::string said(std::string_view text, words::Args args = {}) { return std::string(words::tr(text, args)); }

PrintLine sizeLine(const printing::PrintCheck& check) {
  const auto& [width, depth, height] = check.size;
  const bool small = std::max({width, depth, height}) < kSmallMm;
  const double unit = small ? 1 : 10;
  const std::string size = said(small ? "{width} × {depth} × {height} mm" : "{width} × {depth} × {height} cm",
                                {{"width", rounded(width / unit, 1)},
                                 {"depth", rounded(depth / unit, 1)},
                                 {"height", rounded(height / unit, 1)}});
  const auto printers = printing::printers();
  if (check.printer < printers.size()) {
    const std::string_view printer = words::tr(printers[check.printer].name);
    return {true, said("It is {size} and fits {printer}.", {{"size", size}, {"printer", printer}})};
  }
  return {false, said("It is {size}, too large for common printers. Make it less tall.", {{"size", size}})};
}

PrintLine wallLine(const printing::PrintCheck& check, const std::vector<Thickening>& set) {
  if (check.thick()) {
    return {true, said("Its thinnest place is {n} mm, thick enough.", {{"n", rounded(check.thinnest, 1)}})};
  }
  // Never rounded up to what would do.
  const std::string why = said("Its thinnest place is {n} mm; below {least} mm it breaks or is left out.",
                               {{"n", std::floor(check.thinnest * 100) / 100}, {"least", printing::kLeastWall}}) +
                          " ";
  if (!set.empty()) {
    const std::string mends = said("\"Make it thick enough\" gives {n} mm to {what}.",
                                   {{"n", rounded(kThickened, 1)}, {"what", spokenList(set)}});
    return {false, why + mends, "thicken"};
  }
  if (check.enlargingHelps) return {false, why + said("\"Make it thick enough\" makes it larger."), "thicken"};
  return {false, why + said(kThickenByHand)};
}

PrintLine closedLine(const printing::PrintCheck& check) {
  if (!check.closed) return {false, said("A part of it is not closed. Change its ribs a little, or draw it again.")};
  if (check.pieces < 2) return {true, said("It is closed all round and in one piece.")};
  return {false, said("It is in {n} pieces that do not touch. Move them together, or print each by itself.",
                      {{"n", check.pieces}})};
}

PrintLine standLine(const printing::PrintCheck& check) {
  const double degrees = check.tippingAngle * 180 / std::numbers::pi;
  if (check.stands()) {
    return {true, said("It stands: it can lean {n}° before it falls.", {{"n", std::floor(degrees)}})};
  }
  if (!check.footHelps) {
    return {false, said("It would fall over. Print it lying down, or stick it on something broad.")};
  }
  return {false, said("It would fall over. \"Flat foot\" cuts it flat below; or print it lying down."), "flat-foot"};
}

}  // namespace

std::vector<PrintLine> printLines(const PrintReport& report) {
  const printing::PrintCheck& check = report.check;
  std::vector<PrintLine> lines;
  if (!report.faults.empty()) lines.push_back({false, report.faults});
  lines.push_back(closedLine(check));
  for (const std::string& part : report.crossing)
    lines.push_back({false, spokenFailure({Error::PartCrossesItself, part})});
  lines.insert(lines.end(), {sizeLine(check), wallLine(check, report.thin)});
  // Loose pieces have no common foot to stand on.
  if (check.pieces < 2) lines.push_back(standLine(check));
  return lines;
}

PrintMessage printMessage(const PrintReport& report) {
  const std::vector<PrintLine> lines = printLines(report);
  PrintMessage message;
  message.good = std::ranges::all_of(lines, &PrintLine::good);
  bool someGood = false;
  for (const PrintLine& line : lines) {
    someGood = someGood || line.good;
    if (line.good != message.good) continue;
    if (!message.text.empty()) message.text += ' ';
    message.text += line.text;
  }
  if (!message.good && someGood) message.text.append(" ").append(said("The rest is fine for printing."));
  return message;
}

}  // namespace spineloft::app
