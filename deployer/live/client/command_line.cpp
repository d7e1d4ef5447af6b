// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "command_line.hpp"

#include "failure.hpp"

#include <CLI/CLI.hpp>

#include <diag/nearest_match.hpp>

#include <algorithm>
#include <deque>
#include <utility>

namespace oroforge::live_client {
namespace {

// CLI11 takes "-0.5" and "-inf" for options and "[1, 2]" for two values; with this letter in front, neither.
constexpr char kMark = '\1';

bool isValue(const std::string& word) {
    if (word.empty()) return false;
    const bool number = word[0] == '-' && word.size() > 1 && (word[1] == '.' || (word[1] >= '0' && word[1] <= '9'));
    return number || word[0] == '[' || word == "-inf" || word == "-nan" || word == "-Infinity";
}

std::string unmarked(const std::string& word) { return !word.empty() && word[0] == kMark ? word.substr(1) : word; }

/** A command of CLI11 and where its results go. */
struct Parsed {
    CLI::App* app = nullptr;
    const Command* command = nullptr;
    /** Where its words go, in the order of its arguments; an argument of one word has the first of them. */
    std::deque<std::pair<CLI::Option*, std::vector<std::string>>> arguments;
};

/** Where the values of options go; entries must stay where they are. */
struct Value {
    std::string key, text;
    bool flag = false;
    CLI::Option* option = nullptr;
};

void addOptions(CLI::App& app, const std::vector<Option>& options, std::deque<Value>& values) {
    for (const Option& option : options) {
        Value& value = values.emplace_back();
        value.key = keyOf(option);
        if (option.value)
            value.option = app.add_option(option.names, value.text, option.text)->type_name(option.value);
        else
            value.option = app.add_flag(option.names, value.flag, option.text);
        if (option.completed == Names::Format) value.option->check(CLI::IsMember({"text", "json"}));
    }
}

void addCommand(CLI::App& app, const Command& command, Parsed& parsed, std::deque<Value>& values) {
    parsed.command = &command;
    parsed.app = app.add_subcommand(command.name, command.summary);
    // The summary is for the list, the sentences for the help of the command itself.
    std::string examples = "Examples:";
    for (const Example& example : command.examples)
        examples += "\n  " + std::string(example.line) + (*example.text ? "    " + std::string(example.text) : "");
    parsed.app->footer(std::string(command.text) + "\n\n" + examples);
    for (const Argument& argument : command.arguments) {
        auto& [option, words] = parsed.arguments.emplace_back();
        if (argument.most == 1)
            option = parsed.app->add_option(argument.name, words.emplace_back(), argument.text);
        else
            option = parsed.app->add_option(argument.name, words, argument.text);
        option->type_name("");
        if (argument.least) option->required();
    }
    addOptions(*parsed.app, command.options, values);
}

std::vector<std::string> optionNames(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::App* each = &app; each; each = each->get_parent())
        for (const CLI::Option* const option : each->get_options())
            if (!option->get_lnames().empty()) names.push_back("--" + option->get_lnames().front());
    return names;
}

std::vector<std::string> commandNames() {
    std::vector<std::string> names;
    for (const Command& command : commands()) names.emplace_back(command.name);
    return names;
}

[[noreturn]] void refuse(CLI::App& app, const CLI::ParseError& error) {
    const auto chosen = app.get_subcommands();
    const CLI::App& at = chosen.empty() ? app : *chosen.front();
    const std::string hint = "; 'oro " + (chosen.empty() ? "" : at.get_name() + " ") + "--help' explains it";
    const auto remaining = app.remaining(true);
    if (!remaining.empty()) {
        const std::string word = unmarked(remaining.front());
        if (word[0] == '-')
            throw Failure(Status::Usage,
                          "unknown option '" + word + "'" + diag::didYouMean(word, optionNames(at)) + hint);
        if (chosen.empty())
            throw Failure(Status::Usage,
                          "unknown command '" + word + "'" + diag::didYouMean(word, commandNames()) + hint);
        throw Failure(Status::Usage, "'oro " + at.get_name() + "' has no use for '" + word + "'" + hint);
    }
    std::string text = error.what();
    std::replace(text.begin(), text.end(), '\n', ' ');
    throw Failure(Status::Usage, text + hint);
}

/** As that of a variable of a shell that is not set: `oro stop "$ARM"` must not be `oro stop`. Values may be empty. */
void refuseEmpty(const Given& given) {
    if (!given.command || given.command->program) return;
    const auto& arguments = given.command->arguments;
    for (std::size_t i = 0; i != std::min(arguments.size(), given.words.size()); ++i)
        if (arguments[i].names != Names::None && given.words[i].empty())
            throw Failure(Status::Usage, std::string(arguments[i].name) + " is an empty text; 'oro " +
                                             given.command->name + " --help' explains it");
    for (const auto& [key, text] : given.options)
        if (text.empty()) throw Failure(Status::Usage, "the value of --" + key + " is an empty text");
}

}  // namespace

CommandLine readCommandLine(const std::vector<std::string>& words) {
    CLI::App app("Looks at and commands running deployments.", "oro");
    app.footer(
        "'oro COMMAND --help' explains a command. Exit status: 0 done, 1 the deployment refused or an error,\n"
        "2 wrong command line, 3 no deployment.");
    app.set_version_flag("--version", "oro (Oroforge) " OROFORGE_VERSION);
    app.require_subcommand(0, 1);
    app.fallthrough();
    std::deque<Value> values;
    addOptions(app, commonOptions(), values);
    std::deque<Parsed> all;
    for (const Command& command : commands()) addCommand(app, command, all.emplace_back(), values);
    std::vector<std::string> reversed;  // as CLI11 wants them
    for (const std::string& word : words) reversed.push_back(isValue(word) || word[0] == kMark ? kMark + word : word);
    std::reverse(reversed.begin(), reversed.end());
    try {
        app.parse(reversed);
    } catch (const CLI::CallForHelp&) {
        const auto chosen = app.get_subcommands();
        return {{}, chosen.empty() ? app.help() : chosen.front()->help("oro")};
    } catch (const CLI::CallForVersion& version) {
        return {{}, std::string(version.what()) + "\n"};
    } catch (const CLI::ParseError& error) {
        refuse(app, error);
    }
    CommandLine line;
    for (const Parsed& parsed : all) {
        if (!parsed.app->parsed()) continue;
        line.given.command = parsed.command;
        for (const auto& [option, words] : parsed.arguments)
            for (const std::string& word : option->count() ? words : std::vector<std::string>())
                line.given.words.push_back(unmarked(word));
    }
    for (const Value& value : values)
        if (value.option->count() > 0) line.given.options[value.key] = value.flag ? "true" : unmarked(value.text);
    refuseEmpty(line.given);
    if (!line.given.command) throw Failure(Status::Usage, "no command was given; 'oro --help' lists the commands");
    return line;
}

}  // namespace oroforge::live_client
