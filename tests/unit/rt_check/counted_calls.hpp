// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What --rt-check counts of a call. The program links its library, so that its functions come before libc's.
#ifndef OROFORGE_TESTS_RT_CHECK_COUNTED_CALLS_HPP
#define OROFORGE_TESTS_RT_CHECK_COUNTED_CALLS_HPP

#include <rt_check/interface.h>

#include <functional>
#include <map>
#include <string>

namespace rt_check_test {

using Counts = std::map<std::string, unsigned long>;

/** What was counted so far: "RTC001 malloc". */
inline Counts counts() {
    Counts result;
    oroforge_rt_check_findings(
        [](void* to, const oroforge_rt_finding* finding) {
            (*static_cast<Counts*>(to))["RTC00" + std::to_string(finding->fault) + " " + finding->function] +=
                finding->count;
        },
        &result);
    return result;
}

/** What is counted of a watched call, each with how often: "RTC001 malloc 1, RTC002 free 1". */
inline std::string counted(const std::function<void()>& call, int realTime = 1) {
    const Counts before = counts();
    oroforge_rt_check_begin("c", OROFORGE_RT_UPDATE, realTime);
    call();
    oroforge_rt_check_end();
    std::string text;
    for (const auto& [name, count] : counts()) {
        const auto was = before.find(name);
        const unsigned long more = count - (was == before.end() ? 0 : was->second);
        if (more != 0) text += (text.empty() ? "" : ", ") + name + " " + std::to_string(more);
    }
    return text;
}

}  // namespace rt_check_test

#endif
