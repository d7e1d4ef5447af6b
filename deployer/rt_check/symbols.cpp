// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "symbols.hpp"

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <cxxabi.h>
#include <dlfcn.h>
#include <sstream>
#include <string>

namespace oroforge::rt_check {

char* describeFrame(void* returnAddress) {
    // An address within the call: after it, the next line or function may begin.
    char* const address = static_cast<char*>(returnAddress) - 1;
    std::ostringstream text;
    Dl_info info{};
    if (dladdr(address, &info) == 0) {
        text << returnAddress;
        return strdup(text.str().c_str());
    }
    if (info.dli_sname) {
        int status = -1;
        char* const name = abi::__cxa_demangle(info.dli_sname, nullptr, nullptr, &status);
        text << "'" << (status == 0 ? name : info.dli_sname) << "' ";
        std::free(name);
    }
    const auto offset = static_cast<std::uintptr_t>(address - static_cast<char*>(info.dli_fbase));
    text << (info.dli_sname ? "(" : "") << info.dli_fname << "+0x" << std::hex << offset << (info.dli_sname ? ")" : "");
    return strdup(text.str().c_str());
}

bool isMemoryPoolFunction(const char* frame) noexcept {
    return std::strncmp(frame, "'RTT::os::detail::MemoryPool::", 30) == 0;
}

}  // namespace oroforge::rt_check
