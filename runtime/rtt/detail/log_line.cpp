// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/detail/log_line.hpp>

#include <rtt/detail/log_sink.hpp>

#include <pthread.h>

namespace RTT {
namespace detail {

namespace {

/**
 * Not a thread_local object: those of the main thread are destroyed before static objects are, whose destructors
 * log as well. The key's function runs when a thread ends, not for the main thread.
 */
thread_local LogLine* currentLine = nullptr;

void endOfThread(void* line) {
    currentLine = nullptr;
    LogLine* const last = static_cast<LogLine*>(line);
    last->finish(true);  // what it did not end itself
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

}  // namespace

LogLine& logLine() {
    if (!currentLine) {
        currentLine = new LogLine;
        pthread_setspecific(lineKey(), currentLine);
    }
    return *currentLine;
}

void LogLine::finish(bool flush) {
    // Nobody sees it, nothing was composed: the common case of debug messages, which must cost next to nothing.
    if (!opened && !logSink().mayLog(level)) return;
    if (!buffer.text().empty() && logSink().mayLog(level))
        logSink().write(level, module, buffer.text(), flush);
    else if (flush)
        logSink().flush();
    buffer.clear();
    opened = false;
    // A manipulator must not reach into the next line.
    stream.flags(std::ios_base::skipws | std::ios_base::dec);
    stream.precision(6);
    stream.width(0);
    stream.fill(' ');
    stream.clear();
}

}  // namespace detail
}  // namespace RTT
