// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_CONSOLE_INTERRUPTS_HPP
#define OROFORGE_CONSOLE_INTERRUPTS_HPP

#include <rtt/internal/engine/interruption.hpp>

#include <csignal>
#include <cstdint>
#include <mutex>
#include <thread>

namespace OCL::console {

/**
 * Stops the current command when the user presses Ctrl-C or the console must end. If the command cannot be stopped, it
 * warns the user, and the next Ctrl-C ends the process. Only one may exist at a time.
 */
class Interrupts {
public:
    /** `endsOn` becomes readable when the console must end. `onTerminal`: SIGINT stops the command, not the console. */
    Interrupts(int endsOn, bool onTerminal);
    ~Interrupts();
    Interrupts(const Interrupts&) = delete;
    Interrupts& operator=(const Interrupts&) = delete;

    /** Its thread executes a command while it exists. Only one may exist at a time. */
    class Command {
    public:
        explicit Command(Interrupts& interrupts);
        ~Command();
        Command(const Command&) = delete;
        Command& operator=(const Command&) = delete;

        bool interrupted() const { return interruption_.asked(); }

    private:
        Interrupts& of_;
        RTT::internal::Interruption interruption_;
    };

private:
    void watch();
    int patience() const;
    void interrupt();
    void tell();

    const int ends_on_;
    const bool on_terminal_;
    const int wakes_;
    std::mutex mutex_;  // guards what follows
    RTT::internal::Interruption* command_ = nullptr;
    bool over_ = false;        // for the thread
    bool ends_ = false;        // the console
    std::int64_t tells_ = -1;  // when to warn that the command goes on; −1: never
    std::thread thread_;
};

/** Forgets keys that were pressed between two commands. */
void forgetInterrupts();

}  // namespace OCL::console

#endif
