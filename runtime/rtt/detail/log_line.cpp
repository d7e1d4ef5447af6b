// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/detail/log_line.hpp>

#include <rtt/detail/log_queue.hpp>
#include <rtt/detail/log_sink.hpp>
#include <rtt/internal/calls/failure_report.hpp>
#include <rtt/internal/engine/hook_in_progress.hpp>
#include <rtt/os/real_time_thread.hpp>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <iterator>
#include <pthread.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace RTT::detail {

namespace {

/**
 * Not a thread_local object: those of the main thread are destroyed before static objects, whose destructors log as
 * well. The key's function runs when a thread ends, except the main thread.
 */
thread_local LogLine* currentLine __attribute__((tls_model("initial-exec"))) = nullptr;

std::atomic<LogLine*> spareLines[kSpareLines];

void endOfThread(void* line) {
    currentLine = nullptr;
    LogLine* const last = static_cast<LogLine*>(line);
    last->finish(true);  // a line that the thread did not end
    delete last;
}

pthread_key_t lineKey() {
    static const pthread_key_t key = [] {
        pthread_key_t made;
        pthread_key_create(&made, &endOfThread);
        return made;
    }();
    return key;
}

LogLine* makeLine() {
    if (os::inRealTimeThread())
        for (auto& spare : spareLines)
            // Acquire: pairs with the release in refillSpareLines(); the line is complete.
            if (LogLine* line = spare.exchange(nullptr, std::memory_order_acquire)) return line;
    return new LogLine;
}

int hooksInProgress() noexcept {
    int depth = 0;
    for (const auto* hook = internal::HookInProgress::innermost(); hook; hook = hook->outer) ++depth;
    return depth;
}

std::atomic<unsigned> forks{1};

}  // namespace

LogLine& logLine() {
    if (!currentLine) {
        currentLine = makeLine();
        pthread_setspecific(lineKey(), currentLine);
    }
    return *currentLine;
}

void refillSpareLines() {
    lineKey();
    for (auto& spare : spareLines) {
        if (spare.load(std::memory_order_relaxed)) continue;
        LogLine* const made = new LogLine;
        LogLine* nothing = nullptr;
        if (!spare.compare_exchange_strong(nothing, made, std::memory_order_release, std::memory_order_relaxed))
            delete made;
    }
}

LineBuffer::LineBuffer() { text_.reserve(LogQueue::kLongest); }

void LineBuffer::append(const char* text, std::size_t size) {
    if (const std::size_t room = text_.capacity() - text_.size(); size > room && os::inRealTimeThread()) {
        cut_ += size - room;
        size = room;
    }
    text_.append(text, size);
}

LineBuffer::int_type LineBuffer::overflow(int_type c) {
    if (!traits_type::eq_int_type(c, traits_type::eof())) {
        const char one = traits_type::to_char_type(c);
        append(&one, 1);
    }
    return traits_type::not_eof(c);
}

std::streamsize LineBuffer::xsputn(const char* text, std::streamsize size) {
    append(text, static_cast<std::size_t>(size));
    return size;
}

LogLine::LogLine() {
    // The first use of a stream looks things up and may allocate.
    stream << 1 << 0.5;
    buffer.clear();
}

void LogLine::setModule(const char* name, std::size_t size) noexcept {
    size = std::min(size, kLongestLogModule);
    std::memmove(module, name, size);
    module[size] = '\0';
    depth = hooksInProgress();
}

// Looked up when a line ends, so that the engine pays nothing for it.
std::string_view LogLine::origin(char (&room)[kLongestThreadName]) noexcept {
    const internal::HookInProgress* const hook = internal::HookInProgress::innermost();
    // A hook that began within the scope of an In is the closer of the two.
    if (depth != kNoModule && (!hook || hooksInProgress() <= depth)) return module;
    return hook ? std::string_view(hook->component) : threadName(room);
}

void forgetThreadIds() noexcept { forks.fetch_add(1, std::memory_order_relaxed); }

// System calls neither wait nor allocate. The name is not kept, because a thread may get one later.
std::string_view LogLine::threadName(char (&room)[kLongestThreadName]) noexcept {
    if (const unsigned now = forks.load(std::memory_order_relaxed); knownSince_ != now) {
        thread_ = syscall(SYS_gettid);
        inMain_ = thread_ == getpid();
        knownSince_ = now;
    }
    if (inMain_) return "main";
    constexpr std::size_t kKernelName = 15;
    prctl(PR_GET_NAME, room);
    // A thread that nobody named has the name of the thread that created it.
    if (room[0] != '\0' && std::strncmp(room, program_invocation_short_name, kKernelName) != 0) return room;
    constexpr std::string_view kind = "thread ";
    char* const number = std::copy(kind.begin(), kind.end(), room);
    return {room, static_cast<std::size_t>(std::to_chars(number, std::end(room), thread_).ptr - room)};
}

void LogLine::finish(bool flush) {
    // Not visible and nothing composed: the common case of debug messages, which must cost next to nothing.
    if (opened || logMayReach(level)) finishVisible(flush);
}

// Separate, so that a line that nobody sees does not pay for its stack.
void LogLine::finishVisible(bool flush) {
    const bool composed = !buffer.text().empty();
    const bool kept = composed && level == Error && internal::KeptErrors::keep(buffer.text());
    char room[kLongestThreadName];
    if (composed && !kept && logMayReach(level))
        logSink().write(level, origin(room), buffer.text(), flush, buffer.cut());
    else if (flush)
        logSink().flush();
    buffer.clear();
    opened = false;
    // A manipulator must not affect the next line.
    stream.flags(std::ios_base::skipws | std::ios_base::dec);
    stream.precision(6);
    stream.width(0);
    stream.fill(' ');
    stream.clear();
}

}  // namespace RTT::detail
