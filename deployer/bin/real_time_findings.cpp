// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "real_time_findings.hpp"

#include <algorithm>
#include <cstring>
#include <map>
#include <tuple>
#include <utility>

namespace OCL::deploy {
namespace {

namespace diag = oroforge::diag;

bool contains(const std::string& text, const char* part) { return text.find(part) != std::string::npos; }

bool begins(const std::string& text, const char* part) { return text.compare(0, std::strlen(part), part) == 0; }

/** True for a frame in the standard library of C++ or C, or in a template of its headers. */
bool isStandard(const diag::Note& frame) {
    if (contains(frame.where.file.str(), "/include/c++/")) return true;
    for (const char* const library : {"/libstdc++.so", "/libc++.so", "/libc.so", "/libm.so", "/libgcc_s.so"})
        if (contains(frame.message, library)) return true;
    for (const char* const name : {"'std::", "'__gnu_cxx::", "'operator new", "'operator delete", "'void std::"})
        if (begins(frame.message, name)) return true;
    return false;
}

bool isRuntime(const diag::Note& frame) {
    return contains(frame.where.file.str(), "/rtt/") || contains(frame.message, "/liborocos-") ||
           contains(frame.message, "/boost/");
}

/** The innermost line that is neither in the standard library nor in the runtime; otherwise the outermost line. */
diag::Location lineOfUser(const std::vector<diag::Note>& frames) {
    diag::Location outermost;
    for (const diag::Note& frame : frames) {
        if (frame.where.line == 0 || isStandard(frame)) continue;
        if (!isRuntime(frame)) return frame.where;
        outermost = frame.where;
    }
    return outermost;
}

std::string times(unsigned long count) { return std::to_string(count) + (count == 1 ? " time" : " times"); }

void addFrames(diag::Diagnostic& to, const std::vector<diag::Note>& frames) {
    for (auto frame = frames.begin(); frame != frames.end();) {
        const auto end = std::find_if_not(frame, frames.end(), isStandard);
        const auto folded = std::distance(frame, end);
        if (folded > 1) {
            to.hint("called by " + std::to_string(folded) + " functions of the standard library");
            frame = end;
            continue;
        }
        to.note(frame->where, "called by " + frame->message);
        ++frame;
    }
}

/** Findings at one line in one kind of step of a component, or a single one without a line. */
struct Group {
    diag::Location where;
    std::vector<RealTimeFinding> parts;  // all with different codes or functions
};

void join(Group& group, const RealTimeFinding& finding) {
    for (RealTimeFinding& known : group.parts) {
        if (known.code != finding.code || known.function != finding.function) continue;
        known.count += finding.count;
        return;
    }
    group.parts.push_back(finding);
}

diag::Diagnostic diagnosticOf(const Group& group) {
    const RealTimeFinding& first = group.parts.front();
    diag::Diagnostic result;
    result.code = first.code;
    result.where = group.where;
    result.message = "component '" + first.component + "' " + first.verb + " in " + first.where + ": " +
                     first.function + "(), " + times(first.count);
    for (std::size_t i = 1; i != group.parts.size(); ++i) {
        const RealTimeFinding& other = group.parts[i];
        result.hint("[" + other.code + "] this line also " + other.verb + ": " + other.function + "(), " +
                    times(other.count));
    }
    addFrames(result, first.frames);
    return result;
}

}  // namespace

std::vector<diag::Diagnostic> arranged(const std::vector<RealTimeFinding>& findings) {
    std::vector<Group> groups;
    std::map<std::tuple<std::string, std::string, std::string, unsigned>, std::size_t> byLine;
    for (const RealTimeFinding& finding : findings) {
        const diag::Location where = finding.script.line != 0 ? finding.script : lineOfUser(finding.frames);
        std::size_t at = groups.size();
        if (where.line != 0)
            at = byLine.emplace(std::make_tuple(finding.component, finding.where, where.file.str(), where.line), at)
                     .first->second;
        if (at == groups.size()) groups.push_back({where, {}});
        join(groups[at], finding);
    }
    std::vector<diag::Diagnostic> result;
    for (const Group& group : groups) result.push_back(diagnosticOf(group));
    return result;
}

bool isOfRuntime(const RealTimeFinding& finding) {
    const auto first = std::find_if_not(finding.frames.begin(), finding.frames.end(), isStandard);
    return first != finding.frames.end() && isRuntime(*first);
}

bool lacksLines(const diag::Diagnostic& finding) { return finding.where.line == 0; }

}  // namespace OCL::deploy
