// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "options.hpp"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <cstring>
#include <sstream>

#include <diag/nearest_match.hpp>

#include "transports.hpp"

namespace oroforge::typekit {

namespace {

const std::vector<std::string> kLongOptions = {"--output",
                                               "--import",
                                               "--transports",
                                               "--notransports",
                                               "--verbose",
                                               "--debug",
                                               "--help",
                                               "--version",
                                               "--list-outputs",
                                               "--depfile",
                                               "--dump",
                                               "--template-dir",
                                               "--depfile-target",
                                               "--flags-from",
                                               "--include-as",
                                               "--format",
                                               "--explain",
                                               "--check",
                                               "--compile-database",
                                               "--compile-database-for",
                                               "--adapters",
                                               "--diff",
                                               "--strict",
                                               "--pieces"};

bool beginsWith(const std::string& text, const std::string& start) { return text.compare(0, start.size(), start) == 0; }

std::vector<std::string> splitList(const std::string& text) {
    std::vector<std::string> parts;
    std::istringstream stream(text);
    for (std::string part; std::getline(stream, part, ',');) {
        if (!part.empty()) parts.push_back(part);
    }
    return parts;
}

/// Quotes a word for a shell where it needs quotes.
std::string quoted(const std::string& word) {
    const bool plain = std::all_of(word.begin(), word.end(), [](unsigned char c) {
        return std::isalnum(c) != 0 || c >= 0x80 || std::strchr("_-+=./,:@%", c) != nullptr;
    });
    if (plain && !word.empty()) return word;
    std::string text = "'";
    for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return text + "'";
}

class Parser {
public:
    Parser(const std::vector<std::string>& words, diag::Sink& sink) : words_(words), sink_(sink) {}

    Options parse() {
        if (const char* target = std::getenv("OROCOS_TARGET"); target != nullptr && *target != '\0') {
            options_.target = target;
        }
        while (at_ < words_.size()) take(words_[at_++]);
        valueMissing_ = false;
        if (options_.explain) {
            finishExplain();
        } else if (options_.diff) {
            finishDiff();
        } else if (!options_.help && !options_.version) {
            finish();
        }
        return options_;
    }

private:
    void error(const std::string& message) {
        if (!valueMissing_) sink_.error({"typegen"}, "TK003", message);
    }

    void take(const std::string& word) {
        valueMissing_ = false;
        if (onlyPositional_ || word.size() < 2 || word[0] != '-') return positional(word);
        if (word == "--") {
            onlyPositional_ = true;
        } else if (!takeFlag(word) && !takeCompilerFlag(word) && !takeValued(word)) {
            error("invalid option '" + word + "'" + diag::didYouMean(word.substr(0, word.find('=')), kLongOptions));
        }
    }

    void positional(const std::string& word) {
        if (options_.name.empty()) {
            options_.name = word;
        } else {
            options_.inputs.push_back(word);
        }
    }

    bool takeFlag(const std::string& word) {
        if (word == "-h" || word == "--help") return options_.help = true;
        if (word == "--version") return options_.version = true;
        if (word == "-v" || word == "--verbose" || word == "-d" || word == "--debug") return options_.verbose = true;
        if (word == "--list-outputs") return options_.listOutputs = true;
        if (word == "--explain") return options_.explain = true;
        if (word == "--check") return options_.check = true;
        if (word == "--strict") return options_.strict = true;
        if (word == "--diff") return options_.diff = true;
        return false;
    }

    /// Takes options that change what a header means. Any other option might be mistaken for one of typegen's own.
    bool takeCompilerFlag(const std::string& word) {
        if (beginsWith(word, "-std=")) {
            options_.flags.push_back(word);
            return true;
        }
        for (const std::string option : {"-isystem", "-include", "-I", "-D", "-U"}) {
            if (!beginsWith(word, option)) continue;
            options_.flags.push_back(option);
            options_.flags.push_back(word.size() > option.size() ? word.substr(option.size()) : next(option));
            return true;
        }
        return false;
    }

    bool takeValued(const std::string& word) {
        std::string value;
        if (is(word, "-o", "--output", value)) {
            options_.output = value;
            if (value.empty()) error("empty output folder in '" + word + "', expected -o DIR");
        } else if (is(word, "-i", "--import", value)) {
            options_.imports.push_back(value);
        } else if (is(word, "-t", "--transports", value)) {
            if (!valueMissing_) wanted_ = splitList(value);
        } else if (is(word, "-n", "--notransports", value)) {
            if (valueMissing_) return true;
            for (const std::string& name : splitList(value)) unwanted_.push_back(name);
        } else if (is(word, "-p", "--compile-database", value)) {
            options_.database = value;
        } else if (is(word, "", "--compile-database-for", value)) {
            options_.databaseEntry = value;
        } else if (is(word, "", "--check", value)) {
            options_.check = true;
            options_.refresh = value;
        } else if (is(word, "", "--adapters", value)) {
            options_.adapters.push_back(value);
        } else if (is(word, "", "--depfile", value)) {
            options_.depfile = value;
        } else if (is(word, "", "--depfile-target", value)) {
            options_.depfileTarget = value;
        } else if (is(word, "", "--flags-from", value)) {
            options_.flagsFile = value;
        } else if (is(word, "", "--include-as", value)) {
            setIncludeName(value);
        } else if (is(word, "", "--pieces", value)) {
            setPieces(value);
        } else if (is(word, "", "--template-dir", value)) {
            options_.templateDir = value;
        } else if (is(word, "", "--explain", value)) {
            options_.explain = true;
            options_.codes.push_back(value);
        } else if (is(word, "", "--format", value)) {
            setFormat(value);
        } else if (is(word, "", "--dump", value)) {
            setDump(value);
        } else {
            return false;
        }
        return true;
    }

