// Seeded editing sessions: documents as many random actions leave them.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <variant>
#include <vector>

#include "engine/document/action.h"
#include "engine/document/history.h"

namespace spineloft::testing {

/// How often an action of each alternative of the variant succeeded.
using ActionCounts = std::array<int, std::variant_size_v<document::AnyAction>>;

/// The documents of one session of `steps` random actions, from the empty board on; each differs from
/// the one before it.
std::vector<document::Document> randomSession(std::uint64_t seed, int steps, ActionCounts* succeeded = nullptr);

/// A photo of any of the documents, by its content hash.
std::function<std::shared_ptr<const image::Picture>(std::uint64_t)> photosOfAll(
    const std::vector<document::Document>& documents);

}  // namespace spineloft::testing
