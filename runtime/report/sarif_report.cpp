// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <algorithm>

#include <nlohmann/json.hpp>

#include <report/parts.hpp>
#include <report/report.hpp>

namespace oroforge::report {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kSchema =
    "https://docs.oasis-open.org/sarif/sarif/v2.1.0/errata01/os/schemas/sarif-schema-2.1.0.json";

Json textOf(const std::string& text) { return {{"text", text}}; }

Json artifact(const diag::Location& where) { return {{"uri", uriOf(where.file)}}; }

class Writer {
public:
    explicit Writer(const Tool& tool) : tool_(tool) {}

    Json document(const diag::Sink& sink) {
        Json results = Json::array();
        for (const diag::Diagnostic& diagnostic : sink.sorted()) results.push_back(resultOf(diagnostic));
        Json driver = {{"name", tool_.name}, {"version", tool_.version}, {"rules", std::move(rules_)}};
        Json run;
        run["tool"]["driver"] = std::move(driver);
        const int status = tool_.exitStatus.value_or(sink.hadErrors() ? 1 : 0);
        run["invocations"] = Json::array({{{"executionSuccessful", status == 0}, {"exitCode", status}}});
        run["columnKind"] = "unicodeCodePoints";
        run["results"] = std::move(results);
        return {{"$schema", kSchema}, {"version", "2.1.0"}, {"runs", Json::array({run})}};
    }

private:
    /// The index of the rule for a code; rules are listed in the order in which results first need them.
    std::size_t ruleIndex(const std::string& code) {
        const auto known =
            std::find_if(rules_.begin(), rules_.end(), [&](const Json& rule) { return rule["id"] == code; });
        if (known != rules_.end()) return static_cast<std::size_t>(known - rules_.begin());
        Json rule = {{"id", code}};
        if (const diag::Explanation* explanation = tool_.codes ? tool_.codes->of(code) : nullptr) {
            rule["shortDescription"] = textOf(explanation->title);
            rule["fullDescription"] = textOf(explanation->firstParagraph());
            rule["help"] = textOf(explanation->text);
        } else if (code == kCompilerCode) {
            rule["shortDescription"] = textOf("an error that the compiler reports");
        } else if (code == tool_.unnamed) {
            rule["shortDescription"] = textOf("what " + tool_.name + " reports without a code");
        }
        rules_.push_back(std::move(rule));
        return rules_.size() - 1;
    }

    Json resultOf(const diag::Diagnostic& diagnostic) {
        const std::string code = codeOf(diagnostic, tool_), hint = hintOf(diagnostic);
        Json result = {{"ruleId", code}, {"ruleIndex", ruleIndex(code)}, {"level", severityName(diagnostic.severity)}};
        result["message"] = textOf(hint.empty() ? diagnostic.message : diagnostic.message + "\n" + hint);
        if (isFile(diagnostic.where, tool_)) result["locations"] = Json::array({locationOf(diagnostic.where)});
        Json related = Json::array(), fixes = Json::array();
        if (!diagnostic.fixes.empty()) fixes.push_back(fixOf(hint, diagnostic.fixes));
        for (const diag::Note& note : diagnostic.notes) {
            if (isHint(note)) continue;
            Json location = {{"id", related.size()}};
            if (isFile(note.where, tool_)) location.update(locationOf(note.where));
            location["message"] = textOf(note.message);
            related.push_back(std::move(location));
            if (!note.fixes.empty()) fixes.push_back(fixOf(note.message, note.fixes));
        }
        if (!related.empty()) result["relatedLocations"] = std::move(related);
        if (!fixes.empty()) result["fixes"] = std::move(fixes);
        return result;
    }

    Json locationOf(const diag::Location& where) {
        Json place = {{"artifactLocation", artifact(where)}};
        if (where.line != 0) {
            place["region"]["startLine"] = where.line;
            if (where.column != 0) place["region"]["startColumn"] = characterColumn(where, sources_);
        }
        return {{"physicalLocation", std::move(place)}};
    }

    /// One proposal: changes that belong together, file by file.
    Json fixOf(const std::string& description, const std::vector<diag::Fix>& fixes) {
        Json changes = Json::array();
        std::vector<std::string> files;
        for (const diag::Fix& fix : fixes) {
            std::size_t at = std::find(files.begin(), files.end(), fix.begin.file.str()) - files.begin();
            if (at == files.size()) {
                files.push_back(fix.begin.file);
                changes.push_back({{"artifactLocation", artifact(fix.begin)}, {"replacements", Json::array()}});
            }
            Json replacement;
            replacement["deletedRegion"] = {{"startLine", fix.begin.line},
                                            {"startColumn", characterColumn(fix.begin, sources_)},
                                            {"endLine", fix.end.line},
                                            {"endColumn", characterColumn(fix.end, sources_)}};
            if (!fix.replacement.empty()) replacement["insertedContent"] = textOf(fix.replacement);
            changes[at]["replacements"].push_back(std::move(replacement));
        }
        Json result;
        if (!description.empty()) result["description"] = textOf(description);
        result["artifactChanges"] = std::move(changes);
        return result;
    }

    const Tool& tool_;
    Json rules_ = Json::array();
    diag::SourceCache sources_;
};

}  // namespace

std::string sarifReport(const Tool& tool, const diag::Sink& sink) {
    return Writer(tool).document(sink).dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace oroforge::report
