// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <diff/tell_changes.hpp>

#include <algorithm>

namespace oroforge::typekit {

namespace {

std::string counted(std::size_t count) { return std::to_string(count) + (count == 1 ? " change" : " changes"); }

}  // namespace

void tellChanges(const std::vector<Change>& changes, diag::Sink& sink) {
    for (const Change& change : changes) {
        if (!change.breaking) {
            sink.note(change.where, change.message);
            continue;
        }
        auto& error = sink.error(change.where, "TK064", change.message);
        if (change.was.line != 0) error.note(change.was, "the old version is here");
    }
}

std::string verdict(const std::vector<Change>& changes) {
    const auto breaking = static_cast<std::size_t>(
        std::count_if(changes.begin(), changes.end(), [](const Change& change) { return change.breaking; }));
    if (changes.empty()) return "compatible: no change";
    if (breaking == 0) return "compatible: " + counted(changes.size());
    return "breaking: " + counted(breaking) + (breaking == 1 ? " breaks" : " break") + ", " +
           std::to_string(changes.size() - breaking) + " would not";
}

}  // namespace oroforge::typekit
