// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// oro console: the console of a running deployment
#include "session.hpp"

#include "failure.hpp"
#include "interrupts.hpp"
#include "prompt.hpp"

#include <algorithm>
#include <iostream>

#include <poll.h>
#include <unistd.h>

namespace oroforge::live_client {
namespace {

constexpr unsigned kBetweenInterrupts = 10000;  // microseconds
constexpr std::chrono::milliseconds kPatience{1000};

bool isReadable(int descriptor) {
    pollfd one{descriptor, POLLIN, 0};
    return poll(&one, 1, 0) > 0;
}

class Remote {
public:
    Remote(Session& session, Interrupts& interrupts)
        : session_(session), deployment_(session.deployment()), interrupts_(interrupts) {}

    /** Executes a line there and writes what it answers. False if the console shall be left. */
    bool execute(const std::string& line) {
        deployment_.connection().wakeOn({interrupts_.descriptor()});
        const long long id = deployment_.send("line", {{"line", line}, {"live", true}});
        long long interrupt = 0;  // id of the request that asks for the end of the line
        bool mayLeave = false;    // the line was not stopped in time
        Deadline patient = kNever;
        for (Json message;;) {
            // A command may last as long as it likes.
            const auto event = deployment_.next(message, patient);
            if (event == Requests::Event::Time) {
                remark("the line goes on, in code that the console cannot stop; Ctrl-C again leaves it alone");
                mayLeave = true;
                patient = kNever;
                continue;
            }
            if (event == Requests::Event::Woken) {
                interrupts_.take();
                if (interrupts_.mustEnd() || mayLeave) return false;
                if (interrupt) continue;
                interrupt = deployment_.send("interrupt", Json::object());
                patient = deadlineIn(kPatience);
                continue;
            }
            if (textOf(message, "op") == "oro.output" && wholeOf(message, "id", -1) == id)
                session_.out().write(shown(textOf(message, "text")));
            if (interrupt && Requests::answers(message, interrupt) && !truthOf(Requests::resultOf(message), "done")) {
                // The line has not begun yet there.
                usleep(kBetweenInterrupts);
                interrupt = deployment_.send("interrupt", Json::object());
            }
            if (Requests::answers(message, id)) return show(Requests::resultOf(message));
        }
    }

    /** Waits for a key; meanwhile the deployment may end. */
    void awaitKey() {
        while (!isReadable(STDIN_FILENO)) {
            deployment_.connection().wakeOn({STDIN_FILENO, interrupts_.descriptor()});
            Json message;
            deployment_.next(message, kNever);
            if (interrupts_.take() && interrupts_.mustEnd()) throw Interrupted();
        }
    }

    Words complete(const std::string& line) {
        deployment_.connection().wakeOn({interrupts_.descriptor()});  // keys that follow must not end it
        const Json found = deployment_.ask("complete", {{"line", line}});
        Words words;
        words.more = printable(textOf(found, "more"));
        for (const Json& word : memberOf(found, "words"))
            if (word.is_string()) words.words.push_back(printable(word.get<std::string>()));
        return words;
    }

    const std::string& prompt() const { return prompt_; }
    bool failed() const { return failed_; }

private:
    /** Lines of the console as they are, without control characters in them. */
    static std::string shown(const std::string& text) {
        std::string result;
        for (std::size_t at = 0; at < text.size();) {
            const std::size_t end = std::min(text.find('\n', at), text.size());
            result += printable(text.substr(at, end - at)) + "\n";
            at = end + 1;
        }
        return result;
    }
    bool show(const Json& result) {
        session_.out().write(shown(textOf(result, "out")));
        const std::string err = shown(textOf(result, "err"));
        failed_ = failed_ || !err.empty();
        if (!err.empty()) Output(STDERR_FILENO).write(err);
        prompt_ = printable(textOf(result, "prompt"));
        return !truthOf(result, "quits");
    }

    Session& session_;
    Requests& deployment_;
    Interrupts& interrupts_;
    std::string prompt_;
    bool failed_ = false;
};

void runTyped(Remote& remote) {
    Prompt prompt([&] { remote.awaitKey(); }, [&](const std::string& line) { return remote.complete(line); });
    for (std::string line;;) {
        const auto outcome = prompt.read(remote.prompt(), line);
        if (outcome == Prompt::Outcome::End) return;
        // An empty line forgets the lines that a dropped one belongs to.
        if (outcome == Prompt::Outcome::Dropped) line.clear();
        if (!remote.execute(line)) return;
    }
}

void runPiped(Remote& remote) {
    for (std::string line; std::getline(std::cin, line);)
        if (!remote.execute(line)) return;
}

}  // namespace

void runConsole(Session& session) {
    if (session.json())
        throw Failure(Status::Usage, "'oro console' writes what the console does, so it takes no --format");
    Interrupts interrupts;
    Remote remote(session, interrupts);
    const bool typed = isatty(STDIN_FILENO) && session.out().isTerminal();
    try {
        if (typed) {
            if (remote.execute("")) runTyped(remote);
        } else {
            runPiped(remote);
        }
    } catch (const Interrupted&) {
    }
    if (!typed && remote.failed()) throw Silent{Status::Refused};
}

}  // namespace oroforge::live_client
