#include "engine/io/drawing_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "engine/io/json_fields.h"
#include "engine/mesh/laws.h"

namespace spineloft::io {
namespace {

using Ordered = nlohmann::ordered_json;  // keys stay in the order of this file
using descriptive::Drawing;

constexpr std::array<const char*, static_cast<std::size_t>(descriptive::NodeKind::kCount)> kNodes = {
    "crossing", "touch", "branch", "dip", "corner", "end"};
constexpr std::array<const char*, 4> kFrom = {"drawn", "deduced", "guessed", "user"};

Ordered parse(std::string_view text) {
  constexpr bool kNoExceptions = false;
  return Ordered::parse(text.begin(), text.end(), nullptr, kNoExceptions);
}

/// Reads members of one object after the other; the first fault stays.
class Reader {
 public:
  const std::optional<Failure>& fault() const { return fault_; }

  /// Whether it is an object with no other keys than these.
  bool isObject(const Ordered& json, const std::string& path, std::initializer_list<const char*> keys) {
    if (!json.is_object()) return say(path + " is no object");
    for (const auto& [key, value] : json.items()) {
      if (std::ranges::none_of(keys, [&](const char* known) { return key == known; })) {
        return say("there is nothing named " + path + "." + key);
      }
    }
    return true;
  }
  void number(const Ordered& json, const std::string& path, const char* key, double& value) {
    const auto at = json.find(key);
    if (at == json.end()) return;
    if (!at->is_number() || !std::isfinite(at->get<double>())) {
      say(path + "." + key + " is no number");
    } else {
      value = at->get<double>();
    }
  }
  void index(const Ordered& json, const std::string& path, const char* key, std::uint32_t& value) {
    const auto at = json.find(key);
    if (at == json.end() || !at->is_number_unsigned() || at->get<std::uint64_t>() > 0xffffffffu) {
      say(path + "." + key + " is no number of a line or piece, counted from 0");
    } else {
      value = at->get<std::uint32_t>();
    }
  }
  /// Calls `each(element, path)` for a list; a missing one is empty.
  template <class Each>
  void list(const Ordered& json, const std::string& path, const char* key, const Each& each) {
    const auto at = json.find(key);
    if (at == json.end()) return;
    elements(*at, path + "." + key, each);
  }
  template <class Each>
  void elements(const Ordered& json, const std::string& path, const Each& each) {
    if (!json.is_array()) {
      say(path + " is no list");
      return;
    }
    for (std::size_t i = 0; i < json.size() && !fault_; ++i) each(json[i], path + "[" + std::to_string(i) + "]");
  }
  void numbers(const Ordered& json, const std::string& path, std::vector<double>& values) {
    elements(json, path, [&](const Ordered& one, const std::string& where) {
      if (!one.is_number() || !std::isfinite(one.get<double>())) {
        say(where + " is no number");
      } else {
        values.push_back(one.get<double>());
      }
    });
  }
  bool say(std::string what) {
    if (!fault_) fault_ = Failure{Error::JsonInvalid, std::move(what)};
    return false;
  }

