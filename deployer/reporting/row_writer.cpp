// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "row_writer.hpp"

#include "record.hpp"
#include "row_text.hpp"

#include <rtt/Logger.hpp>

#include <chrono>
#include <csignal>
#include <thread>
#include <utility>

namespace OCL::reporting {
namespace {

/** As much text as is collected before it is written. */
constexpr std::size_t kChunk = 256 * 1024;
/** How long rows may gather: many short writes cost more than few long ones, and a wake-up costs the component. */
constexpr std::chrono::milliseconds kGathering(5);
/** How often it is looked whether the last row is written, and how long that may take before the log says so. */
constexpr std::chrono::milliseconds kEndCheck(1);
constexpr std::chrono::seconds kPatience(2);

/** A pipe whose reader has gone and a file that may not become larger are errors of write(). The signals that the thread
    would get as well end the process, with all its other components. */
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
    // Both sides exchange. If ours comes second we find it asleep; if it comes first, the one in waitForRows() reads what
    // we left, and so sees the record. With a plain load here, each could miss what the other one does.
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

/** Rows are not given up, however long a disk or a pipe takes; who is waiting should know for what. */
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
        if (last) break;  // what was pushed before finish() has been written
        waitForRows();
    }
    done_.signal();
}

void RowWriter::waitForRows() {
    (void)asleep_.exchange(true, std::memory_order_acq_rel);
    // Who takes the flag back first decides: if it was push(), there is a signal to be taken.
    if (queue_.empty() || !asleep_.exchange(false, std::memory_order_acq_rel)) wake_.wait();
    if (!ending_.load(std::memory_order_acquire)) std::this_thread::sleep_for(kGathering);
}

void RowWriter::writeAll() {
    while (queue_.pop(record_)) {
        appendRow(text_, record_.data(), record_.size(), digits_);
        ++rows_;
        if (text_.size() >= kChunk) writeOut();
    }
    writeOut();
}

void RowWriter::writeOut() {
    if (text_.empty()) return;
    const std::string error = failed_ ? std::string() : target_->write(text_.data(), text_.size());
    if (!error.empty()) {
        RTT::log(RTT::Error) << "could not write to " << target_->name() << ": " << error
                             << "; no further rows are written" << RTT::endlog();
        failed_ = true;  // a part of a line may be there: nothing may follow it
        if (onFailure_) onFailure_();
    }
    if (failed_) lose(rows_);
    rows_ = 0;
    text_.clear();
}

void RowWriter::lose(unsigned long rows) { lost_.fetch_add(rows, std::memory_order_relaxed); }

}  // namespace OCL::reporting
