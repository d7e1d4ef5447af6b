// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The editor holds the mutex except while it waits, so that other threads find the cursor where unlock() said.
#include "output_above.hpp"

#include "cursor_row.hpp"
#include "line_editor.hpp"

#include <rtt/os/terminal_buffer.hpp>

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <iostream>
#include <mutex>
#include <new>
#include <streambuf>
#include <string>
#include <system_error>
#include <vector>

#include <pthread.h>
#include <sys/eventfd.h>
#include <unistd.h>

namespace OCL::console {
namespace {

constexpr std::size_t kMostBegun = 4096, kLeastBegun = 2048;

/** The state shared by streams and editor; never destroyed, because a thread may write at any time. */
struct Terminal {
    std::mutex mutex;
    bool erases = true;
    bool editing = false;   // a line is being edited
    bool shown = false;     // it is on the screen, and other threads may remove it
    std::size_t above = 0;  // rows of the line above the cursor
    // Output of other threads since their last line end. The edited line is below it.
    std::string begun;
    int wakes = -1;

    void put(const std::string& text) {
        std::fwrite(text.data(), 1, text.size(), stdout);
        std::fflush(stdout);
    }
    CursorRow endOfBegun() const {
        CursorRow cursor(widthOfTerminal());
        cursor.add(begun);
        return cursor;
    }
    void erase(std::size_t rows) {
        put(!erases ? "\n" : (rows > 0 ? "\033[" + std::to_string(rows) + "A" : "") + "\r\033[J");
    }
    void takeLineAway();
    void follow(const char* text, std::size_t size);
};

Terminal& terminal();

/** In a child: another thread may have held the mutex at the fork, and the line belongs to the parent. */
void forgetInChild() {
    Terminal& shared = terminal();
    new (&shared.mutex) std::mutex;
    shared.shown = false;
    new (&shared.begun) std::string;
}

Terminal& terminal() {
    static Terminal& only = [&]() -> Terminal& {
        pthread_atfork(nullptr, nullptr, &forgetInChild);
        return *new Terminal;
    }();
    return only;
}

void Terminal::takeLineAway() {
    shown = false;
    if (!erases) begun.clear();
    const CursorRow cursor = endOfBegun();
    const bool goesOn = cursor.row() > 0 || cursor.column() > 0;
    // After a full row, the terminal itself moves to the next one.
    erase(above + (goesOn ? cursor.row() + (cursor.column() > 0 ? 1 : 0) : 0));
    put(begun);
    const std::uint64_t one = 1;
    while (::write(wakes, &one, sizeof one) < 0 && errno == EINTR) {
    }
}

void Terminal::follow(const char* text, std::size_t size) {
    begun.append(text, size);
    const std::size_t end = begun.rfind('\n');
    if (end != std::string::npos) begun.erase(0, end + 1);
    if (begun.size() > kMostBegun) begun.erase(0, begun.size() - kLeastBegun);
}

/** Replaces the buffer of a stream. */
class Shared : public RTT::os::TerminalBuffer {
public:
    explicit Shared(std::ostream& stream) : stream_(stream) {}

    void takeOver() {
        if (stream_.rdbuf() == this) return;  // other code had replaced the buffer and has put this one back
        own_ = stream_.rdbuf();
        stream_.rdbuf(this);
    }
    void giveBack() {
        // Other code may have replaced the buffer since.
        if (stream_.rdbuf() == this) stream_.rdbuf(own_);
    }

protected:
    std::streamsize xsputn(const char* text, std::streamsize size) override {
        if (size <= 0) return 0;
        Terminal& shared = terminal();
        const std::lock_guard<std::mutex> locked(shared.mutex);
        if (shared.shown) shared.takeLineAway();
        const std::streamsize written = own_->sputn(text, size);
        if (shared.editing) own_->pubsync();
        shared.follow(text, static_cast<std::size_t>(size));
        return written;
    }
    int_type overflow(int_type letter) override {
        if (traits_type::eq_int_type(letter, traits_type::eof())) return traits_type::not_eof(letter);
        const char text = traits_type::to_char_type(letter);
        return xsputn(&text, 1) == 1 ? letter : traits_type::eof();
    }
    int sync() override {
        const std::lock_guard<std::mutex> locked(terminal().mutex);
        return own_->pubsync();
    }

private:
    std::ostream& stream_;
    std::streambuf* own_ = nullptr;
};

/** The buffers of streams to the terminal; never destroyed, because a thread may be inside one. */
std::vector<Shared*>& streams() {
    static std::vector<Shared*>& all = *[] {
        auto* const made = new std::vector<Shared*>{new Shared(std::cout)};
        if (isatty(STDERR_FILENO)) made->insert(made->end(), {new Shared(std::cerr), new Shared(std::clog)});
        return made;
    }();
    return all;
}

}  // namespace

OutputAbove::OutputAbove(bool erases) {
    Terminal& shared = terminal();
    const std::lock_guard<std::mutex> locked(shared.mutex);
    shared.wakes = eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK);
    if (shared.wakes < 0) throw std::system_error(errno, std::generic_category(), "no descriptor for the console");
    shared.erases = erases;
    shared.begun.clear();  // may be left from an earlier console
    for (Shared* const stream : streams()) stream->takeOver();
}

OutputAbove::~OutputAbove() {
    for (Shared* const stream : streams()) stream->giveBack();
    Terminal& shared = terminal();
    const std::lock_guard<std::mutex> locked(shared.mutex);
    close(shared.wakes);
    shared.wakes = -1;
}

int OutputAbove::descriptor() const { return terminal().wakes; }

bool OutputAbove::lock() {
    Terminal& shared = terminal();
    shared.mutex.lock();
    std::uint64_t wakes = 0;
    while (::read(shared.wakes, &wakes, sizeof wakes) < 0 && errno == EINTR) {
    }
    const bool shown = shared.shown;
    shared.shown = false;
    shared.editing = true;
    return shown;
}

void OutputAbove::makeRoom() {
    const CursorRow cursor = terminal().endOfBegun();
    if (cursor.row() > 0 || cursor.column() > 0) terminal().put("\n");
}

void OutputAbove::erase(std::size_t above) { terminal().erase(above); }

void OutputAbove::unlock(std::size_t above, bool shown) {
    Terminal& shared = terminal();
    shared.above = above;
    shared.shown = shown;
    shared.mutex.unlock();
}

void OutputAbove::end(const std::string& last) {
    Terminal& shared = terminal();
    shared.put(last);
    shared.begun.clear();
    shared.editing = false;
    shared.mutex.unlock();
}

}  // namespace OCL::console
