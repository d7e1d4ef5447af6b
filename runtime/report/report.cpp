// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <report/report.hpp>

#include <ostream>

#include <diag/print.hpp>

namespace oroforge::report {

const std::vector<std::string>& formatNames() {
    static const std::vector<std::string> names = {"text", "json", "sarif"};
    return names;
}

std::optional<Format> formatOf(const std::string& name) {
    if (name == "text") return Format::Text;
    if (name == "json") return Format::Json;
    if (name == "sarif") return Format::Sarif;
    return std::nullopt;
}

Format wantedFormat(const std::vector<std::string>& words) {
    const std::string option = "--format";
    Format wanted = Format::Text;
    for (std::size_t i = 0; i < words.size() && words[i] != "--"; ++i) {
        std::optional<Format> found;
        if (words[i] == option && i + 1 < words.size()) found = formatOf(words[i + 1]);
        if (words[i].compare(0, option.size() + 1, option + "=") == 0) {
            found = formatOf(words[i].substr(option.size() + 1));
        }
        wanted = found.value_or(wanted);
    }
    return wanted;
}

bool write(Format format, const Tool& tool, const diag::Sink& sink, std::ostream& out, std::ostream& err) {
    if (format == Format::Text) {
        diag::print(err, sink);
        return true;
    }
    out << (format == Format::Json ? jsonReport(tool, sink) : sarifReport(tool, sink)) << std::flush;
    return static_cast<bool>(out);
}

}  // namespace oroforge::report
