// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What a command of oro is. Help, manual pages and completion are made of the same table.
#ifndef OROFORGE_LIVE_CLIENT_COMMAND_HPP
#define OROFORGE_LIVE_CLIENT_COMMAND_HPP

#include <cstddef>
#include <string>
#include <vector>

namespace oroforge::live_client {

class Session;

/** What can stand in place of an argument or the value of an option, for completion. */
enum class Names {
    None,
    Component,
    Part,
    Port,
    Field,
    Value,
    Operation,
    Deployment,
    Shell,
    Level,
    Format,
    File,
    Recording
};

struct Argument {
    const char* name;
    const char* text;
    Names names = Names::None;
    std::size_t least = 1;
    std::size_t most = 1;  ///< kAny: any number
};
constexpr std::size_t kAny = static_cast<std::size_t>(-1);

struct Option {
    const char* names;  ///< as in "-f,--follow"; the last one is the key of its value
    const char* value;  ///< name of its value; null if it has none
    const char* text;
    Names completed = Names::None;
};

struct Example {
    const char* line;
    const char* text;
};

struct Command {
    const char* name;
    const char* summary;  ///< a phrase, for lists
    const char* text;     ///< sentences
    std::vector<Argument> arguments;
    std::vector<Option> options;
    std::vector<Example> examples;
    void (*run)(Session& session);
    const char* program = nullptr;  ///< another program does it, and reads its words itself
};

/** All commands, in the order of the help. */
const std::vector<Command>& commands();
/** The command of that name; null if there is none. */
const Command* commandNamed(const std::string& name);
/** Options of every command. */
const std::vector<Option>& commonOptions();

/** The long name of an option, without hyphens: "follow". */
std::string keyOf(const Option& option);
/** "PORT [FIELD...]" */
std::string usageOf(const Command& command);

// What the commands do; each is in the file of its subject.
void listDeployments(Session& session);
void showTree(Session& session);
void showPart(Session& session);
void getValue(Session& session);
void setValue(Session& session);
void callOperation(Session& session);
void startComponent(Session& session);
void stopSomething(Session& session);
void configureComponent(Session& session);
void cleanUpComponent(Session& session);
void recoverComponent(Session& session);
void echoPort(Session& session);
void showRate(Session& session);
void showDelay(Session& session);
void plotPort(Session& session);
void showLog(Session& session);
void showGraph(Session& session);
void showTop(Session& session);
void runConsole(Session& session);
void readRecording(Session& session);
void writeCompletion(Session& session);
void writeManual(Session& session);

}  // namespace oroforge::live_client

#endif
