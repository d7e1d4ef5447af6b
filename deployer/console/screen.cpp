// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "screen.hpp"

#include <diag/print.hpp>

#include <cctype>
#include <utility>

namespace OCL::console {
namespace {

bool isBlank(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

}  // namespace

Input::Input(std::string where, unsigned number, std::string typed)
    : name(std::move(where)), line(number), text(std::move(typed)) {
    for (std::size_t at = 0; at < text.size();) {
        if (isBlank(text[at])) {
            ++at;
            continue;
        }
        const std::size_t begin = at;
        while (at < text.size() && !isBlank(text[at])) ++at;
        words.push_back({text.substr(begin, at - begin), begin});
    }
}

std::string Input::from(std::size_t index) const {
    if (index >= words.size()) return {};
    return text.substr(words[index].begin, words.back().begin + words.back().text.size() - words[index].begin);
}

void complain(Screen& screen, const Input& input, std::size_t at, const std::string& message) {
    namespace diag = oroforge::diag;
    screen.failed = true;
    diag::Sink sink;
    sink.error({input.name, input.line, static_cast<unsigned>(at) + 1}, "", message);
    diag::SourceCache sources;
    sources.add(input.name, std::string(input.line - 1, '\n') + input.text);
    diag::print(screen.err, sink, sources);
}

}  // namespace OCL::console
