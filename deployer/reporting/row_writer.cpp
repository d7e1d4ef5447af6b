// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "row_writer.hpp"

#include "record.hpp"

#include <rtt/Logger.hpp>

#include <chrono>
#include <csignal>
#include <thread>
#include <utility>

namespace OCL::reporting {
namespace {

/** The amount of text that is collected before it is written. */
constexpr std::size_t kChunk = 256 * 1024;
/** How long rows may gather, because many short writes cost more than few long ones, and a wake-up costs the
    component. */
constexpr std::chrono::milliseconds kGathering(5);
/** How often finish() checks whether the last row is written, and how long that may take before it logs that it
    waits. */
constexpr std::chrono::milliseconds kEndCheck(1);
constexpr std::chrono::seconds kPatience(2);

/** Blocks the signals that a closed pipe or a file size limit would send to this thread: they would end the process
    with all other components, and write() returns an error anyway. */
void takeNoSignalsOfWriting() {
    sigset_t signals;
    sigemptyset(&signals);
    sigaddset(&signals, SIGPIPE);
    sigaddset(&signals, SIGXFSZ);
    (void)pthread_sigmask(SIG_BLOCK, &signals, nullptr);
}

}  // namespace

RowWriter::RowWriter(const std::string& name, std::unique_ptr<TextTarget> target, std::size_t room, int digits,
                     std::function<void()> onFailure)
    : RTT::Activity(ORO_SCHED_OTHER, 0, 0.0, nullptr, name),
      target_(std::move(target)),
      digits_(digits),
      queue_(room),
      onFailure_(std::move(onFailure)) {
    text_.reserve(2 * kChunk);
    started_ = start();
}

RowWriter::~RowWriter() { finish(); }

bool RowWriter::push(const Record& record) {
    if (!queue_.push(record.data(), record.size())) {
        lose(1);
        return false;
    }
    // Both sides exchange the flag. If this exchange comes second, it finds the thread asleep. If it comes first, that
    // in waitForRows() reads from it and so sees the record. With a plain load here, each side could miss what the
    // other does.
    if (asleep_.exchange(false, std::memory_order_acq_rel)) wake_.signal();
    return true;
}

void RowWriter::finish() {
    if (!started_) return;
    started_ = false;
    ending_.store(true, std::memory_order_seq_cst);
    wake_.signal();
    waitUntilDone();
    (void)stop();
}

/** Waits without limit, because rows must not be lost if a disk or pipe is slow; logs that it waits. */
void RowWriter::waitUntilDone() {
    const auto begin = std::chrono::steady_clock::now();
    for (bool told = false; !done_.trywait(); std::this_thread::sleep_for(kEndCheck)) {
        if (told || std::chrono::steady_clock::now() - begin < kPatience) continue;
        told = true;
        RTT::log(RTT::Warning) << "waiting for " << target_->name() << " to take the last rows of a report"
                               << RTT::endlog();
    }
}

void RowWriter::loop() {
    takeNoSignalsOfWriting();
    for (;;) {
        const bool last = ending_.load(std::memory_order_acquire);
        writeAll();
        if (last) break;  // all that was pushed before finish() has been written
        waitForRows();
    }
    done_.signal();
}

void RowWriter::waitForRows() {
    (void)asleep_.exchange(true, std::memory_order_acq_rel);
    // The first side that resets the flag decides: if it was push(), there is a signal to wait for.
    if (queue_.empty() || !asleep_.exchange(false, std::memory_order_acq_rel)) wake_.wait();
    if (!ending_.load(std::memory_order_acquire)) std::this_thread::sleep_for(kGathering);
}

void RowWriter::writeAll() {
    while (queue_.pop(record_)) {
        target_->format(text_, record_.data(), record_.size(), digits_);
        ++rows_;
        if (text_.size() >= kChunk) writeOut();
    }
    writeOut();
}

void RowWriter::writeOut() {
    if (text_.empty()) {
        rows_ = 0;
        return;
    }
    const std::string error = failed_ ? std::string() : target_->write(text_.data(), text_.size());
    if (!error.empty()) {
        RTT::log(RTT::Error) << "could not write to " << target_->name() << ": " << error
                             << "; no further rows are written" << RTT::endlog();
        failed_ = true;  // part of a line may have been written, so nothing may follow it
        if (onFailure_) onFailure_();
    }
    if (failed_) lose(rows_);
    rows_ = 0;
    text_.clear();
}

void RowWriter::lose(unsigned long rows) { lost_.fetch_add(rows, std::memory_order_relaxed); }

}  // namespace OCL::reporting
