// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OCL_REPORTING_RUNNING_REPORT_HPP
#define ORO_OCL_REPORTING_RUNNING_REPORT_HPP

#include "other_value.hpp"
#include "record.hpp"
#include "report.hpp"
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

/** Marshallers that write reports in a format of their own; either may be null. */
struct Marshallers {
    std::unique_ptr<RTT::marsh::MarshallInterface> header, body;
};

struct ReportOptions {
    RowOptions rows;
    Decomposition decomposition = Decomposition::Members;
    RTT::os::TimeService::ticks begin = 0;  ///< zero of the time stamps
    std::function<void()> onFailure;        ///< called once, by another thread, when the sink has failed
};

/** A table, or what marshallers make, of fixed sources. */
class RunningReport final : public Report {
public:
    /** Reads all sources and takes their values apart. `sink` may be null; `marshallers` must outlive this. */
    RunningReport(const Sources& sources, const ReportOptions& options, std::unique_ptr<RowSink> sink,
                  const std::vector<Marshallers>& marshallers);

    /** Real-time safe if copying the values is. */
    bool read() override;
    /** Writes a row of the values that were read. Without marshallers, allocates only if a value has grown. */
    void writeRow() override;
    void clearPorts() override;
    void wakeOnData(bool on) override;
    void finish() override;
    unsigned long lost() const override { return writer_ ? writer_->lost() : 0; }
    bool failed() const override { return writer_ && writer_->failed(); }

private:
    struct Entry {
        Entry(std::shared_ptr<Source> from, ValueTree columns) : source(std::move(from)), tree(std::move(columns)) {}

        std::shared_ptr<Source> source;
        ValueTree tree;
        bool changed = true;  // since the last row
        bool wanted = true;   // included in this row
        std::string last;     // the last record of a value without a port, to see whether it has changed
    };
    void chooseEntries();
    bool hasChanged(Entry& entry);
    void encodeRow(double time);
    void writeHeader();
    Field fields() const;
    void pushFields();
    void fill(RTT::PropertyBag& bag, double time);
    void push(const Record& record);
    void makeRoom();
    void warnOfTypesWithoutText() const;

    const ReportOptions options_;
    const std::vector<Marshallers>& marshallers_;
    OtherValues others_;
    std::vector<Entry> entries_;
    Record record_, part_;
    bool otherFields_ = true;  // the writer does not know the present fields
    bool everLost_ = false;
    std::unique_ptr<RowWriter> writer_;  // last: its thread uses others_
};

}  // namespace OCL::reporting

#endif
