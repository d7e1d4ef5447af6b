// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Watches threads on behalf of components, and reports the findings.
#include "findings.hpp"
#include "in_front.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <execinfo.h>
#include <link.h>
#include <mutex>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

__thread int oroforge_rt_watched = 0;
__thread int oroforge_rt_inside = 0;

namespace oroforge::rt_check {
namespace {

constexpr int kMaxFrames = 64;
constexpr unsigned kMaxNested = 8;

/** Code that is executed for a component, with the frames in which it began. */
struct Hook {
    char component[Finding::kLongestName];  // a copy, because the component may destroy itself
    oroforge_rt_place place;
    bool watched;
    int depth;
    void* frames[kMaxFrames];
};

/** The hooks of a thread. Plain data, so that begin and end of a thread cost nothing. */
struct Hooks {
    unsigned count;
    Hook nested[kMaxNested];
};
__thread Hooks hooks __attribute__((tls_model("initial-exec")));

std::atomic<unsigned long> executions[OROFORGE_RT_PLACES];
std::atomic<unsigned long> callsLost{0};
std::atomic<unsigned> counted{(1U << OROFORGE_RT_CLOCK) - 1};
std::atomic<oroforge_rt_script> scripts{nullptr};

// The first call of backtrace() loads a library.
[[gnu::constructor]] void prepareBacktrace() {
    void* frame = nullptr;
    backtrace(&frame, 1);
}

/** The component's own frames, without those of this library and those that lead to its hook. */
std::pair<void* const*, unsigned> ownFrames(void* const* frames, int depth, const void* caller, const Hook& hook) {
    void* const* const end = frames + depth;
    void* const* first = std::find(frames, end, caller);
    if (first == end) first = frames;
    // Both end with the outermost frames of the thread, up to the function that executes hooks, which is at two places.
    int common = 0;
    while (common < depth && common < hook.depth && end[-1 - common] == hook.frames[hook.depth - 1 - common]) ++common;
    void* const* last = end - (common != 0 ? common + 1 : 0);
    if (last <= first) last = std::min(first + 1, end);
    return {first, static_cast<unsigned>(last - first)};
}

void note(oroforge_rt_fault fault, const char* function, const void* caller) {
    const Hook& hook = hooks.nested[std::min(hooks.count, kMaxNested) - 1];
    void* frames[kMaxFrames];
    const int depth = backtrace(frames, kMaxFrames);
    const auto own = ownFrames(frames, depth, caller, hook);
    char script[Finding::kLongestScript] = {};
    if (const oroforge_rt_script describe = scripts.load(std::memory_order_acquire)) describe(script, sizeof script);
    if (!count({hook.component, hook.place, fault, function, own.first, own.second, script}))
        callsLost.fetch_add(1, std::memory_order_relaxed);
}

std::timed_mutex& textMutex() {
    static std::timed_mutex& mutex =
        *new std::timed_mutex;  // never destroyed, because destructors of static objects may close libraries
    return mutex;
}

/** The file in "'function()' (file+0x1234)" or "file+0x1234". */
std::string libraryOf(const std::string& frame) {
    const std::size_t named = frame[0] == '\'' ? frame.find("' (", 1) : std::string::npos;
    const std::size_t begin = named == std::string::npos ? 0 : named + 3;
    return frame.substr(begin, frame.rfind("+0x") - begin);
}

/** The frame in the component's own library that leads to the call, so that a hundred allocations in the libraries
    below are one finding. */
std::vector<std::string> ownPlace(const Finding& finding) {
    const std::vector<std::string> texts(finding.texts, finding.texts + finding.depth);
    const std::string library = libraryOf(texts.back());
    return {std::find_if(texts.begin(), texts.end(), [&](const auto& text) { return libraryOf(text) == library; }),
            texts.end()};
}

/** A row of the report: a place and the number of calls. */
struct Row {
    const Finding* finding;  // the first one at the place
    std::vector<std::string> place;
    unsigned long count;

    bool isSame(const Row& other) const {
        const Finding &a = *finding, &b = *other.finding;
        return a.place == b.place && a.fault == b.fault && std::strcmp(a.component, b.component) == 0 &&
               std::strcmp(a.function, b.function) == 0 && std::strcmp(a.script, b.script) == 0 && place == other.place;
    }
    void add(const Row& other) {
        count += other.count;
        if (other.finding->number < finding->number) finding = other.finding;
    }
    auto key() const {
        return std::make_tuple(std::string(finding->component), int(finding->place), int(finding->fault), ~count,
                               std::string(finding->function), place);
    }
};

std::vector<Row> sortedRows() {
    std::vector<Row> rows;
    forEachFinding([&rows](const Finding& finding) {
        const bool described = finding.depth != 0 && finding.texts[finding.depth - 1];
        if (!described || finding.isAllowed()) return;  // a running thread may have just made it
        const Row row = {&finding, ownPlace(finding), finding.count.load(std::memory_order_relaxed)};
        const auto same = std::find_if(rows.begin(), rows.end(), [&](const Row& known) { return known.isSame(row); });
        if (same != rows.end())
            same->add(row);
        else
            rows.push_back(row);
    });
    std::sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) { return a.key() < b.key(); });
    return rows;
}

