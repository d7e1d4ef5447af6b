// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "row_writer.hpp"

#include "record.hpp"
#include "writing_thread.hpp"

#include <rtt/Logger.hpp>

#include <chrono>
#include <exception>
#include <thread>
#include <utility>

namespace OCL::reporting {
namespace {

/** The number of bytes that are collected before they are written. */
constexpr std::size_t kChunk = 256 * 1024;
/** How long rows may gather, because many short writes cost more than few long ones, and a wake-up costs the
    component. */
constexpr std::chrono::milliseconds kGathering(5);
/** How often finish() checks whether the last row is written, and how long that may take before it logs that it
    waits. */
constexpr std::chrono::milliseconds kEndCheck(1);
constexpr std::chrono::seconds kUntilTold(2);

}  // namespace

RowWriter::RowWriter(const std::string& name, std::unique_ptr<RowSink> sink, std::size_t room,
                     std::function<void()> onFailure)
    : RTT::Activity(ORO_SCHED_OTHER, 0, 0.0, nullptr, name),
      sink_(std::move(sink)),
      queue_(room),
      onFailure_(std::move(onFailure)) {
    started_ = start();
}

RowWriter::~RowWriter() { finish(); }

bool RowWriter::push(const Record& record) {
    if (!queue_.push(record.data(), record.size())) {
        lose(1);
        return false;
    }
    wake();
    return true;
}

bool RowWriter::pushFields(Field report, const Record& row) {
    auto owned = std::make_unique<const Field>(std::move(report));
    Record record;
    record.value(Tag::Fields, static_cast<const Field*>(owned.get()));
    record.bytes(row.data(), row.size());
    if (!queue_.push(record.data(), record.size())) return false;
    (void)owned.release();  // takeFields() owns it now
    wake();
    return true;
}

void RowWriter::wake() {
    // Both sides exchange the flag. If this exchange comes second, it finds the thread asleep. If it comes first, that
    // in waitForRows() reads from it and so sees the record. With a plain load here, each side could miss what the
    // other does.
    if (asleep_.exchange(false, std::memory_order_acq_rel)) wake_.signal();
}

void RowWriter::finish() {
    if (std::exchange(started_, false)) {
        endBy_ = std::chrono::steady_clock::now() + sink_->patience();
        ending_.store(true, std::memory_order_seq_cst);
        wake_.signal();
        waitUntilDone();
        (void)stop();
    }
    dropAll();  // if the thread could not be started
}

bool RowWriter::isLate() const {
    return ending_.load(std::memory_order_acquire) && std::chrono::steady_clock::now() >= endBy_;
}

/** Waits without limit, because rows must not be lost if a disk or pipe is slow; logs that it waits. */
void RowWriter::waitUntilDone() {
    const auto begin = std::chrono::steady_clock::now();
    for (bool told = false; !done_.trywait(); std::this_thread::sleep_for(kEndCheck)) {
        if (told || std::chrono::steady_clock::now() - begin < kUntilTold) continue;
        told = true;
        RTT::log(RTT::Warning) << "waiting for " << sink_->name() << " to take the last rows of a report"
                               << RTT::endlog();
    }
}

void RowWriter::loop() {
    takeNoSignalsOfWriting();
    for (;;) {
        const bool last = ending_.load(std::memory_order_acquire);
        writeAll();
        if (last) break;  // all that was pushed before finish() has been taken
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
    try {
        while (!failed_ && !isLate() && queue_.pop(record_)) take();
        writeOut();
    } catch (const std::exception& exception) {
        fail(exception.what());
    }
    if (failed_ || isLate()) dropAll();
}

void RowWriter::take() {
    if (record_.front() == static_cast<char>(Tag::Fields)) return takeFields();
    try {
        sink_->row(record_.data(), record_.size());
    } catch (...) {
        lose(1);
        throw;
    }
    if (sink_->waiting() >= kChunk) writeOut();
}

/** Counts all rows of the queue as lost. */
void RowWriter::dropAll() {
    char begin[1 + sizeof(const Field*)] = {};
    while (queue_.drop(begin, sizeof begin)) {
        RecordReader reader(begin, sizeof begin);
        if (reader.tag() == Tag::Fields)
            delete reader.value<const Field*>();
        else
            lose(1);
    }
}

void RowWriter::takeFields() {
    RecordReader reader(record_.data(), record_.size());
    (void)reader.tag();
    const std::unique_ptr<const Field> report(reader.value<const Field*>());
    const std::size_t size = record_.size() - 1 - sizeof(const Field*);
    sink_->fields(*report, reader.bytes(size), size);
}

void RowWriter::writeOut() {
    if (failed_) return;
    const std::string error = sink_->write();
    if (!error.empty()) fail(error);
}

/** What was written may end within a row, so nothing may follow it. */
void RowWriter::fail(const std::string& error) {
    if (failed_) return;
    lose(sink_->rows());
    failed_ = true;
    RTT::log(RTT::Error) << "could not write to " << sink_->name() << ": " << error << "; no further rows are written"
                         << RTT::endlog();
    if (onFailure_) onFailure_();
}

void RowWriter::lose(unsigned long rows) { lost_.fetch_add(rows, std::memory_order_relaxed); }

}  // namespace OCL::reporting