 private:
  std::optional<Failure> fault_;
};

void readLine(Reader& reader, const Ordered& json, const std::string& path, Drawing& drawing) {
  if (!reader.isObject(json, path, {"points", "closed", "hidden"})) return;
  descriptive::Line line;
  std::vector<double> numbers;
  if (!json.contains("points")) {
    reader.say(path + " has no points");
    return;
  }
  reader.numbers(json["points"], path + ".points", numbers);
  if (numbers.size() % 2 == 1) reader.say(path + ".points is no list x, y, x, y …");
  for (std::size_t i = 0; i + 1 < numbers.size(); i += 2) line.points.push_back({numbers[i], numbers[i + 1]});
  if (const auto closed = json.find("closed"); closed != json.end()) {
    if (!closed->is_boolean()) reader.say(path + ".closed is neither true nor false");
    line.closed = closed->is_boolean() && closed->get<bool>();
  }
  if (const auto hidden = json.find("hidden"); hidden != json.end() && hidden->is_boolean()) {
    if (hidden->get<bool>()) line.hidden.push_back({0, 1});
  } else if (hidden != json.end()) {
    reader.elements(*hidden, path + ".hidden", [&](const Ordered& one, const std::string& where) {
      std::vector<double> ends;
      reader.numbers(one, where, ends);
      if (ends.size() != 2) {
        reader.say(where + " is not [from, to]");
      } else {
        line.hidden.push_back({ends[0], ends[1]});
      }
    });
  }
  drawing.lines.push_back(std::move(line));
}

void readPiece(Reader& reader, const Ordered& json, const std::string& path, Drawing& drawing) {
  if (!reader.isObject(json, path, {"name", "kind", "outlines", "stiffness", "front", "back", "thickness"})) return;
  descriptive::Piece piece;
  if (const auto name = json.find("name"); name != json.end()) {
    if (!name->is_string()) reader.say(path + ".name is no text");
    if (name->is_string()) piece.name = name->get<std::string>();
  }
  if (const auto kind = json.find("kind"); kind != json.end()) {
    const bool isKnown = kind->is_string() && fromKey(kind->get<std::string>(), piece.kind);
    if (!isKnown) reader.say(path + ".kind is neither round, flat nor solid");
  }
  reader.list(json, path, "outlines", [&](const Ordered& outline, const std::string& where) {
    piece.outlines.emplace_back();
    reader.elements(outline, where, [&](const Ordered& one, const std::string& here) {
      descriptive::Run run;
      if (!reader.isObject(one, here, {"line", "from", "to"})) return;
      reader.index(one, here, "line", run.line);
      reader.number(one, here, "from", run.from);
      reader.number(one, here, "to", run.to);
      piece.outlines.back().push_back(run);
    });
  });
  if (piece.outlines.empty()) reader.say(path + " has no outlines");
  reader.number(json, path, "stiffness", piece.stiffness);
  reader.number(json, path, "front", piece.front);
  reader.number(json, path, "back", piece.back);
  reader.number(json, path, "thickness", piece.thickness);
  drawing.pieces.push_back(std::move(piece));
}

void readMarks(Reader& reader, const Ordered& json, Drawing& drawing) {
  const std::string path = "drawing";
  reader.list(json, path, "pins", [&](const Ordered& one, const std::string& where) {
    descriptive::Pin pin;
    if (!reader.isObject(one, where, {"line", "at", "z"})) return;
    reader.index(one, where, "line", pin.at.line);
    reader.number(one, where, "at", pin.at.share);
    reader.number(one, where, "z", pin.z);
    drawing.pins.push_back(pin);
  });
  reader.list(json, path, "folds", [&](const Ordered& one, const std::string& where) {
    descriptive::Place fold;
    if (!reader.isObject(one, where, {"line", "at"})) return;
    reader.index(one, where, "line", fold.line);
    reader.number(one, where, "at", fold.share);
    drawing.folds.push_back(fold);
  });
  reader.list(json, path, "orders", [&](const Ordered& one, const std::string& where) {
    descriptive::GivenOrder order;
    if (!reader.isObject(one, where, {"over", "under", "at"})) return;
    reader.index(one, where, "over", order.over);
    reader.index(one, where, "under", order.under);
    std::vector<double> at;
    if (one.contains("at")) reader.numbers(one["at"], where + ".at", at);
    if (at.size() != 2) {
      reader.say(where + ".at is not [x, y]");
      return;
    }
    order.at = {at[0], at[1]};
    drawing.orders.push_back(order);
  });
}

Result<Drawing> drawingFrom(const Ordered& json) {
  Reader reader;
  Drawing drawing;
  if (!reader.isObject(json, "recipe", {"drawing"}) || !json.contains("drawing")) {
    return reader.fault().value_or(Failure{Error::JsonInvalid, "there is no drawing"});
  }
  const Ordered& root = json["drawing"];
  if (reader.isObject(root, "drawing", {"size", "lines", "pieces", "pins", "folds", "orders", "seenFrom"})) {
    std::vector<double> size;
    if (root.contains("size")) reader.numbers(root["size"], "drawing.size", size);
    constexpr double kMostPixels = 100000;
    if (size.size() != 2 || !(size[0] >= 1 && size[1] >= 1 && size[0] <= kMostPixels && size[1] <= kMostPixels)) {
      reader.say("drawing.size is not [width, height]");
    } else {
      drawing.size = {static_cast<int>(size[0]), static_cast<int>(size[1])};
    }
    reader.list(root, "drawing", "lines",
                [&](const Ordered& one, const std::string& where) { readLine(reader, one, where, drawing); });
    if (root.value("pieces", Ordered()) != "auto") {
      reader.list(root, "drawing", "pieces",
                  [&](const Ordered& one, const std::string& where) { readPiece(reader, one, where, drawing); });
    }
    readMarks(reader, root, drawing);
    if (const auto from = root.find("seenFrom"); from != root.end()) {
      const bool isKnown = from->is_string() && fromKey(from->get<std::string>(), drawing.seenFrom);
      if (!isKnown) reader.say("drawing.seenFrom is none of above, below and unknown");
    }
  }
  if (reader.fault()) return *reader.fault();
  return drawing;
}

Ordered pointJson(PicturePoint p) { return Ordered::array({p.x, p.y}); }

Ordered meshJson(const mesh::TriMesh& mesh) {
  const mesh::MeshReport report = mesh::inspect(mesh);
  return {{"vertices", mesh.positions.size()}, {"triangles", mesh.triangles.size()},
          {"closed", report.closed},           {"lawful", report.valid()},
          {"shells", report.shells},           {"genus", report.genus},
          {"volume", report.volume},           {"area", report.area}};
}

std::string listOf(const Ordered& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i].get<std::string>();
  }
  return text;
}

