// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "real_time_trap.hpp"

#include "real_time_hooks.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cxxabi.h>
#include <dlfcn.h>
#include <execinfo.h>
#include <gtest/gtest.h>
#include <sstream>

namespace oroforge::test {

namespace {

thread_local RealTimeTrap* trapOfThread = nullptr;

std::string describe(void* address) {
    std::ostringstream text;
    Dl_info info{};
    if (dladdr(address, &info) == 0) {
        text << address;
        return text.str();
    }
    int status = -1;
    char* name = info.dli_sname ? abi::__cxa_demangle(info.dli_sname, nullptr, nullptr, &status) : nullptr;
    // The offset is what addr2line wants: `addr2line -Cfie FILE OFFSET`.
    text << info.dli_fname << "+0x" << std::hex
         << reinterpret_cast<std::uintptr_t>(address) - reinterpret_cast<std::uintptr_t>(info.dli_fbase);
    if (info.dli_sname) text << ' ' << (status == 0 ? name : info.dli_sname);
    std::free(name);
    return text.str();
}

}  // namespace

bool RealTimeTrap::works() noexcept { return oroforge_real_time_hooks_present() != 0; }

RealTimeTrap::RealTimeTrap(unsigned kinds, const char* file, int line) : file_(file), line_(line), kinds_(kinds) {
    if (trapOfThread) {
        std::fputs("RealTimeTrap: there is one in this thread already\n", stderr);
        std::abort();
    }
    // The first call of either loads a library or looks something up, with locks and allocations.
    void* frame = nullptr;
    backtrace(&frame, 1);
    trapOfThread = this;
}

RealTimeTrap::~RealTimeTrap() {
    stop();
    if (calls_ != 0 && !forgiven_) ADD_FAILURE_AT(file_, line_) << report();
}

void RealTimeTrap::stop() noexcept {
    if (trapOfThread == this) trapOfThread = nullptr;
}

void RealTimeTrap::note(Kind kind, const char* function, const void* caller) noexcept {
    if (noting_ || (kinds_ & kind) == 0) return;
    noting_ = true;
    ++counts_[__builtin_ctz(kind)];
    if (calls_ < kMaxCalls) {
        shown_[calls_].function = function;
        shown_[calls_].caller = caller;
        shown_[calls_].depth = backtrace(shown_[calls_].frames, kMaxFrames);
    }
    ++calls_;
    noting_ = false;
}

unsigned RealTimeTrap::caught(unsigned kinds) const noexcept {
    unsigned sum = 0;
    for (unsigned i = 0; i != 4; ++i)
        if (kinds & (1u << i)) sum += counts_[i];
    return sum;
}

std::string RealTimeTrap::report() const {
    std::ostringstream text;
    text << calls_ << " call(s) that a real-time thread must not make\n";
    for (int i = 0; i < calls_ && i < kMaxCalls; ++i) {
        text << "  " << shown_[i].function << "() called by\n";
        void* const* const end = shown_[i].frames + shown_[i].depth;
        // The first ones are this file and the function itself.
        for (auto at = std::find(shown_[i].frames, end, shown_[i].caller); at != end; ++at)
            text << "    " << describe(*at) << '\n';
    }
    if (calls_ > kMaxCalls) text << "  …\n";
    return text.str();
}

}  // namespace oroforge::test

extern "C" void oroforge_real_time_note(unsigned kind, const char* function, const void* caller) {
    using oroforge::test::RealTimeTrap;
    if (RealTimeTrap* trap = oroforge::test::trapOfThread)
        trap->note(static_cast<RealTimeTrap::Kind>(kind), function, caller);
}
