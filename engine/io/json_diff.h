// What changed from one JSON value to another, as JSON. Internal to io/.
//
//   ["=", value]                    replaced
//   ["-"]                           taken out of its object
//   ["~", {key: change, …}]         an object, some keys of which changed
//   ["+", head, tail, [values]]     a list: its first `head` and last `tail` elements stay, with the
//                                   values between them
//   ["@", place, change]            a list, one element of which changed
#pragma once

#include <nlohmann/json.hpp>

namespace spineloft::io {

/// Null when the values are equal.
nlohmann::json difference(const nlohmann::json& before, const nlohmann::json& after);

/// Changes `value` as `change` (not null) says. False, with `value` in any state, when the change does not
/// fit: any JSON is safe.
bool applyDifference(nlohmann::json& value, const nlohmann::json& change);

}  // namespace spineloft::io
