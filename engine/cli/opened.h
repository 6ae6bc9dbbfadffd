// A model as the commands open it.
#pragma once

#include <string>

#include "engine/base/result.h"
#include "engine/document/document.h"
#include "engine/io/project_file.h"
#include "engine/pipeline/derive.h"

namespace spineloft::cli {

/// What was in the file and what became of it.
struct Opened {
  document::Document document;
  pipeline::Derived derived;
  io::ReadNotes notes;
  double readMs = 0, deriveMs = 0;
};

/// `name` is a file with a project inside or, where there is no such file, a link with a model in it, or its text
/// (io::textOfLink). Errors: those of readFile, io::readProject, io::readShareText and pipeline::deriveWithEdges.
Result<Opened> openModel(const std::string& name);

}  // namespace spineloft::cli
