// Profiles that one tap gives a puff.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "engine/inflate/inflate_params.h"

namespace spineloft::inflate {

/// What a ready profile is called: `key` in the API ("two-rings"), `label` on the page.
struct ReadyProfile {
  std::string_view key, label;
};
/// In the order of the page; the first is soft, without a slice.
std::span<const ReadyProfile> readyProfiles();

/// The profile with this key, which profileCurves takes for all sides. None for an unknown key.
std::optional<ProfileParams> readyProfile(std::string_view key);
/// The key of the ready profile with the first slice of `profile`, to within 0.001; "own" when there is none.
std::string_view profileKey(const ProfileParams& profile);

}  // namespace spineloft::inflate
