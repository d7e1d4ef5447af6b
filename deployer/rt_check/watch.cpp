// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Which thread is watched, on whose behalf, and what is reported of it.
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

/** What is being executed for a component; the frames are those in which it was begun. */
struct Hook {
    char component[Finding::kLongestName];  // a copy: it may destroy itself
    oroforge_rt_place place;
    bool watched;
    int depth;
    void* frames[kMaxFrames];
};

/** Those of a thread. Plain data, so that a thread costs nothing to begin or end. */
struct Hooks {
    unsigned count;
    Hook nested[kMaxNested];
};
__thread Hooks hooks __attribute__((tls_model("initial-exec")));

std::atomic<unsigned long> executions[OROFORGE_RT_PLACES];
std::atomic<unsigned long> callsLost{0};

// Its first call loads a library.
[[gnu::constructor]] void prepareBacktrace() {
    void* frame = nullptr;
    backtrace(&frame, 1);
}

/** The component's own part of the frames: without ours, and without those that lead to its hook. */
std::pair<void* const*, unsigned> ownFrames(void* const* frames, int depth, const void* caller, const Hook& hook) {
    void* const* const end = frames + depth;
    void* const* first = std::find(frames, end, caller);
    if (first == end) first = frames;
    // Both begin with what the thread began with, up to the function that executes hooks, which is in two places.
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
    if (!count({hook.component, hook.place, fault, function, own.first, own.second}))
        callsLost.fetch_add(1, std::memory_order_relaxed);
}

std::timed_mutex& textMutex() {
    static std::timed_mutex& mutex =
        *new std::timed_mutex;  // libraries are closed by destructors of static objects as well
    return mutex;
}

/** "'function()' (file+0x1234)" and "file+0x1234" are in that file. */
std::string libraryOf(const std::string& frame) {
    const std::size_t named = frame[0] == '\'' ? frame.find("' (", 1) : std::string::npos;
    const std::size_t begin = named == std::string::npos ? 0 : named + 3;
    return frame.substr(begin, frame.rfind("+0x") - begin);
}

/** The line that has the call made: what the libraries below the component's own do for it, a hundred allocations in a hundred
    places, is one finding. */
std::vector<std::string> ownPlace(const Finding& finding) {
    const std::vector<std::string> texts(finding.texts, finding.texts + finding.depth);
    const std::string library = libraryOf(texts.back());
    return {std::find_if(texts.begin(), texts.end(), [&](const auto& text) { return libraryOf(text) == library; }),
            texts.end()};
}

/** What the report says of a place, and how often that was. */
struct Row {
    const Finding* finding;  // the first one there
    std::vector<std::string> place;
    unsigned long count;

    bool isSame(const Row& other) const {
        const Finding &a = *finding, &b = *other.finding;
        return a.place == b.place && a.fault == b.fault && std::strcmp(a.component, b.component) == 0 &&
               std::strcmp(a.function, b.function) == 0 && place == other.place;
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
        if (!described || finding.isAllowed()) return;  // a thread that is still running may have made one just now
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

/** The name that a program calls it by: headers give some functions another one, as for _FORTIFY_SOURCE. */
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

/** While one exists, what this thread calls is not reported. */
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
    const int error = errno;
    const Unwatched unwatched;
    note(fault, function, caller);
    errno = error;
}

void oroforge_rt_resolve() {
    const Unwatched unwatched;
    // Whoever has it may be waiting for the loader, whose lock this thread may have: then the texts are left to that one.
    const std::unique_lock<std::timed_mutex> lock(textMutex(), std::chrono::seconds(1));
    if (lock) describeFindings();
}

void oroforge_rt_closed() {
    const Unwatched unwatched;
    static std::atomic<unsigned long long> known{0};
    unsigned long long now = 0;
    const auto countRemoved = [](dl_phdr_info* info, std::size_t, void* to) {
        *static_cast<unsigned long long*>(to) = info->dlpi_subs;
        return 1;  // it says the same for all
    };
    dl_iterate_phdr(countRemoved, &now);
    if (known.exchange(now) != now) beginAddressesAnew();
}

OROFORGE_IN_FRONT void oroforge_rt_check_begin(const char* component, oroforge_rt_place place, int real_time) {
    const Unwatched unwatched;
    // Those that are nested deeper count as the last one.
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

OROFORGE_IN_FRONT oroforge_rt_totals oroforge_rt_check_findings(oroforge_rt_visitor visit, void* to) {
    const Unwatched unwatched;
    oroforge_rt_resolve();
    for (const Row& row : sortedRows()) {
        const Finding& finding = *row.finding;
        const oroforge_rt_finding found = {finding.component, finding.place, finding.fault, plainName(finding.function),
                                           row.count,         finding.depth, finding.texts};
        visit(to, &found);
    }
    oroforge_rt_totals totals{};
    for (int place = 0; place != OROFORGE_RT_PLACES; ++place)
        totals.executions[place] = executions[place].load(std::memory_order_relaxed);
    totals.lost = callsLost.load(std::memory_order_relaxed);
    return totals;
}

}  // extern "C"
