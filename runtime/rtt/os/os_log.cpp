// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/os/os_log.hpp>

#include <rtt/os/log_hook.hpp>

#include <atomic>
#include <cstdio>

namespace RTT::os {

namespace {
std::atomic<LogHook> logHook{nullptr};
std::atomic<RealTimeThreadHook> threadHook{nullptr};
}  // namespace

void setLogHook(LogHook hook) noexcept { logHook.store(hook, std::memory_order_release); }
void setRealTimeThreadHook(RealTimeThreadHook hook) noexcept { threadHook.store(hook, std::memory_order_release); }

namespace detail {

void beginRealTimeThread() {
    if (RealTimeThreadHook hook = threadHook.load(std::memory_order_acquire)) hook();
}

void log(LogLevel level, const char* module, std::string_view text) {
    if (LogHook hook = logHook.load(std::memory_order_acquire))
        hook(level, module, text);
    else if (level <= LogWarning)
        std::fprintf(stderr, "[%s] %.*s\n", module, static_cast<int>(text.size()), text.data());
}

}  // namespace detail
}  // namespace RTT::os
