#include "web/model/print_report.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace spineloft::app {
namespace {

/// Models up to here are measured in millimetres.
constexpr double kSmallMm = 20;

std::string number(double value, int digits) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  std::string out = text;
  if (out.find('.') != std::string::npos) {
    while (out.back() == '0') out.pop_back();
    if (out.back() == '.') out.pop_back();
  }
  return out;
}

PrintLine sizeLine(const printing::PrintCheck& check) {
  const auto& [width, depth, height] = check.size;
  const bool small = std::max({width, depth, height}) < kSmallMm;
  const double unit = small ? 1 : 10;
  const std::string size = number(width / unit, 1) + " × " + number(depth / unit, 1) + " × " +
                           number(height / unit, 1) + (small ? " mm" : " cm");
  const auto printers = printing::printers();
  if (check.printer < printers.size()) {
    return {true, "It is " + size + " and fits " + std::string(printers[check.printer].name) + "."};
  }
  return {false, "It is " + size + ", too large for common printers. Make it less tall."};
}

PrintLine wallLine(const printing::PrintCheck& check, const std::vector<Thickening>& set) {
  if (check.thick()) return {true, "Its thinnest place is " + number(check.thinnest, 1) + " mm, thick enough."};
  // Never rounded up to what would do.
  const std::string thin = number(std::floor(check.thinnest * 100) / 100, 2);
  const std::string why = "Its thinnest place is " + thin + " mm; below 0.8 mm it breaks or is left out. ";
  if (!set.empty()) {
    return {false, why + "\"Make it thick enough\" gives " + number(kThickened, 1) + " mm to " + spokenList(set) + ".",
            "thicken"};
  }
  if (check.enlargingHelps) return {false, why + "\"Make it thick enough\" makes it larger.", "thicken"};
  return {false, why + std::string(kThickenByHand)};
}

PrintLine closedLine(const printing::PrintCheck& check) {
  if (!check.closed) return {false, "A part of it is not closed. Change its ribs a little, or draw it again."};
  if (check.pieces < 2) return {true, "It is closed all round and in one piece."};
  return {false, "It is in " + std::to_string(check.pieces) +
                     " pieces that do not touch. Move them together, or print each by itself."};
}

PrintLine standLine(const printing::PrintCheck& check) {
  const double degrees = check.tippingAngle * 180 / std::numbers::pi;
  if (check.stands()) {
    return {true, "It stands: it can lean " + number(std::floor(degrees), 0) + "° before it falls."};
  }
  if (!check.footHelps) return {false, "It would fall over. Print it lying down, or stick it on something broad."};
  return {false, "It would fall over. \"Flat foot\" cuts it flat below; or print it lying down.", "flat-foot"};
}

}  // namespace

std::vector<PrintLine> printLines(const PrintReport& report) {
  const printing::PrintCheck& check = report.check;
  std::vector<PrintLine> lines;
  if (!report.faults.empty()) lines.push_back({false, report.faults});
  lines.push_back(closedLine(check));
  for (const std::string& part : report.crossing)
    lines.push_back({false, failureSentence({Error::PartCrossesItself, part})});
  lines.insert(lines.end(), {sizeLine(check), wallLine(check, report.thin)});
  // How a heap of loose pieces stands is nobody's question.
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
    if (line.good == message.good) message.text += (message.text.empty() ? "" : " ") + line.text;
  }
  if (!message.good && someGood) message.text += " The rest is fine for printing.";
  return message;
}

}  // namespace spineloft::app
