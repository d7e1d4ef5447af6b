// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OCL_REPORTING_RUNNING_REPORT_HPP
#define ORO_OCL_REPORTING_RUNNING_REPORT_HPP

#include "other_value.hpp"
#include "record.hpp"
#include "row_writer.hpp"
#include "source.hpp"
#include "value_tree.hpp"

#include <rtt/marsh/MarshallInterface.hpp>
#include <rtt/os/TimeService.hpp>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace OCL::reporting {

typedef std::vector<std::shared_ptr<Source>> Sources;

/** Those that write reports in a form of their own; either may be null. */
struct Marshallers {
    std::unique_ptr<RTT::marsh::MarshallInterface> header, body;
};

struct ReportOptions {
    std::string component;
    Decomposition decomposition = Decomposition::Members;
    bool header = true;         ///< before the first row
    bool repeatHeader = false;  ///< also whenever the columns have changed
    bool onlyNewData = false;   ///< leave out what has not changed since the last row
    int digits = 6;
    RTT::os::TimeService::ticks begin = 0;  ///< zero of the time stamps
    std::function<void()> onFailure;        ///< called once, by another thread, when the target takes no more
};

/** A report from start() to stop() of its component: fixed sources, a header, rows. Used by one thread at a time. */
class RunningReport {
public:
    /** Reads all sources and takes them apart. `target` may be null, `marshallers` must outlive this. */
    RunningReport(const Sources& sources, const ReportOptions& options, std::unique_ptr<TextTarget> target,
                  const std::vector<Marshallers>& marshallers);

    /** Reads all sources; true if a port had a new sample. Real-time safe as far as copying the values is. */
    bool read();
    /** Hands over a row of what was read. Without marshallers it allocates nothing, unless a value has grown. */
    void writeRow();
    /** Forgets samples that came before the report. */
    void clearPorts();
    /** New samples of ports wake the component, or do not. */
    void wakeOnData(bool on);
    /** Waits until everything is written. */
    void finish();
    unsigned long lost() const { return writer_ ? writer_->lost() : 0; }
    /** Its target takes no more rows. */
    bool failed() const { return writer_ && writer_->failed(); }

private:
    struct Entry {
        Entry(std::shared_ptr<Source> from, ValueTree columns) : source(std::move(from)), tree(std::move(columns)) {}

        std::shared_ptr<Source> source;
        ValueTree tree;
        bool changed = true;  // since the last row
        bool wanted = true;   // in this row
        std::string last;     // of a value without a port: its record, to see whether it has changed
    };
    void chooseEntries();
    bool hasChanged(Entry& entry);
    void encodeRow(double time);
    void writeHeader();
    void columnsChanged();
    void fill(RTT::PropertyBag& bag, double time);
    void push(const Record& record);

    const ReportOptions options_;
    const std::vector<Marshallers>& marshallers_;
    OtherValues others_;
    std::vector<Entry> entries_;
    Record record_, part_;
    bool otherColumns_ = false;  // than the row before
    bool everChanged_ = false;
    bool everLost_ = false;
    std::unique_ptr<RowWriter> writer_;  // last: its thread uses others_
};

}  // namespace OCL::reporting

#endif