/** The name in the source: headers give some functions another one, for example with _FORTIFY_SOURCE. */
const char* plainName(std::string name) {
    const auto drop = [&name](const std::string& suffix) {
        if (name.size() > suffix.size() && name.compare(name.size() - suffix.size(), suffix.size(), suffix) == 0)
            name.resize(name.size() - suffix.size());
    };
    if (name.compare(0, 2, "__") == 0) {
        name.erase(0, name.compare(0, 9, "__isoc99_") == 0 ? 9 : 2);
        drop("_chk");
        drop("_2");
    }
    static std::set<std::string>& names = *new std::set<std::string>;
    return names.insert(name).first->c_str();
}

/** While it exists, calls of this thread are not reported. */
class Unwatched {
public:
    Unwatched() { ++oroforge_rt_inside; }
    ~Unwatched() { --oroforge_rt_inside; }
    Unwatched(const Unwatched&) = delete;
    Unwatched& operator=(const Unwatched&) = delete;
};

}  // namespace
}  // namespace oroforge::rt_check

using namespace oroforge::rt_check;

extern "C" {

void oroforge_rt_note(oroforge_rt_fault fault, const char* function, const void* caller) {
    if (!(counted.load(std::memory_order_relaxed) & 1U << fault)) return;
    const int error = errno;
    const Unwatched unwatched;
    note(fault, function, caller);
    errno = error;
}

void oroforge_rt_resolve() {
    const Unwatched unwatched;
    // The thread that has it may wait for the loader, whose lock this thread may have. Then that thread makes the
    // texts.
    const std::unique_lock<std::timed_mutex> lock(textMutex(), std::chrono::seconds(1));
    if (lock) describeFindings();
}

void oroforge_rt_closed() {
    const Unwatched unwatched;
    static std::atomic<unsigned long long> known{0};
    unsigned long long now = 0;
    const auto countRemoved = [](dl_phdr_info* info, std::size_t, void* to) {
        *static_cast<unsigned long long*>(to) = info->dlpi_subs;
        return 1;  // all entries have the same number
    };
    dl_iterate_phdr(countRemoved, &now);
    if (known.exchange(now) != now) beginAddressesAnew();
}

OROFORGE_IN_FRONT void oroforge_rt_check_begin(const char* component, oroforge_rt_place place, int real_time) {
    const Unwatched unwatched;
    // Hooks nested deeper count as the last one.
    if (hooks.count++ < kMaxNested) {
        Hook& hook = hooks.nested[hooks.count - 1];
        std::strncpy(hook.component, component, Finding::kLongestName - 1);
        hook.place = place;
        hook.watched = real_time != 0 || oroforge_rt_watched != 0;
        hook.depth = hook.watched ? backtrace(hook.frames, kMaxFrames) : 0;
    }
    if (!hooks.nested[std::min(hooks.count, kMaxNested) - 1].watched) return;
    executions[place].fetch_add(1, std::memory_order_relaxed);
    ++oroforge_rt_watched;
}

OROFORGE_IN_FRONT void oroforge_rt_check_end() {
    const unsigned ended = std::min(--hooks.count, kMaxNested - 1);
    if (hooks.nested[ended].watched) --oroforge_rt_watched;
}

OROFORGE_IN_FRONT void oroforge_rt_check_only(unsigned faults) { counted.store(faults, std::memory_order_relaxed); }

OROFORGE_IN_FRONT void oroforge_rt_check_scripts(oroforge_rt_script describe) {
    scripts.store(describe, std::memory_order_release);
}

OROFORGE_IN_FRONT oroforge_rt_totals oroforge_rt_check_findings(oroforge_rt_visitor visit, void* to) {
    const Unwatched unwatched;
    oroforge_rt_resolve();
    for (const Row& row : sortedRows()) {
        const Finding& finding = *row.finding;
        const oroforge_rt_finding found = {finding.component, finding.place, finding.fault, plainName(finding.function),
                                           row.count,         finding.depth, finding.texts, finding.script};
        visit(to, &found);
    }
    oroforge_rt_totals totals{};
    for (int place = 0; place != OROFORGE_RT_PLACES; ++place)
        totals.executions[place] = executions[place].load(std::memory_order_relaxed);
    totals.lost = callsLost.load(std::memory_order_relaxed);
    return totals;
}

}  // extern "C"
