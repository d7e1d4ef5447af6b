// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "program_listing.hpp"

#include "scripted.hpp"

#include <algorithm>
#include <cctype>
#include <iomanip>
#include <ostream>
#include <sstream>

namespace OCL::console {
namespace {

constexpr int kHalf = 10;

std::vector<std::string> linesOf(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

char letterOf(const Scripted& program) {
    return program.status.empty() ? ' '
                                  : static_cast<char>(std::toupper(static_cast<unsigned char>(program.status[0])));
}

}  // namespace

void ProgramListing::write(Screen& screen, const Scripted& program, int from, int until) {
    const std::vector<std::string> lines = linesOf(program.text);
    const int end = program.firstLine + static_cast<int>(lines.size());
    until = std::max(until, program.firstLine + kHalf);  // the text has no earlier line
    from = std::max(from, program.firstLine);
    until = std::min(until, end);
    if (from >= until) screen.out << "'" << program.name << "' ends with line " << end - 1 << '\n';
    const int width = static_cast<int>(std::to_string(std::max(until, end) - 1).size());
    for (int number = from; number < until; ++number) {
        const bool here = number == program.line;
        const std::string mark = here ? std::string(1, letterOf(program)) + ">" : "  ";
        std::ostringstream row;
        row << mark << std::setw(width + 1) << number << ' '
            << lines[static_cast<std::size_t>(number - program.firstLine)];
        screen.out << screen.paint(here ? Style::Value : Style::Plain, row.str()) << '\n';
    }
    last_ = program.name;
    next_ = std::max(from, until);
}

bool ProgramListing::list(Screen& screen, RTT::TaskContext& component, const std::string& name, int around) {
    Scripted program;
    if (!findScripted(component, name, program)) return false;
    const int at = around > 0 ? around : std::max(program.line, program.firstLine);
    write(screen, program, at - kHalf, at + kHalf);
    return true;
}

bool ProgramListing::listMore(Screen& screen, RTT::TaskContext& component, int from) {
    Scripted program;
    if (last_.empty() || !findScripted(component, last_, program)) return false;
    const int first = from > 0 ? from : next_;
    write(screen, program, first, first + 2 * kHalf);
    return true;
}

bool ProgramListing::trace(Screen& screen, RTT::TaskContext& component, const std::string& name) {
    Scripted program;
    if (!findScripted(component, name, program)) return false;
    untrace(component, name);
    traced_.push_back({component.getName(), name, program.line});
    return list(screen, component, name, 0);
}

void ProgramListing::traceAll(Screen& screen, RTT::TaskContext& component) {
    const std::vector<std::string> names = scriptedNames(component);
    if (names.empty()) screen.out << "component '" << component.getName() << "' has no programs or state machines\n";
    for (const std::string& name : names) trace(screen, component, name);
}

bool ProgramListing::untrace(RTT::TaskContext& component, const std::string& name) {
    const auto kept = std::remove_if(traced_.begin(), traced_.end(), [&](const Traced& each) {
        return each.component == component.getName() && each.name == name;
    });
    const bool traced = kept != traced_.end();
    traced_.erase(kept, traced_.end());
    return traced;
}

void ProgramListing::update(Screen& screen, RTT::TaskContext& component) {
    for (Traced& each : traced_) {
        Scripted program;
        if (each.component != component.getName() || !findScripted(component, each.name, program)) continue;
        if (program.line == each.line) continue;
        each.line = program.line;
        screen.out << each.name << ": " << program.status << '\n';
        write(screen, program, program.line - kHalf, program.line + kHalf);
    }
}

}  // namespace OCL::console
