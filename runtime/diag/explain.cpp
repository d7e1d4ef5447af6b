// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <diag/explain.hpp>

#include <diag/nearest_match.hpp>

#include <algorithm>
#include <cctype>
#include <ostream>

namespace oroforge::diag {
namespace {

std::string upperCase(std::string text) {
    for (char& letter : text) letter = static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
    return text;
}

}  // namespace

std::string Explanation::firstParagraph() const {
    std::string paragraph = text.substr(0, text.find("\n\n"));
    while (!paragraph.empty() && paragraph.back() == '\n') paragraph.pop_back();
    std::replace(paragraph.begin(), paragraph.end(), '\n', ' ');
    return paragraph;
}

Explanations::Explanations(const EmbeddedFiles& files) {
    for (const EmbeddedFile& file : files) {
        const std::string text(file.text);
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::size_t body = std::min(text.find_first_not_of('\n', end), text.size());
        all_.push_back({std::string(file.name), text.substr(0, end), text.substr(body)});
    }
    std::sort(all_.begin(), all_.end(), [](const Explanation& a, const Explanation& b) { return a.code < b.code; });
}

const Explanation* Explanations::of(const std::string& code) const {
    const std::string wanted = upperCase(code);
    for (const Explanation& explanation : all_)
        if (explanation.code == wanted) return &explanation;
    return nullptr;
}

void Explanations::print(const std::vector<std::string>& codes, const Explainer& program, std::ostream& out,
                         Sink& sink) const {
    std::vector<std::string> known;
    for (const Explanation& explanation : all_) {
        known.push_back(explanation.code);
        if (codes.empty()) out << explanation.code << "  " << explanation.title << "\n";
    }
    bool first = true;
    for (const std::string& code : codes) {
        const Explanation* explanation = of(code);
        if (explanation == nullptr) {
            sink.error({program.name}, program.badOption,
                       "no diagnostic has the code '" + code + "'" + didYouMean(code, known))
                .hint(program.name + " --explain lists all codes");
            continue;
        }
        out << (first ? "" : "\n") << explanation->code << ": " << explanation->title << "\n\n" << explanation->text;
        first = false;
    }
}

}  // namespace oroforge::diag
