// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// In place of the runtime's: nobody asks here whose code a thread executes.
#ifndef OROFORGE_MODEL_ENGINE_HOOK_IN_PROGRESS_HPP
#define OROFORGE_MODEL_ENGINE_HOOK_IN_PROGRESS_HPP

namespace RTT {
namespace internal {

struct HookInProgress {
    HookInProgress(const void*, const char*) noexcept {}
};

}  // namespace internal
}  // namespace RTT

#endif
