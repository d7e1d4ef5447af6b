// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <nlohmann/json.hpp>

#include <report/parts.hpp>
#include <report/report.hpp>

namespace oroforge::report {

namespace {

using Json = nlohmann::ordered_json;

void addPlace(const diag::Location& where, const Tool& tool, Json& to) {
    if (!isFile(where, tool)) return;
    if (!where.file.empty()) to["file"] = where.file.str();
    if (where.line != 0) to["line"] = where.line;
    if (where.column != 0) to["column"] = where.column;
}

Json fixesOf(const std::vector<diag::Fix>& fixes) {
    Json list = Json::array();
    for (const diag::Fix& fix : fixes) {
        list.push_back({{"file", fix.begin.file.str()},
                        {"line", fix.begin.line},
                        {"column", fix.begin.column},
                        {"endLine", fix.end.line},
                        {"endColumn", fix.end.column},
                        {"replacement", fix.replacement}});
    }
    return list;
}

Json itemOf(const diag::Diagnostic& diagnostic, const Tool& tool) {
    Json item;
    item["severity"] = severityName(diagnostic.severity);
    item["code"] = codeOf(diagnostic, tool);
    item["message"] = diagnostic.message;
    addPlace(diagnostic.where, tool, item);
    item["notes"] = Json::array();
    for (const diag::Note& note : diagnostic.notes) {
        if (isHint(note)) continue;
        Json entry = {{"message", note.message}};
        addPlace(note.where, tool, entry);
        if (!note.fixes.empty()) entry["fixes"] = fixesOf(note.fixes);
        item["notes"].push_back(std::move(entry));
    }
    const std::string hint = hintOf(diagnostic);
    if (!hint.empty()) item["hint"] = hint;
    item["fixes"] = fixesOf(diagnostic.fixes);
    return item;
}

}  // namespace

std::string jsonReport(const Tool& tool, const diag::Sink& sink) {
    Json document = {{"version", 1}, {"tool", tool.name}, {"toolVersion", tool.version}};
    document["diagnostics"] = Json::array();
    for (const diag::Diagnostic& diagnostic : sink.sorted())
        document["diagnostics"].push_back(itemOf(diagnostic, tool));
    return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace oroforge::report
