// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/execute/failed_call.hpp>

#include <rtt/internal/diagnostic_taker.hpp>
#include <rtt/internal/located_log.hpp>

#include <diag/print.hpp>

#include <map>
#include <sstream>

namespace RTT::scripting::detail {

namespace diag = oroforge::diag;

namespace {

typedef std::vector<std::string> Lines;

void put(Lines& lines, unsigned number, const std::string& line) {
    if (number == 0 || line.empty()) return;
    if (lines.size() < number) lines.resize(number);
    lines[number - 1] = line;
}

std::string joined(const Lines& lines) {
    std::string text;
    for (const std::string& line : lines) text += line + '\n';
    return text;
}

}  // namespace

std::string lineOf(const std::string& text, unsigned line) {
    std::istringstream in(text);
    std::string found;
    while (line-- != 0 && std::getline(in, found)) {
    }
    return found;
}

void logFailure(diag::Severity severity, const CallPlace& place, const std::string& reasons) {
    diag::Sink sink;
    if (severity == diag::Severity::Error)
        sink.error(place.where, "OPS420", reasons);
    else
        sink.warning(place.where, "OPS420", reasons);
    if (internal::takeDiagnostics(sink)) return;
    diag::SourceCache sources;
    sources.add(place.where.file, place.line.empty() ? "" : std::string(place.where.line - 1, '\n') + place.line);
    std::ostringstream text;
    diag::print(text, sink, sources);
    std::string line = text.str();
    line.pop_back();  // its last end of line
    internal::logLocated(Error, line);
}

void FailedCall::passes(CallPlace here) {
    if (left_.empty()) return;
    calls_.push_back({std::move(here), std::move(left_)});
    left_.clear();
}

void FailedCall::isFrom(const diag::FileName& file, const std::string& text) {
    for (Call& call : calls_) {
        if (!call.place.where.file.empty()) continue;
        call.place.where.file = file;
        call.place.line = lineOf(text, call.place.where.line);
    }
}

void FailedCall::report(diag::Sink& sink, const diag::Location& where, const std::string& whole) const {
    diag::Diagnostic& error =
        sink.error(place_.where, "OPS400", (whole.empty() ? whole : whole + " failed: ") + what());
    for (const Call& call : calls_) {
        diag::Location at = call.place.where;
        if (at.file.empty()) at.file = where.file;
        error.note(at, call.what);
    }
    const bool isThere = place_.where.file == where.file && place_.where.line == where.line;
    if (calls_.empty() && !isThere) error.note(where, "in this statement");
}

void FailedCall::addLines(diag::SourceCache& sources, const std::string& file, const std::string& text) const {
    std::map<std::string, Lines> files;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) files[file].push_back(line);
    const auto add = [&](const CallPlace& place) {
        put(files[place.where.file.empty() ? file : place.where.file.str()], place.where.line, place.line);
    };
    add(place_);
    for (const Call& call : calls_) add(call.place);
    for (const auto& [name, lines] : files) sources.add(name, joined(lines));
}

}  // namespace RTT::scripting::detail
