// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "commands.hpp"

#include <CLI/CLI.hpp>

#include <iostream>

namespace oroforge::mcap {
namespace {

CLI::App* add(CLI::App& app, const char* name, const char* text, ToolOptions& options, int files) {
    CLI::App* const command = app.add_subcommand(name, text);
    command->add_option("file", options.files, files == 1 ? "The recording" : "The recordings")
        ->type_name("FILE")
        ->expected(files)
        ->required();
    return command;
}

void addTopics(CLI::App* command, ToolOptions& options) {
    command->add_option("--topic", options.topics, "Only this topic; any number of times")
        ->type_name("TOPIC")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

}  // namespace

bool readCommandLine(int count, char** words, ToolOptions& options, int& status) {
    CLI::App app(
        "Reads recordings (MCAP files). The exit status is 0 if all is well, 1 if part of a file is damaged or "
        "two files differ,\nand 2 if the command line is wrong or a file cannot be read or written.",
        "oro-mcap");
    app.require_subcommand(1);
    add(app, "info", "What a recording has: topics, times, losses; reads and checks all of it", options, 1);
    addTopics(add(app, "cat", "Print the messages, one line of JSON for each", options, 1), options);
    addTopics(add(app, "diff", "Compare two recordings; says for each topic where they differ first", options, 2),
              options);
    CLI::App* const recover =
        add(app, "recover", "Write what is whole of a damaged recording to a new one", options, 1);
    recover->add_option("-o,--output", options.output, "The new recording; else FILE_recovered.mcap")
        ->type_name("FILE");
    CLI::App* const convert = add(app, "convert", "Write messages as a table", options, 1);
    addTopics(convert, options);
    convert
        ->add_option(
            "--to", options.format,
            "The format: csv has one topic, table and netcdf have all; else by the name of the output: .csv, .dat, .nc")
        ->type_name("FORMAT");
    convert->add_option("-o,--output", options.output, "The table; else it is printed")->type_name("FILE");
    try {
        app.parse(count, words);
    } catch (const CLI::CallForHelp&) {
        std::cout << app.help();
        status = kGood;
        return false;
    } catch (const CLI::ParseError& error) {
        const auto rest = app.remaining(true);
        const bool isCommand = app.get_subcommands().empty() && !rest.empty() && rest.front()[0] != '-';
        std::cerr << "oro-mcap: error: "
                  << (isCommand ? "unknown command '" + rest.front() + "'" : std::string(error.what()))
                  << "; oro-mcap --help explains the command line\n";
        status = kFailed;
        return false;
    }
    options.command = app.get_subcommands().front()->get_name();
    return true;
}

}  // namespace oroforge::mcap
