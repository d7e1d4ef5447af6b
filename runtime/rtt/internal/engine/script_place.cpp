// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/engine/script_place.hpp>

#include <atomic>

namespace RTT::internal {

namespace {
std::atomic<bool> exactWanted{false};
// Initial-exec: functions in front of malloc() read it and must not allocate.
thread_local const ScriptPlace* innermostPlace __attribute__((tls_model("initial-exec"))) = nullptr;
}  // namespace

ScriptPlace::ScriptPlace(Describe describe, void* interpreter) noexcept
    : describe_(describe), interpreter_(interpreter), outer_(innermostPlace) {
    innermostPlace = this;
}

ScriptPlace::~ScriptPlace() { innermostPlace = outer_; }

void ScriptPlace::wantExact() noexcept { exactWanted.store(true); }
bool ScriptPlace::isExactWanted() noexcept { return exactWanted.load(); }

void ScriptPlace::describe(char* text, std::size_t size) noexcept {
    if (size == 0) return;
    text[0] = '\0';
    if (innermostPlace && innermostPlace->describe_)
        innermostPlace->describe_(innermostPlace->interpreter_, text, size);
}

}  // namespace RTT::internal
