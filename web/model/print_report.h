// The check for printing in plain words.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/document/document.h"
#include "engine/printing/print_check.h"
#include "web/model/thickening.h"

namespace spineloft::app {

/// A check, and the document that was checked.
struct PrintReport {
  printing::PrintCheck check;
  document::Document of;
  std::vector<Thickening> thin = {};       ///< what could be set thicker where it is too thin
  std::string faults = {};                 ///< what of the model is not as it should be (see faultsOf)
  std::vector<std::string> crossing = {};  ///< names of parts that go through themselves
};

/// What to do where no printer takes what is made larger until its thinnest place is thick enough.
inline constexpr std::string_view kThickenByHand =
    "Made larger until it does not, it fits no common printer: pull the ends of the ribs apart there, or give it more "
    "thickness.";

struct PrintLine {
  bool good = false;
  std::string text;           ///< a sentence
  std::string_view fix = {};  ///< the command that mends it, if one does
};
/// What is at fault, closed and in how many pieces, what goes through itself, size, thickness, and how a single piece
/// stands: a line each.
std::vector<PrintLine> printLines(const PrintReport& report);

struct PrintMessage {
  bool good = false;
  std::string text;
};
/// All lines when all are good; otherwise those that are not, so that none of them is lost among the good ones.
PrintMessage printMessage(const PrintReport& report);

}  // namespace spineloft::app
