// Documents by the actions that make them.
#pragma once

#include <doctest/doctest.h>

#include <utility>
#include <vector>

#include "engine/document/update.h"

namespace spineloft::testing {

/// The document after these actions, none of which may fail.
inline document::Document after(document::Document document, const std::vector<document::Action>& actions) {
  for (const document::Action& action : actions) {
    Result<document::Document> next = document::update(document, action);
    REQUIRE_MESSAGE(next.ok(), failureSentence(next.ok() ? Failure{} : next.failure()));
    document = std::move(next).value();
  }
  return document;
}

/// Why an action is refused; kCount: it is not.
inline Error errorOf(const document::Document& document, const document::Action& action) {
  const Result<document::Document> next = document::update(document, action);
  return next.ok() ? Error::kCount : next.error();
}

}  // namespace spineloft::testing
