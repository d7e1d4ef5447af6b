// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <ocl/TaskBrowser.hpp>

#include "console.hpp"
#include "history.hpp"
#include "interrupts.hpp"
#include "kept_terminal.hpp"
#include "line_editor.hpp"
#include "table.hpp"
#include "wanted.hpp"

#include <rtt/os/SignalCatcher.hpp>

#include <cstdlib>
#include <cstring>
#include <initializer_list>
#include <iostream>
#include <optional>
#include <stdexcept>

#include <unistd.h>

namespace OCL {
namespace {

bool isDumb() {
    const char* const terminal = std::getenv("TERM");
    return !terminal || std::strcmp(terminal, "dumb") == 0;
}

bool wantsColors() {
    const char* const none = std::getenv("NO_COLOR");
    return TaskBrowser::onTerminal() && !(none && *none) && !isDumb();
}

void greet() {
    std::cout << '\n';
    for (const char* const text :
         {"Type an expression, a piece of script or a command; 'help' tells more, 'ls' shows what is here.",
          "TAB completes, Ctrl-R searches what was typed before, Ctrl-D or 'quit' leaves."})
        for (const std::string& line : console::wrapped(text, console::widthOfTerminal() - 2))
            std::cout << "  " << line << '\n';
    std::cout << std::endl;
}

RTT::TaskContext& checked(RTT::TaskContext* component) {
    if (!component) throw std::invalid_argument("a TaskBrowser needs a component");
    return *component;
}

}  // namespace

struct TaskBrowser::Impl {
    Impl(TaskBrowser& self, RTT::TaskContext& component)
        : typed(isatty(STDIN_FILENO) != 0 && console::isWanted()),
          console(self, component, std::cout, std::cerr, onTerminal() ? "console" : "stdin") {}

    const bool typed;  // asked once, because a terminal that hangs up is no longer one

    console::Console console;
    int endsOn = -1;
};

TaskBrowser::TaskBrowser(RTT::TaskContext* component)
    : TaskContext("TaskBrowser"), impl_(new Impl(*this, checked(component))) {
    if (onTerminal()) {
        impl_->console.screen().width = &console::widthOfTerminal;
        impl_->console.screen().cutsTables = true;
        impl_->console.screen().live = true;
        impl_->console.screen().erases = !isDumb();
    }
    setColorTheme(wantsColors() ? darkbg : nocolors);
}

TaskBrowser::~TaskBrowser() { stopForGood(); }

bool TaskBrowser::failed() const { return !impl_->typed && impl_->console.screen().failed; }

bool TaskBrowser::onTerminal() { return isatty(STDIN_FILENO) && isatty(STDOUT_FILENO) && console::isWanted(); }

void TaskBrowser::endOn(int descriptor) { impl_->endsOn = descriptor; }

void TaskBrowser::setColorTheme(ColorTheme theme) {
    using console::Theme;
    impl_->console.screen().theme = Theme(theme == nocolors ? Theme::NoColors
                                          : theme == darkbg ? Theme::Dark
                                                            : Theme::Light);
}

void TaskBrowser::evaluate(const std::string& line) {
    impl_->console.execute(line);
    impl_->console.finish();
}

void TaskBrowser::switchTaskContext(RTT::TaskContext* component) {
    impl_->console.state().place.visit(checked(component));
    impl_->console.state().goTo(false);
}

void TaskBrowser::loop() {
    using console::LineSource;
    console::Console& lines = impl_->console;
    // For programs that do not catch these signals themselves.
    std::optional<RTT::os::SignalCatcher> signals;
    if (impl_->endsOn < 0) {
        RTT::os::beforeSecondSignal(&console::restoreTerminal);
        signals.emplace(std::initializer_list<int>{SIGINT, SIGTERM, SIGHUP});
    }
    const int endsOn = signals ? signals->descriptor() : impl_->endsOn;
    std::unique_ptr<LineSource> source;
    const bool edits = onTerminal();
    console::History history(edits ? console::historyFile() : "");
    if (edits) {
        source = std::make_unique<console::LineEditor>(
            history, [&lines](const std::string& line) { return lines.complete(line); }, endsOn);
        greet();
        if (const std::string problem = history.problem(); !problem.empty()) std::cerr << problem << '\n';
    } else {
        source = std::make_unique<console::InputLines>(STDIN_FILENO, endsOn);
    }
    console::Interrupts interrupts(endsOn, edits);
    std::string line;
    while (!lines.quits()) {
        const std::string prompt = lines.prompt();
        const LineSource::Outcome outcome = lines.quits() ? LineSource::Outcome::End : source->read(prompt, line);
        if (outcome == LineSource::Outcome::End) break;
        if (outcome == LineSource::Outcome::Dropped) {
            lines.forget();
            continue;
        }
        const console::Interrupts::Command command(interrupts);
        lines.execute(line);
        if (command.interrupted()) source->forget();
    }
    if (edits || console::isReadable(endsOn)) return lines.forget();
    const console::Interrupts::Command command(interrupts);
    lines.finish();
}

}  // namespace OCL
