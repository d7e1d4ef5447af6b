// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <diag/sink.hpp>

#include <algorithm>
#include <utility>

namespace oroforge::diag {

namespace {

bool sameReport(const Diagnostic& a, const Diagnostic& b) {
    return a.severity == b.severity && a.code == b.code && a.where == b.where && a.message == b.message;
}

Diagnostic make(Severity severity, Location&& where, std::string&& code, std::string&& message) {
    return Diagnostic{severity, std::move(code), std::move(where), std::move(message), {}, {}};
}

/// "3 more errors and 2 more warnings"; empty if all are kept.
std::string notKept(std::size_t errors, std::size_t warnings) {
    std::string text;
    if (errors > Sink::kMost) text = std::to_string(errors - Sink::kMost) + " more errors";
    if (warnings <= Sink::kMost) return text;
    if (!text.empty()) text += " and ";
    return text + std::to_string(warnings - Sink::kMost) + " more warnings";
}

}  // namespace

Diagnostic& Sink::error(Location where, std::string code, std::string message) {
    return add(make(Severity::Error, std::move(where), std::move(code), std::move(message)));
}

Diagnostic& Sink::warning(Location where, std::string code, std::string message) {
    return add(make(Severity::Warning, std::move(where), std::move(code), std::move(message)));
}

Diagnostic& Sink::note(Location where, std::string message) {
    return add(make(Severity::Note, std::move(where), {}, std::move(message)));
}

Diagnostic& Sink::add(Diagnostic diagnostic) {
    const bool isError = diagnostic.severity == Severity::Error, isWarning = diagnostic.severity == Severity::Warning;
    errors_ += isError;
    warnings_ += isWarning;
    if ((isError && errors_ > kMost) || (isWarning && warnings_ > kMost)) return unkept_ = std::move(diagnostic);
    all_.push_back(std::move(diagnostic));
    return all_.back();
}

std::vector<Diagnostic> Sink::sorted() const {
    std::vector<Diagnostic> all = all_;
    std::stable_sort(all.begin(), all.end(),
                     [](const Diagnostic& a, const Diagnostic& b) { return a.where < b.where; });
    std::vector<Diagnostic> result;
    std::size_t samePlace = 0;  // where the reports on the present place begin; only they can be repeats
    for (Diagnostic& candidate : all) {
        if (!result.empty() && result.back().where != candidate.where) samePlace = result.size();
        const bool known = std::any_of(result.begin() + static_cast<std::ptrdiff_t>(samePlace), result.end(),
                                       [&](const Diagnostic& other) { return sameReport(candidate, other); });
        if (!known) result.push_back(std::move(candidate));
    }
    if (const std::string rest = notKept(errors_, warnings_); !rest.empty())
        result.push_back(make(Severity::Note, {}, {}, rest + " are not shown"));
    return result;
}

}  // namespace oroforge::diag
