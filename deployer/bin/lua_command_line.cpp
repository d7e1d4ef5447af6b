// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "lua_command_line.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace OCL::deploy {
namespace {

/** Options of the deployer that these programs have, too, and which of them take a word. */
const struct {
    const char* name;
    bool takesWord;
} kShared[] = {{"--no-live", false},       {"--web", false},      {"--web-allow", true},    {"--web-origin", true},
               {"--web-token-file", true}, {"--replay", true},    {"--replace", true},      {"--record", true},
               {"--replay-speed", true},   {"--tolerate", false}, {"--replay-check", false}};

/** Takes such an option, and the word after it if it needs that. False if it is none. */
bool takeShared(LuaCommandLine& line, std::size_t& at) {
    const std::string& word = line.words[at];
    const std::size_t equals = word.find('=');
    const std::string name = word.substr(0, equals);
    const auto* const found =
        std::find_if(std::begin(kShared), std::end(kShared), [&](const auto& one) { return name == one.name; });
    if (found == std::end(kShared)) return false;
    line.shared.push_back(word);
    if (!found->takesWord || equals != std::string::npos) return true;
    if (++at < line.words.size())
        line.shared.push_back(line.words[at]);
    else
        line.error = "option '" + name + "' takes a word";
    return true;
}

}  // namespace

bool LuaCommandLine::isEmpty() const {
    const auto executes = [](const Step& step) { return step.kind == Step::Execute; };
    return !script && !version && std::none_of(steps.begin(), steps.end(), executes);
}

LuaCommandLine parseLuaCommandLine(std::vector<std::string> words) {
    LuaCommandLine line;
    line.words = std::move(words);
    std::size_t at = 1;
    for (; at < line.words.size(); ++at) {
        const std::string& word = line.words[at];
        if (word.empty() || word[0] != '-' || word == "-") break;
        if (word == "--") {
            ++at;
            break;
        }
        if (takeShared(line, at)) {
            if (!line.error.empty()) return line;
        } else if (word == "-i" || word == "-v") {
            line.version = true;
            line.interactive = line.interactive || word == "-i";
        } else if (word[1] == 'e' || word[1] == 'l') {
            const bool isApart = word.size() == 2;
            if (isApart && ++at == line.words.size()) {
                line.error = "option '" + word + "' takes " + (word == "-e" ? "Lua code" : "the name of a module");
                return line;
            }
            line.steps.push_back({word[1] == 'e' ? LuaCommandLine::Step::Execute : LuaCommandLine::Step::Require,
                                  isApart ? line.words[at] : word.substr(2)});
        } else {
            line.error = "there is no option '" + word + "'";
            return line;
        }
    }
    if (at < line.words.size()) line.script = at;
    return line;
}

std::string luaUsage(const std::string& program) {
    return "usage: " + program +
           " [options] [script [arguments]]\n"
           "  -e CODE  executes Lua code\n"
           "  -l NAME  loads a module, as require(NAME)\n"
           "  -i       reads what is typed, after the script\n"
           "  -v       shows versions\n"
           "  --no-live, --web[=ADDRESS:PORT], --web-allow=WORDS, --web-origin=SITES, --web-token-file=FILE\n"
           "           as those of the deployer: what others may see and do\n"
           "  --replay=FILE, --replace=NAMES, --record=FILE, --replay-speed=FACTOR, --tolerate, --replay-check\n"
           "           as those of the deployer: the replay begins when the script has ended\n"
           "  --       ends the options\n"
           "  -        takes standard input as the script\n"
           "Without script and options, it reads what is typed, or executes standard input.\n";
}

}  // namespace OCL::deploy
