// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OCL_REPORTING_ROW_WRITER_HPP
#define ORO_OCL_REPORTING_ROW_WRITER_HPP

#include "record_queue.hpp"
#include "row_sink.hpp"

#include <rtt/Activity.hpp>
#include <rtt/os/Semaphore.hpp>

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace OCL::reporting {

class Record;

/**
 * The thread that hands records to a sink.
 *
 *     component: Record ──push──► RecordQueue ──pop──► RowSink ──write──► file, console, clients   (this thread)
 *
 * Rows are written in order, some milliseconds after they were pushed.
 */
class RowWriter final : public RTT::Activity {
public:
    /** Starts the thread. @param room bytes for records @param onFailure called once by the thread, when it has
        failed() */
    RowWriter(const std::string& name, std::unique_ptr<RowSink> sink, std::size_t room,
              std::function<void()> onFailure = {});
    /** Calls finish(). */
    ~RowWriter() override;

    // Called by one thread at a time.
    /** False if there is no room, and the row is lost. Real-time safe. */
    bool push(const Record& record);
    /** Sets what the next records consist of; `row` is one of them that is not written. False if there is no room.
        Allocates. */
    bool pushFields(Field report, const Record& row);
    /** The room in bytes, including waiting records. */
    std::size_t room() const { return queue_.capacity(); }
    /** Makes room for that many bytes, in addition to waiting records. Allocates. */
    void makeRoom(std::size_t bytes) { queue_.makeRoom(bytes); }

    /** Counts a row that is lost before it comes here. */
    void lose() { lose(1); }
    /** Waits until everything is written, or the patience of the sink ends, and ends the thread. If that takes long,
        logs what it waits for. */
    void finish();
    /** The number of rows for which there was no room or that could not be written. */
    unsigned long lost() const { return lost_.load(std::memory_order_relaxed); }
    /** True if a write failed; nothing more is written then. */
    bool failed() const { return failed_.load(std::memory_order_relaxed); }

protected:
    void loop() override;
    bool breakLoop() override { return true; }

private:
    void writeAll();
    bool isLate() const;
    void take();
    void takeFields();
    void dropAll();
    void writeOut();
    void fail(const std::string& error);
    void wake();
    void waitForRows();
    void waitUntilDone();
    void lose(unsigned long rows);

    const std::unique_ptr<RowSink> sink_;
    RecordQueue queue_;
    std::atomic<unsigned long> lost_{0};
    std::atomic<bool> asleep_{false};              // the thread waits, or will wait, for wake_
    std::chrono::steady_clock::time_point endBy_;  // set before ending_
    std::atomic<bool> ending_{false};
    RTT::os::Semaphore wake_{0}, done_{0};
    bool started_ = false;
    // Used only by the thread:
    std::vector<char> record_;
    std::atomic<bool> failed_{false};
    const std::function<void()> onFailure_;
};

}  // namespace OCL::reporting

#endif
