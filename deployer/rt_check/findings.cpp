// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "findings.hpp"

#include "symbols.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace oroforge::rt_check {

Finding findings[kFindings];

namespace {

std::atomic<unsigned> addressGeneration{0};
std::atomic<unsigned> made{0};

std::size_t hashOf(const Call& call, unsigned generation) noexcept {
    std::uint64_t hash = 1469598103934665603u;
    const auto add = [&hash](std::uint64_t value) { hash = (hash ^ value) * 1099511628211u; };
    for (const char* c = call.component; *c; ++c) add(static_cast<unsigned char>(*c));
    for (const char* c = call.function; *c; ++c) add(static_cast<unsigned char>(*c));
    for (const char* c = call.script; *c; ++c) add(static_cast<unsigned char>(*c));
    add(generation);
    for (unsigned i = 0; i != call.depth; ++i) add(reinterpret_cast<std::uintptr_t>(call.frames[i]));
    return static_cast<std::size_t>(hash ^ hash >> 32);
}

}  // namespace

bool Finding::isOf(const Call& call, std::size_t itsHash, unsigned itsGeneration) const noexcept {
    return hash == itsHash && generation == itsGeneration && place == call.place && fault == call.fault &&
           depth == call.depth && std::strcmp(function, call.function) == 0 &&
           std::strncmp(component, call.component, kLongestName - 1) == 0 &&
           std::strncmp(script, call.script, kLongestScript - 1) == 0 &&
           std::equal(frames, frames + depth, call.frames);
}

void Finding::fill(const Call& call, std::size_t itsHash, unsigned itsGeneration) noexcept {
    hash = itsHash;
    number = made.fetch_add(1, std::memory_order_relaxed);
    generation = itsGeneration;
    std::strncpy(component, call.component, kLongestName - 1);
    std::strncpy(script, call.script, kLongestScript - 1);
    place = call.place;
    fault = call.fault;
    function = call.function;
    depth = call.depth;
    std::copy(call.frames, call.frames + call.depth, frames);
}

bool Finding::isAllowed() const noexcept {
    return fault == OROFORGE_RT_LOCK && depth != 0 && texts[0] && isMemoryPoolFunction(texts[0]);
}

bool count(const Call& whole) noexcept {
    Call call = whole;
    call.depth = std::min(call.depth, Finding::kMaxFrames);
    const unsigned generation = addressGeneration.load(std::memory_order_relaxed);
    const std::size_t hash = hashOf(call, generation);
    for (std::size_t i = 0; i != kFindings; ++i) {
        Finding& finding = findings[(hash + i) % kFindings];
        int state = finding.state.load(std::memory_order_acquire);
        if (state == Finding::kFree && finding.state.compare_exchange_strong(state, Finding::kBeingMade)) {
            finding.fill(call, hash, generation);
            finding.count.store(1, std::memory_order_relaxed);
            // Release: a thread that sees the state sees the other members.
            finding.state.store(Finding::kMade, std::memory_order_release);
            return true;
        }
        // Skips a finding that another thread is making, because that thread may be waiting for this processor. If it
        // is for the same call, there are two findings, which the report adds up.
        if (state != Finding::kMade || !finding.isOf(call, hash, generation)) continue;
        finding.count.fetch_add(1, std::memory_order_relaxed);
        return true;
    }
    return false;
}

void beginAddressesAnew() noexcept { addressGeneration.fetch_add(1, std::memory_order_relaxed); }

void describeFindings() {
    forEachFinding([](Finding& finding) {
        for (unsigned i = 0; i != finding.depth; ++i)
            if (!finding.texts[i]) finding.texts[i] = describeFrame(finding.frames[i]);
    });
}

}  // namespace oroforge::rt_check
