// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/detail/log_sink.hpp>

#include <rtt/detail/log_format.hpp>
#include <rtt/detail/log_line.hpp>
#include <rtt/detail/log_settings.hpp>
#include <rtt/os/real_time_thread.hpp>

#include <algorithm>
#include <charconv>
#include <ctime>
#include <iostream>
#include <pthread.h>
#include <unistd.h>

namespace RTT::detail {

namespace {
constexpr std::size_t kRecentLines = 1000;
}

LogSink& logSink() {
    static LogSink& sink = *[] {
        auto* const made = new LogSink;
        // If another thread held the mutexes during a fork(), those of the child would never be unlocked.
        pthread_atfork([] { logSink().beforeFork(); }, [] { logSink().afterFork(false); },
                       [] { logSink().afterFork(true); });
        return made;
    }();
    return sink;
}

std::atomic<int> logLimit{-1};

void LogSink::startup() {
    std::lock_guard<std::mutex> lock(mutex_);
    if (started_) return;
    started_ = true;
    reference_ = os::TimeService::Instance()->getTicks();
    const LogSettings settings = readLogSettings();
    apply(settings);
    LogNotes notes;
    file_.open(settings.file, notes);
    notes.insert(notes.end(), settings.notes.begin(), settings.notes.end());
    updateLimits();
    announceStart(notes);
}

void LogSink::shutdown() {
    drainer_.stop();
    {
        std::lock_guard<std::mutex> lock(mutex_);
        if (!started_) return;
        drainLocked();
        note(Info, "logging ends");
    }
    relay_.deliver();
    observers_.deliver();
    std::lock_guard<std::mutex> lock(mutex_);
    drainLocked();
    if (insteadOfFile_) writeToFile(relay_.takeBack());
    started_ = false;
    updateLimits();
    file_.close();
}

void LogSink::startDrain() { drainer_.start(); }

void LogSink::finish() {
    drainer_.stop();
    finished_ = true;
    {
        // The stream given to setConsole() may be gone by now.
        std::lock_guard<std::mutex> lock(mutex_);
        console_ = nullptr;
    }
    drain();
    LogReceiver* const receiver = takeFrom(relay_, nullptr, LogReceiverUse::BesideFile);
    if (receiver) relay_.awaitUnusedBriefly(receiver);
    LogReceiver* const observer = takeFrom(observers_, nullptr, LogReceiverUse::BesideFile);
    if (observer) observers_.awaitUnusedBriefly(observer);
}

void LogSink::beforeFork() {
    drainer_.beforeFork();
    mutex_.lock();
    relay_.beforeFork();
    observers_.beforeFork();
}

void LogSink::afterFork(bool inChild) {
    observers_.afterFork(inChild);
    relay_.afterFork(inChild);
    if (inChild) {
        queue_.clear();  // the parent writes its lines
        file_.leaveToParent();
        forgetThreadIds();
        receiving_ = insteadOfFile_ = observing_ = false;
        updateLimits();
    }
    mutex_.unlock();
    drainer_.afterFork(inChild);
}

void LogSink::apply(const LogSettings& settings) {
    if (settings.level) disabled_ = *settings.level < 0;
    if (settings.level && !disabled_) level_ = static_cast<LoggerLevel>(*settings.level);
    if (settings.time && !timeGiven_) time_ = *settings.time;
    colors_.begin(settings.colors);
    utcOffset_.at(wallNow());  // for signal handlers
}

void LogSink::announceStart(const LogNotes& notes) {
    for (const LogNote& found : notes) note(found.first, found.second);
    note(Info,
         "OROCOS version '" ORO_STRINGIFY(RTT_VERSION) "' compiled with " + compilerName() + ", running on GNU/Linux");
    note(Info, std::string("logging starts at level ") + levelTag(level()) + " (" + std::to_string(level()) + ")");
    note(Info, "reference time is " + std::to_string(referenceTime()) + " ticks; times in this log are " +
                   (time() == LogTime::Wall ? "local time" : "seconds since then"));
}

void LogSink::updateLimits() {
    const LoggerLevel level = this->level();
    int console = kNothing;
    int file = kNothing;
    if (started_ && !disabled_ && (level != RealTime || realTimeAllowed_)) {
        if (consoleEnabled_ && level != Never) console = level;
        if (fileEnabled_ && (file_.isOpen() || receiving_ || observing_)) file = std::max<int>(level, Info);
    }
    consoleLimit_ = console;
    fileLimit_ = file;
    logLimit = std::max(console, file);
}

void LogSink::setLevel(LoggerLevel level) {
    std::lock_guard<std::mutex> lock(mutex_);
    drainLocked();  // earlier lines use the earlier settings; likewise below
    level_ = level;
    updateLimits();
}

void LogSink::setConsole(std::ostream& stream) {
    std::lock_guard<std::mutex> lock(mutex_);
    drainLocked();
    console_ = &stream;
}

void LogSink::enableConsole(bool yes) {
    std::lock_guard<std::mutex> lock(mutex_);
    drainLocked();
    consoleEnabled_ = yes;
    updateLimits();
}

void LogSink::enableFile(bool yes) {
    std::lock_guard<std::mutex> lock(mutex_);
    drainLocked();
    fileEnabled_ = yes;
    updateLimits();
}

void LogSink::allowRealTime(bool yes) {
    std::lock_guard<std::mutex> lock(mutex_);
    drainLocked();
    realTimeAllowed_ = yes;
    updateLimits();
}

void LogSink::setTime(LogTime time) {
    std::lock_guard<std::mutex> lock(mutex_);
    drainLocked();
    timeGiven_ = true;
    if (time_.exchange(time) == time || !started_) return;
    note(Info, std::string("from now on, times in this log are ") +
                   (time == LogTime::Wall ? "local time" : "seconds since the reference time"));
}

LogReceiver* LogSink::takeFrom(LogRelay& relay, LogReceiver* next, LogReceiverUse use) {
    drain();  // lines of real-time threads
    const bool delivered = relay.deliver();
    std::lock_guard<std::mutex> lock(mutex_);
    drainLocked();
    LogRelay::Rest rest;
    LogReceiver* const previous = relay.exchange(next, rest);
    const std::size_t missing = rest.lines.size() + rest.lost;
    if (!delivered && missing != 0)
        note(Warning, std::to_string(missing) +
                          " line(s) not given to the receiver of the log, which was too slow to be taken away");
    writeToFile(rest.lines);
    if (next && !relay.isRunning()) note(Error, "the receiver of the log gets no lines: there is no thread for it");
    if (&relay == &observers_) {
        observing_ = next != nullptr;
    } else {
        receiving_ = next != nullptr;
        insteadOfFile_ = next && use == LogReceiverUse::InsteadOfFile;
    }
    updateLimits();
    flushLocked();
    return previous;
}

LogReceiver* LogSink::setReceiver(LogReceiver* receiver, LogReceiverUse use) {
    if (receiver) startDrain();
    LogReceiver* const previous = takeFrom(relay_, receiver, use);
    if (previous && previous != receiver) relay_.awaitUnused(previous);
    return previous;
}

LogReceiver* LogSink::setObserver(LogReceiver* observer) {
    if (observer) startDrain();
    LogReceiver* const previous = takeFrom(observers_, observer, LogReceiverUse::BesideFile);
    if (previous && previous != observer) observers_.awaitUnused(previous);
    return previous;
}

void LogSink::deliverToObserver() {
    drain();
    (void)observers_.deliver();
}

void LogSink::notTaken(const LogParts& line) {
    std::lock_guard<std::mutex> lock(mutex_);
    compose(line);
    file_.write(scratch_.data(), scratch_.size());
    file_.flush();
}

void LogSink::warn(const std::string& text) { write(Warning, "Logger", text, true); }

void LogSink::note(LoggerLevel level, const std::string& text) {
    writeLocked(stamped({level, "Logger", text}));
    flushLocked();
}

void LogSink::write(LoggerLevel level, std::string_view module, std::string_view text, bool flush, std::size_t cut) {
    writeNow({level, module, text, cut}, flush);
}

void LogSink::writeBare(LoggerLevel level, std::string_view text) {
    if (logMayReach(level)) writeNow({level, {}, text, 0, /*bare=*/true}, true);
}

LogParts LogSink::stamped(LogParts parts) const noexcept {
    parts.time = now();
    if (showsWallTime()) parts.wall = wallNow();
    return parts;
}

void LogSink::writeNow(LogParts parts, bool flush) {
    parts.forReceiver = !relay_.inThread() && !observers_.inThread();
    if (os::inRealTimeThread() && !finished_.load(std::memory_order_relaxed)) return enqueue(parts);
    std::lock_guard<std::mutex> lock(mutex_);
    drainLocked();
    writeLocked(stamped(parts));
    if (flush || finished_) flushLocked();
}

void LogSink::enqueue(LoggerLevel level, std::string_view module, std::string_view text, std::size_t cut) noexcept {
    enqueue({level, module, text, cut});
}

void LogSink::enqueue(const LogParts& parts) noexcept {
    LogRecord record{};
    record.time = now();
    if (showsWallTime()) record.wall = wallNow();
    record.level = static_cast<std::uint8_t>(parts.level);
    record.bare = parts.bare;
    record.forReceiver = parts.forReceiver;
    record.moduleSize = static_cast<std::uint16_t>(std::min(parts.module.size(), kLongestLogModule));
    const std::size_t size = std::min<std::size_t>(parts.text.size(), LogQueue::kLongest - record.moduleSize);
    record.textSize = static_cast<std::uint16_t>(size);
    record.cut = static_cast<std::uint32_t>(std::min<std::size_t>(parts.cut + parts.text.size() - size, UINT32_MAX));
    queue_.put(record, parts.module.data(), parts.text.data());
    drainer_.wake();
}

void LogSink::drain() {
    std::lock_guard<std::mutex> lock(mutex_);
    drainLocked();
    flushLocked();
}

namespace {

LogParts partsOf(const LogRecord& record, const char* bytes) {
    return {static_cast<LoggerLevel>(record.level),
            std::string_view(bytes, record.moduleSize),
            std::string_view(bytes + record.moduleSize, record.textSize),
            record.cut,
            record.bare,
            record.forReceiver,
            record.time,
            record.wall};
}

/** The text about lost lines; uses a buffer, for signal handlers. */
std::string_view lostText(char (&out)[96], std::uint32_t lost) noexcept {
    char* const at = std::to_chars(out, out + 16, lost).ptr;
    constexpr std::string_view rest = " line(s) of real-time threads lost: the queue of the log was full";
    return {out, static_cast<std::size_t>(std::copy(rest.begin(), rest.end(), at) - out)};
}

}  // namespace

void LogSink::drainLocked() {
    LogRecord record;
    char bytes[LogQueue::kLongest];
    // Bounded, so that threads that log endlessly do not keep this thread here.
    for (std::uint32_t i = 0; i != LogQueue::kCells && queue_.take(record, bytes); ++i)
        writeLocked(partsOf(record, bytes));
    if (const std::uint32_t lost = queue_.takeLost()) {
        char text[96];
        writeLocked(stamped({Warning, "Logger", lostText(text, lost)}));
    }
}

void LogSink::drainDying() noexcept {
    // If the dying thread holds the mutex itself, the lines are lost.
    for (int attempt = 0; !mutex_.try_lock(); ++attempt) {
        if (attempt == 100) return;
        const timespec ms{0, 1000000};
        nanosleep(&ms, nullptr);
    }
    file_.flush();
    LogRecord record;
    char bytes[LogQueue::kLongest];
    char text[96];
    const bool toConsole = !console_ || console_ == &std::cerr || console_ == &std::clog;
    const TimeStyle style{time() == LogTime::Wall, utcOffset_.last()};
    const auto toFile = [&](const LogParts& parts) {
        composeLine(parts, style, [this](const char* part, std::size_t size) { file_.add(part, size); });
    };
    const auto show = [&](const LogParts& parts) {
        if (toConsole && reachesConsole(parts.level))
            composeLine(parts, style, [](const char* part, std::size_t size) { writeAll(STDERR_FILENO, part, size); });
        if (reachesFile(parts.level)) toFile(parts);
    };
    relay_.rescue(toFile);
    while (queue_.take(record, bytes)) show(partsOf(record, bytes));
    if (const std::uint32_t lost = queue_.takeLost()) show(stamped({Warning, "Logger", lostText(text, lost)}));
    file_.flush();
    mutex_.unlock();
}

void LogSink::compose(const LogParts& parts) {
    const bool wall = time() == LogTime::Wall;
    scratch_.clear();
    composeLine(parts, {wall, wall ? utcOffset_.at(parts.wall) : 0},
                [this](const char* part, std::size_t size) { scratch_.append(part, size); });
}

void LogSink::writeLocked(const LogParts& parts) {
    if (!logMayReach(parts.level)) return;
    compose(parts);
    if (reachesConsole(parts.level)) {
        if (recent_.size() == kRecentLines) recent_.pop_front();
        recent_.emplace_back(scratch_, 0, scratch_.size() - 1);
        std::ostream& console = console_ ? *console_ : std::cerr;
        const bool painted = !parts.bare && colors_.on(console);
        if (painted) LogColors::paint(scratch_, parts.level, painted_);
        // At once, because other threads may use the stream as well.
        const std::string& line = painted ? painted_ : scratch_;
        console.write(line.data(), static_cast<std::streamsize>(line.size()));
    }
    if (!reachesFile(parts.level)) return;
    if (observing_ && parts.forReceiver) (void)observers_.put(parts, /*only=*/false);
    const bool taken = receiving_ && parts.forReceiver && relay_.put(parts, insteadOfFile_);
    if (!taken || !insteadOfFile_) file_.write(scratch_.data(), scratch_.size());
}

void LogSink::writeToFile(const LogRelay::Lines& lines) {
    for (const LogCopy& line : lines) {
        if (!line.only) continue;
        compose(line.line());
        file_.write(scratch_.data(), scratch_.size());
    }
}

void LogSink::flush() {
    if (os::inRealTimeThread() && !finished_.load(std::memory_order_relaxed)) return;
    drain();
}

void LogSink::flushLocked() {
    if (consoleLimit_ != kNothing) (console_ ? *console_ : std::cerr).flush();
    file_.flush();
    if (const std::string failure = file_.takeFailure(); !failure.empty()) note(Warning, failure);
}

std::string LogSink::takeLine() {
    std::lock_guard<std::mutex> lock(mutex_);
    drainLocked();
    if (recent_.empty()) return std::string();
    std::string line = std::move(recent_.front());
    recent_.pop_front();
    return line;
}

}  // namespace RTT::detail
