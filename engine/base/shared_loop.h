// A loop whose rounds do not depend on each other, on two processors at once.
#pragma once

namespace spineloft {

/// Rounds first … end − 1 of a loop. `who`: 0 or 1; no two shares of one `who` run at the same time, so that each may
/// have memory of its own.
struct LoopShare {
  int first = 0, end = 0, who = 0;
};

using LoopWork = void (*)(const void* work, LoopShare share);
/// What sharedLoop does, for any `work`.
void runShares(int count, LoopWork call, const void* work);

/// Calls work(share) for shares that are together the rounds 0 … count − 1, and returns when all are done. Where the
/// program has threads and the machine two processors, a second thread takes shares as well while it is awake and no
/// other caller's. The result may not depend on which rounds share what. `work` may not throw. May be called on any
/// thread, also within a share; there `who` counts anew.
template <class Work>
void sharedLoop(int count, const Work& work) {
  runShares(count, [](const void* all, LoopShare share) { (*static_cast<const Work*>(all))(share); }, &work);
}

}  // namespace spineloft
