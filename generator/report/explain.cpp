// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <report/explain.hpp>

#include <algorithm>
#include <cctype>
#include <ostream>

#include <diag/nearest_match.hpp>
#include <render/embedded.hpp>

namespace oroforge::render {
EmbeddedFiles explanationFiles();
}

namespace oroforge::report {

namespace {

std::vector<Explanation> readAll() {
    std::vector<Explanation> all;
    for (const render::EmbeddedFile& file : render::explanationFiles()) {
        const std::string text(file.text);
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::size_t body = std::min(text.find_first_not_of('\n', end), text.size());
        all.push_back({std::string(file.name), text.substr(0, end), text.substr(body)});
    }
    std::sort(all.begin(), all.end(), [](const Explanation& a, const Explanation& b) { return a.code < b.code; });
    return all;
}

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

const std::vector<Explanation>& explanations() {
    static const std::vector<Explanation> all = readAll();
    return all;
}

const Explanation* explanationOf(const std::string& code) {
    const std::string wanted = upperCase(code);
    for (const Explanation& explanation : explanations()) {
        if (explanation.code == wanted) return &explanation;
    }
    return nullptr;
}

void explain(const std::vector<std::string>& codes, const Explainer& program, std::ostream& out, diag::Sink& sink) {
    std::vector<std::string> known;
    for (const Explanation& explanation : explanations()) {
        known.push_back(explanation.code);
        if (codes.empty()) out << explanation.code << "  " << explanation.title << "\n";
    }
    bool first = true;
    for (const std::string& code : codes) {
        const Explanation* explanation = explanationOf(code);
        if (explanation == nullptr) {
            sink.error({program.name}, program.badOption,
                       "no diagnostic has the code '" + code + "'" + diag::didYouMean(code, known))
                .hint(program.name + " --explain lists all codes");
            continue;
        }
        out << (first ? "" : "\n") << explanation->code << ": " << explanation->title << "\n\n" << explanation->text;
        first = false;
    }
}

}  // namespace oroforge::report
