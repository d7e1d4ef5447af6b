// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/os/detail/os_log.hpp>

#include <rtt/os/log_hook.hpp>

#include <atomic>
#include <cstdio>

namespace RTT {
namespace os {

namespace {
std::atomic<LogHook> logHook{nullptr};
}

void setLogHook(LogHook hook) noexcept { logHook.store(hook, std::memory_order_release); }

namespace detail {

void log(LogLevel level, const char* module, const std::string& text) {
    if (LogHook hook = logHook.load(std::memory_order_acquire))
        hook(level, module, text);
    else if (level <= LogWarning)
        std::fprintf(stderr, "[%s] %s\n", module, text.c_str());
}

}  // namespace detail
}  // namespace os
}  // namespace RTT
