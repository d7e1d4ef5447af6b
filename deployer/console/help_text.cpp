// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The text of `help`.
#include "commands.hpp"

#include "table.hpp"

#include <ostream>
#include <utility>

namespace OCL::console {
namespace {

void title(Screen& screen, const char* text) { screen.out << screen.paint(Style::Title, text) << '\n'; }

void writeCommands(Screen& screen, const std::vector<Command>& commands) {
    Table table({Style::Name, Style::Plain}, Table::Wrap);
    for (const Command& command : commands)
        table.add({std::string(command.word) + (*command.arguments ? " " : "") + command.arguments, command.help});
    table.write(screen.out, screen.theme, "    ", screen.tableWidth());
}

}  // namespace

void writeHelp(Screen& screen) {
    title(screen, "What is typed is a piece of script, or a command.");
    const char* const examples[][2] = {
        {"2.5 * 3.0", "shows the value; with a ';' at its end it does not"},
        {"tank.capacity", "the value of a property, attribute or variable; of a struct also 'pose.x'"},
        {"tank.capacity = 1.5", "assigns"},
        {"var double x = 1.5", "makes an attribute of the present component"},
        {"tank.fill(1.5)", "calls an operation and waits for its result"},
        {"tank.fill.send(1.5)", "sends it, and does not wait"},
        {"level.read(x)", "reads a port; 'flow.write(1.5)' writes to one"},
        {"tank", "shows the interface of a component, service or port"},
        {"if …, while …, program …", "what scripts have; an open brace or parenthesis goes on in the next line"},
    };
    Table table({Style::Name, Style::Plain}, Table::Wrap);
    for (const auto& example : examples) table.add({example[0], example[1]});
    table.write(screen.out, screen.theme, "    ", screen.tableWidth());
    screen.out << '\n';
    title(screen, "Commands");
    writeCommands(screen, commands());
    screen.out << '\n';
    writeCommands(screen, dotCommands());
    screen.out << '\n';
    title(screen, "Keys");
    Table keys({Style::Name, Style::Plain}, Table::Wrap);
    keys.add({"TAB", "completes the word, or shows how it could go on"});
    keys.add({"up, down, Ctrl-R", "what was typed before; searches in it"});
    keys.add({"Ctrl-C", "forgets the line; stops the command that is being executed"});
    keys.add({"Ctrl-D", "on an empty line: leaves the console"});
    keys.write(screen.out, screen.theme, "    ", screen.tableWidth());
    screen.out << '\n';
    title(screen, "States");
    Table states({Style::Name, Style::Plain});
    for (const auto& state : {std::pair("[U]", "unconfigured"),
                              {"[S]", "stopped"},
                              {"[R]", "running"},
                              {"[E]", "run time error"},
                              {"[X]", "exception"},
                              {"[F]", "fatal error"}})
        states.add({state.first, state.second});
    states.write(screen.out, screen.theme, "    ", 0);
}

}  // namespace OCL::console
