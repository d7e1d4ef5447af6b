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
    errors_ += diagnostic.severity == Severity::Error;
    warnings_ += diagnostic.severity == Severity::Warning;
    all_.push_back(std::move(diagnostic));
    return all_.back();
}

std::vector<Diagnostic> Sink::sorted() const {
    std::vector<Diagnostic> all = all_;
    std::stable_sort(all.begin(), all.end(),
                     [](const Diagnostic& a, const Diagnostic& b) { return a.where < b.where; });
    std::vector<Diagnostic> result;
    std::size_t samePlace = 0;  // where the reports on the present place begin, which are all that may be repeats
    for (Diagnostic& candidate : all) {
        if (!result.empty() && result.back().where != candidate.where) samePlace = result.size();
        const bool known = std::any_of(result.begin() + static_cast<std::ptrdiff_t>(samePlace), result.end(),
                                       [&](const Diagnostic& other) { return sameReport(candidate, other); });
        if (!known) result.push_back(std::move(candidate));
    }
    return result;
}

}  // namespace oroforge::diag
