// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "consoles.hpp"

#include "fields.hpp"

#include <console/console.hpp>
#include <rtt/Logger.hpp>
#include <rtt/extras/SequentialActivity.hpp>
#include <rtt/internal/engine/interruption.hpp>
#include <rtt/os/SignalsBlocked.hpp>

#include <condition_variable>
#include <deque>
#include <exception>
#include <functional>
#include <sstream>
#include <system_error>
#include <thread>
#include <utility>

namespace OCL::live {
namespace {

using nlohmann::json;
using RTT::internal::Interruption;

constexpr std::size_t kMostConsoles = 16, kMostLines = 64, kMostText = 256 * 1024, kLogged = 200;

/** Text that is collected, or goes on with each flush. */
class Collected : public std::stringbuf {
public:
    std::function<void(const std::string&)> onFlush;  ///< may be empty

private:
    int sync() override {
        if (!onFlush || str().empty()) return 0;
        onFlush(cut(str(), kMostText));
        str("");
        return 0;
    }
};

/** The console and what it needs; lives in the thread of its session. */
struct Terminal {
    Terminal(RTT::TaskContext& deployer, const std::string& caller)
        : self("oro"), console(self, deployer, out, err, caller) {
        self.setActivity(new RTT::extras::SequentialActivity());
    }
    ~Terminal() { self.stopForGood(); }

    static std::string taken(Collected& from) {
        const std::string text = from.str();
        from.str("");
        return cut(text, kMostText);
    }

    Collected outText, errText;
    std::ostream out{&outText}, err{&errText};
    RTT::TaskContext self;
    OCL::console::Console console;
};

}  // namespace

struct Consoles::Session {
    typedef std::function<void(Terminal&)> Task;

    std::mutex mutex;
    std::condition_variable work;
    std::deque<std::pair<std::shared_ptr<Ticket>, Task>> waiting;
    Interruption* executing = nullptr;
    bool ends = false, over = false;

    void add(const std::shared_ptr<Ticket>& ticket, Task task) {
        const std::lock_guard<std::mutex> lock(mutex);
        if (over) throw Failure(kGone, "the console has ended");
        if (waiting.size() == kMostLines) throw Failure(kTooMany, "too many lines wait for the present one to end");
        waiting.emplace_back(ticket, std::move(task));
        work.notify_one();
    }

    bool interrupt() {
        const std::lock_guard<std::mutex> lock(mutex);
        if (executing) executing->ask();
        return executing != nullptr;
    }

    void end() {
        const std::lock_guard<std::mutex> lock(mutex);
        ends = true;
        if (executing) executing->ask();
        work.notify_one();
    }

    /** In the thread of the session. False if interrupted. */
    bool execute(const std::function<void()>& command) {
        Interruption interruption;
        set(&interruption);
        try {
            command();
        } catch (...) {
            set(nullptr);
            throw;
        }
        set(nullptr);
        return !interruption.asked();
    }

    void run(const Root& root, const std::string& caller) {
        std::unique_ptr<Terminal> terminal;
        std::unique_lock<std::mutex> lock(mutex);
        for (;;) {
            work.wait(lock, [this] { return ends || !waiting.empty(); });
            if (ends) break;
            const auto [ticket, task] = std::move(waiting.front());
            waiting.pop_front();
            lock.unlock();
            answer(*ticket, task, terminal, root, caller);
            lock.lock();
            if (terminal && terminal->console.quits()) break;
        }
        over = true;
        const auto left = std::move(waiting);
        waiting.clear();
        lock.unlock();
        for (const auto& [ticket, task] : left) ticket->fail(kGone, "the console has ended");
    }

private:
    void set(Interruption* interruption) {
        const std::lock_guard<std::mutex> lock(mutex);
        executing = interruption;
        if (interruption && ends) interruption->ask();
    }

    void answer(Ticket& ticket, const Task& task, std::unique_ptr<Terminal>& terminal, const Root& root,
                const std::string& caller) {
        try {
            Visits visits;
            RTT::TaskContext* const deployer = visits.enter(root.gate);
            if (!deployer) throw Failure(kGone, "the deployment has ended");
            if (!terminal) terminal = std::make_unique<Terminal>(*deployer, caller);
            task(*terminal);
        } catch (const Failure& failure) {
            ticket.fail(failure.code(), failure.what());
        } catch (const std::exception& thrown) {
            ticket.fail(kFailed, thrown.what());
        }
    }
};

Consoles::~Consoles() {
    for (const auto& [caller, session] : sessions_) session->end();
}

void Consoles::left(const std::string& caller) {
    const auto session = sessions_.find(caller);
    if (session == sessions_.end()) return;
    session->second->end();
    sessions_.erase(session);
}

Consoles::Session& Consoles::sessionOf(const std::string& caller) {
    const auto known = sessions_.find(caller);
    if (known != sessions_.end()) {
        const std::lock_guard<std::mutex> lock(known->second->mutex);
        if (!known->second->over) return *known->second;
    }
    if (known != sessions_.end()) sessions_.erase(known);
    if (sessions_.size() == kMostConsoles) throw Failure(kTooMany, "there are too many consoles");
    const auto made = std::make_shared<Session>();
    const RTT::os::SignalsBlocked blocked;
    try {
        std::thread([made, root = root_, caller] { made->run(root, caller); }).detach();
    } catch (const std::system_error&) {
        throw Failure(kTooMany, "the system has no further thread");
    }
    return *(sessions_[caller] = made);
}

void Consoles::line(const std::shared_ptr<Ticket>& ticket) {
    const std::string line = textField(ticket->request(), "line");
    Session& session = sessionOf(ticket->caller().name);
    session.add(ticket, [&session, ticket, line](Terminal& terminal) {
        RTT::log(RTT::Info) << ticket->caller().name << " types: " << cut(line, kLogged) << RTT::endlog();
        const bool isLive = ticket->request().value("live", json()) == true;
        // Its client sees what comes, and may ask for the end.
        terminal.console.screen().canBeStopped = isLive;
        if (isLive) terminal.outText.onFlush = [&ticket](const std::string& text) { ticket->say(text); };
        const bool whole = session.execute([&] { terminal.console.execute(line); });
        terminal.outText.onFlush = nullptr;
        terminal.out.clear();  // a lack of memory would silence all lines that follow
        const std::string prompt = terminal.console.prompt();
        ticket->answer({{"out", Terminal::taken(terminal.outText)},
                        {"err", Terminal::taken(terminal.errText)},
                        {"prompt", prompt},
                        {"quits", terminal.console.quits()},
                        {"interrupted", !whole}});
    });
}

void Consoles::complete(const std::shared_ptr<Ticket>& ticket) {
    const std::string line = textField(ticket->request(), "line");
    sessionOf(ticket->caller().name).add(ticket, [ticket, line](Terminal& terminal) {
        const OCL::console::Completion found = terminal.console.complete(line);
        ticket->answer({{"begin", found.begin}, {"words", found.words}, {"more", found.more(line)}});
    });
}

void Consoles::interrupt(const std::shared_ptr<Ticket>& ticket) {
    const auto session = sessions_.find(ticket->caller().name);
    ticket->answer({{"done", session != sessions_.end() && session->second->interrupt()}});
}

}  // namespace OCL::live
