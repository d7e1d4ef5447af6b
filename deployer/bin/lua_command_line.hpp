// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The command line of the programs that are an interpreter of Lua.
#ifndef OROFORGE_DEPLOYER_LUA_COMMAND_LINE_HPP
#define OROFORGE_DEPLOYER_LUA_COMMAND_LINE_HPP

#include <string>
#include <vector>

namespace OCL::deploy {

/** As that of `lua`: options, then a script, then the arguments of the script. */
struct LuaCommandLine {
    struct Step {
        enum Kind { Execute, Require } kind;
        std::string text;  ///< Lua code, or the name of a module
    };

    std::vector<std::string> words;   ///< all, with the program
    std::vector<Step> steps;          ///< in the order in which they are to be done
    std::size_t script = 0;           ///< which of the words; 0 if there is none
    std::vector<std::string> shared;  ///< options that the deployer has, too: of the live window and of replays
    bool version = false;
    bool interactive = false;
    std::string error;  ///< why it is not valid; empty if it is

    /** The script is standard input. After "--" it is a file of that name. */
    bool scriptIsInput() const { return script && words[script] == "-" && words[script - 1] != "--"; }
    /** There is nothing to execute but what is typed or piped. */
    bool isEmpty() const;
};

LuaCommandLine parseLuaCommandLine(std::vector<std::string> words);

/** The options, for somebody who gave a wrong one. */
std::string luaUsage(const std::string& program);

}  // namespace OCL::deploy

#endif
