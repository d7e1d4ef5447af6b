// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_CONSOLE_INTERRUPTS_HPP
#define OROFORGE_CONSOLE_INTERRUPTS_HPP

#include <rtt/internal/Interruption.hpp>

#include <csignal>
#include <cstdint>
#include <mutex>
#include <thread>

namespace OCL::console {

/**
 * Stops the command that is being executed when somebody presses Ctrl-C, or the console is to end. If it cannot be stopped, that is
 * told, and the next Ctrl-C ends the process. One at a time.
 */
class Interrupts {
public:
    /** `endsOn` can be read once the console is to end. `onTerminal`: SIGINT means the command and not the console. */
    Interrupts(int endsOn, bool onTerminal);
    ~Interrupts();
    Interrupts(const Interrupts&) = delete;
    Interrupts& operator=(const Interrupts&) = delete;

    /** While one lives, its thread executes a command. One at a time. */
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
    std::int64_t tells_ = -1;  // when to tell that the command goes on; −1: not at all
    std::thread thread_;
};

/** What was pressed between two commands is not meant for the next one. */
void forgetInterrupts();

}  // namespace OCL::console

#endif
