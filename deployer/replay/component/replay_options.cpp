// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "replay_options.hpp"

#include <diag/nearest_match.hpp>

#include <algorithm>
#include <fnmatch.h>
#include <sstream>

namespace OCL::replay {
namespace {

constexpr double kFastest = 1e6;
constexpr const char* kWrongProperty = "MCP027";

std::string wrong(const std::string& property, double found, const std::string& expected) {
    std::ostringstream text;
    text << "error: [" << kWrongProperty << "] property " << property << ": found " << found << ", expected "
         << expected;
    return text.str();
}

std::vector<std::string> wordsOf(const std::string& text) {
    std::string blanks = text;
    std::replace(blanks.begin(), blanks.end(), ',', ' ');
    std::istringstream in(blanks);
    std::vector<std::string> words;
    for (std::string word; in >> word;) words.push_back(word);
    return words;
}

bool matches(const std::string& pattern, const Topic& topic) {
    return ::fnmatch(pattern.c_str(), topic.topic.c_str(), 0) == 0;
}

}  // namespace

bool isSpeed(double speed) { return speed >= 0 && speed <= kFastest; }

std::string whatIsWrong(const ReplayOptions& options, double duration) {
    std::ostringstream to;
    to << "seconds from 0 to " << duration << ", the length of the recording";
    if (!isSpeed(options.speed))
        return wrong("Speed", options.speed, "a factor, 1 for as recorded, or 0 for as fast as possible");
    if (!(options.start >= 0 && options.start <= duration)) return wrong("Start", options.start, to.str());
    if (options.end != 0 && !(options.end > options.start))
        return wrong("End", options.end, "seconds after Start, or 0 for the end of the recording");
    return {};
}

std::vector<Topic> chooseTopics(const std::vector<Topic>& all, const std::string& patterns, std::string& why) {
    const std::vector<std::string> words = wordsOf(patterns);
    if (words.empty()) return all;
    std::vector<std::string> names;
    for (const Topic& topic : all) names.push_back(topic.topic);
    for (const std::string& word : words) {
        if (std::any_of(all.begin(), all.end(), [&](const Topic& topic) { return matches(word, topic); })) continue;
        why = std::string("error: [") + kWrongProperty + "] property Topics: no port of the recording matches '" +
              word + "'" + oroforge::diag::didYouMean(word, names);
        return {};
    }
    std::vector<Topic> chosen;
    for (const Topic& topic : all)
        if (std::any_of(words.begin(), words.end(), [&](const std::string& word) { return matches(word, topic); }))
            chosen.push_back(topic);
    return chosen;
}

}  // namespace OCL::replay
