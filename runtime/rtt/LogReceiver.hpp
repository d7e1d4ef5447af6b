// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_LOG_RECEIVER_HPP
#define ORO_LOG_RECEIVER_HPP

#include <rtt/Logger.hpp>

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace RTT {

/** A finished line of the log. The texts are valid during the call of receive() only. */
struct LogEntry {
    LoggerLevel level;
    /** The module of a Logger::In, else the component or thread that logged, see Logger. */
    std::string_view origin;
    /** The text as it was composed: it may contain line ends and control characters. */
    std::string_view text;
    /** Characters that were cut off, because the line of a real-time thread was too long. */
    std::size_t cut;
    /** When the line ended: ns since the reference time of the Logger, and ns since 1970 (UTC). */
    std::int64_t time;
    std::int64_t wallTime;
    /** The text is a diagnostic that begins with its own place, "file:line:column: error: …". */
    bool located;
};

/**
 * Gets the lines that are meant for the log file, see Logger::setReceiver().
 *
 * One thread of the runtime, "log receiver", of ordinary priority, calls receive(), one line after the other, in the
 * order of the file. So receive() may block, lock and allocate:
 *
 * * No thread that logs waits for it. Up to 1000 lines wait for their turn; the receiver does not get those beyond.
 *   When it has caught up, a warning gives their number, to it as well.
 * * What receive() itself logs goes to the console and the file, never to a receiver. If it makes another thread log
 *   for each line, these lines come back.
 * * If receive() throws, it does not get that line again. The first time, a warning says why.
 *
 * A receiver that is used instead of the file loses nothing by that: lines that it does not get, or that it throws on,
 * go to the file.
 */
class RTT_API LogReceiver {
public:
    virtual ~LogReceiver();
    virtual void receive(const LogEntry& entry) = 0;
};

/**
 * As Logger::setReceiver(), for any number of receivers beside the file and that one: for views that come and go. They
 * share a second thread, "log receiver", and the 1000 lines that wait for it. An observer that was added is not added
 * again.
 */
RTT_API void addLogObserver(LogReceiver& observer);
/**
 * When this returns, the observer has got the lines that were logged before, unless that takes longer than a second,
 * and is not in use. Must not be called by receive().
 */
RTT_API void removeLogObserver(LogReceiver& observer);

}  // namespace RTT
#endif