    /// Accepts "-oDIR", "-o DIR", "--output=DIR" and "--output DIR".
    bool is(const std::string& word, const std::string& brief, const std::string& full, std::string& value) {
        if (word == full || (!brief.empty() && word == brief)) {
            value = next(word);
        } else if (beginsWith(word, full + "=")) {
            value = word.substr(full.size() + 1);
        } else if (!brief.empty() && beginsWith(word, brief)) {
            value = word.substr(brief.size());
        } else {
            return false;
        }
        return true;
    }

    std::string next(const std::string& option) {
        if (at_ < words_.size()) return words_[at_++];
        error("option '" + option + "' needs a value");
        valueMissing_ = true;
        return "?";
    }

    void setIncludeName(const std::string& value) {
        const std::size_t at = value.rfind('=');
        if (at == std::string::npos || at == 0 || at + 1 == value.size()) {
            error("illegal value '" + value + "' of --include-as, expected HEADER=NAME");
        } else {
            options_.includeAs[value.substr(0, at)] = value.substr(at + 1);
        }
    }

    void setPieces(const std::string& value) {
        const std::size_t at = value.rfind('=');
        const std::string number = at == std::string::npos ? "" : value.substr(at + 1);
        const bool isNumber = !number.empty() && number.find_first_not_of("0123456789") == std::string::npos;
        const unsigned long pieces = isNumber && number.size() < 5 ? std::stoul(number) : 0;
        if (at == 0 || pieces == 0 || pieces > 1000) {
            error("illegal value '" + value + "' of --pieces, expected HEADER=NUMBER with a number from 1 to 1000");
        } else {
            options_.pieces[value.substr(0, at)] = pieces;
        }
    }

    void setDump(const std::string& value) {
        if (value == "model") {
            options_.dump = Dump::Model;
        } else if (value == "view") {
            options_.dump = Dump::View;
        } else {
            error("unknown value '" + value + "' of --dump, expected 'model' or 'view'");
        }
    }

    void setFormat(const std::string& value) {
        if (const auto format = report::formatOf(value)) {
            options_.format = *format;
        } else {
            error("unknown value '" + value + "' of --format, expected " + diag::oneOf(report::formatNames()));
        }
    }

    /// The codes are in the places of the name and the headers.
    void finishExplain() {
        if (!options_.name.empty()) options_.codes.push_back(options_.name);
        options_.codes.insert(options_.codes.end(), options_.inputs.begin(), options_.inputs.end());
        if (options_.format != report::Format::Text) error("--explain prints text, so it takes no --format");
    }

    /// With --diff both words are headers or folders: nothing is generated, so no typekit is named.
    void finishDiff() {
        if (!options_.name.empty()) options_.inputs.insert(options_.inputs.begin(), options_.name);
        if (options_.inputs.size() != 2)
            error("--diff takes two headers or folders, OLD and NEW, found " + std::to_string(options_.inputs.size()));
        for (const auto& [given, option] :
             {std::pair(options_.listOutputs, "--list-outputs"), std::pair(options_.dump != Dump::None, "--dump"),
              std::pair(!options_.depfile.empty(), "--depfile"), std::pair(options_.check, "--check"),
              std::pair(!options_.output.empty(), "--output")}) {
            if (given) error(std::string("--diff and ") + option + " exclude each other: --diff only compares");
        }
    }

    void finishCheck() {
        if (!options_.check) return;
        for (const auto& [given, option] :
             {std::pair(options_.listOutputs, "--list-outputs"), std::pair(options_.dump != Dump::None, "--dump"),
              std::pair(!options_.depfile.empty(), "--depfile")}) {
            if (given) error(std::string("--check and ") + option + " exclude each other: --check only compares");
        }
        if (!options_.refresh.empty()) return;
        options_.refresh = "to refresh: typegen";
        for (const std::string& word : words_) {
            if (word != "--check") options_.refresh += " " + quoted(word);
        }
    }

    void finish() {
        options_.transports = chooseTransports(wanted_, unwanted_, sink_);
        finishCheck();
        if (!options_.databaseEntry.empty() && options_.database.empty()) {
            error("--compile-database-for=" + options_.databaseEntry + " says which entry, but no --compile-database");
        }
        if (options_.format != report::Format::Text && (options_.listOutputs || options_.dump != Dump::None)) {
            error(std::string("--format and ") + (options_.listOutputs ? "--list-outputs" : "--dump") +
                  " exclude each other: both write to standard output");
        }
        if (options_.name.empty() || options_.inputs.empty()) {
            error("expected the name of the typekit and at least one header; see typegen --help");
            return;
        }
        const auto bad = std::find_if(options_.name.begin(), options_.name.end(), [](unsigned char c) {
            return std::isalnum(c) == 0 && c != '_' && c != '-' && c != '.';
        });
        if (bad != options_.name.end() || options_.name.find_first_not_of('.') == std::string::npos) {
            error("illegal typekit name '" + options_.name + "', expected letters, digits, '_', '-' and '.'");
        }
        if (options_.output.empty()) options_.output = "./" + options_.name;
    }

    const std::vector<std::string>& words_;
    diag::Sink& sink_;
    Options options_;
    std::vector<std::string> wanted_ = installedTransports();
    std::vector<std::string> unwanted_;
    std::size_t at_ = 0;
    bool onlyPositional_ = false;
    bool valueMissing_ = false;  // reported already; errors that follow from it are left out
};

}  // namespace

std::optional<Options> parseOptions(const std::vector<std::string>& words, diag::Sink& sink) {
    const std::size_t before = sink.errorCount();
    const Options options = Parser(words, sink).parse();
    if (sink.errorCount() != before) return std::nullopt;
    return options;
}

}  // namespace oroforge::typekit
