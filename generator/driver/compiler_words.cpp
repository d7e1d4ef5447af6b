// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <driver/compiler_words.hpp>

namespace oroforge::driver {

std::vector<std::string> takeCompilerWords(std::vector<std::string>& words) {
    std::vector<std::string> taken, left;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string& word = words[i];
        if (word == "--") {
            left.insert(left.end(), words.begin() + static_cast<std::ptrdiff_t>(i), words.end());
            break;
        }
        if (word.compare(0, 5, "-std=") == 0) {
            taken.push_back(word);
            continue;
        }
        std::string found;
        for (const std::string option : {"-isystem", "-include", "-I", "-D", "-U"}) {
            if (found.empty() && word.compare(0, option.size(), option) == 0) found = option;
        }
        const bool together = word.size() > found.size();
        if (found.empty() || (!together && i + 1 == words.size())) {
            left.push_back(word);
            continue;
        }
        taken.push_back(found);
        taken.push_back(together ? word.substr(found.size()) : words[++i]);
    }
    words = left;
    return taken;
}

}  // namespace oroforge::driver
