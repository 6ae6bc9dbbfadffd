// Short words for tests that put parts together.
#pragma once

#include <doctest/doctest.h>

#include <cstdint>
#include <utility>
#include <vector>

#include "engine/base/result.h"
#include "engine/document/update.h"

namespace spineloft::testing {

inline document::Operand part(std::uint32_t id) { return {PartId{id}, {}}; }
inline document::Operand step(std::uint32_t id) { return {{}, StepId{id}}; }

/// What an action makes of a document that allows it.
inline document::Document after(const document::Document& document, const document::Action& action) {
  const Result<document::Document> next = document::update(document, action);
  REQUIRE_MESSAGE(next.ok(), failureSentence(next.failure()));
  return next.value();
}

inline document::CombineParts combine(document::StepKind kind, std::vector<document::Operand> operands) {
  return {kind, std::move(operands), 0.02, {}};
}

}  // namespace spineloft::testing