/// Writes what the model says, with the names of its solids.
class Writer {
 public:
  explicit Writer(const descriptive::Model& model) : model_(model) {}

  Ordered all() const {
    Ordered nodes;
    for (std::size_t k = 0; k < kNodes.size(); ++k) {
      nodes[kNodes[k]] =
          std::ranges::count(model_.nodes, static_cast<descriptive::NodeKind>(k), &descriptive::Node::kind);
    }
    Ordered json = {{"size", model_.size}, {"nodes", std::move(nodes)}, {"pieces", pieces()}};
    json["lost"] = Ordered::array();
    for (const descriptive::LostPiece& one : model_.lost) {
      json["lost"].push_back({{"name", model_.pieces[one.piece].name}, {"words", failureSentence(one.failure)}});
    }
    json["openLines"] = model_.openLines;
    json["orders"] = orders();
    json["indices"] = indices();
    json["contradictions"] = contradictions();
    json["qp"] = {{"unknowns", model_.depth.unknowns}, {"rows", model_.depth.rows},
                  {"active", model_.depth.active},     {"rounds", model_.depth.rounds},
                  {"broken", model_.depth.broken},     {"pinsHold", model_.depth.pinsHold}};
    return json;
  }

 private:
  const std::string& nameOf(std::uint32_t solid) const { return model_.pieces[model_.solids[solid].piece].name; }

  Ordered pieces() const {
    Ordered out = Ordered::array();
    for (const descriptive::ModelPiece& one : model_.solids) {
      const descriptive::Piece& piece = model_.pieces[one.piece];
      out.push_back({{"name", piece.name},
                     {"kind", std::string(keyOf(piece.kind))},
                     {"outlines", piece.outlines.size()},
                     {"planarity", one.planarity},
                     {"mesh", meshJson(one.mesh)}});
    }
    return out;
  }
  Ordered orders() const {
    Ordered out = Ordered::array();
    for (std::size_t k = 0; k < model_.orders.orders.size(); ++k) {
      const descriptive::Order& order = model_.orders.orders[k];
      out.push_back({{"over", nameOf(order.over)},
                     {"under", nameOf(order.under)},
                     {"at", pointJson(model_.orders.overlaps.all()[k].at)},
                     {"kind", order.kind == descriptive::OrderKind::Over ? "over" : "inside"},
                     {"from", kFrom[static_cast<std::size_t>(order.from)]}});
    }
    return out;
  }
  Ordered indices() const {
    Ordered out = Ordered::array();
    for (const descriptive::OrderedStretch& one : model_.orders.stretches) {
      out.push_back({{"piece", nameOf(one.piece)},
                     {"outline", one.outline},
                     {"from", one.from},
                     {"to", one.to},
                     {"hidden", one.hidden},
                     {"index", one.index}});
    }
    return out;
  }
  Ordered contradictions() const {
    Ordered out = Ordered::array();
    for (const descriptive::Contradiction& one : model_.orders.contradictions) {
      Ordered names = Ordered::array();
      for (const std::uint32_t piece : one.pieces) names.push_back(nameOf(piece));
      const std::string words = "The lines of " + listOf(names) + " contradict each other.";
      out.push_back({{"pieces", std::move(names)}, {"at", pointJson(one.at)}, {"words", words}});
    }
    for (const auto& [over, under] : model_.conflicts) {
      const Ordered names = Ordered::array({nameOf(over), nameOf(under)});
      out.push_back({{"pieces", names},
                     {"at", nullptr},
                     {"words", nameOf(over) + " cannot be in front of " + nameOf(under) + " there."}});
    }
    return out;
  }

  const descriptive::Model& model_;
};

}  // namespace

bool isDrawing(std::string_view json) {
  try {
    const Ordered root = parse(json);
    return root.is_object() && root.contains("drawing");
  } catch (const std::exception&) {  // no memory
    return false;
  }
}

Result<Drawing> readDrawing(std::string_view json) {
  try {
    const Ordered root = parse(json);
    if (root.is_discarded()) return {Error::JsonInvalid, "it is no JSON"};
    return drawingFrom(root);
  } catch (const std::exception&) {  // the JSON library and the standard one only throw for memory
    return Error::OutOfMemory;
  }
}

std::string writeDrawingReport(const descriptive::Model& model, const NamedNumbers& milliseconds) {
  Ordered times = Ordered::object();
  for (const auto& [name, number] : milliseconds) times[name] = number;
  const Ordered json = {{"drawing", Writer(model).all()}, {"milliseconds", std::move(times)}};
  return json.dump(2, ' ', false, Ordered::error_handler_t::replace) + "\n";
}

}  // namespace spineloft::io
