// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OCL_REPORTING_ROW_SINK_HPP
#define ORO_OCL_REPORTING_ROW_SINK_HPP

#include "fields.hpp"

#include <chrono>
#include <cstddef>
#include <string>

namespace OCL::reporting {

/** What a sink must know of its report. */
struct RowOptions {
    std::string component;     ///< the reporter
    bool header = true;        ///< begin with the names of the columns, if the format can do without
    bool repeatHeader = true;  ///< also when there are more columns
    bool onlyNewData = false;  ///< rows have gaps
    bool decompose = true;     ///< elements of sequences have columns of their own
    int digits = 6;            ///< of numbers with a fraction, if the format does not need all
};

/** Writes rows in one format to one place. Used by the writing thread, but for the first two functions. The report ends
    when one of the others throws. */
class RowSink {
public:
    virtual ~RowSink() = default;
    /** Called once, before the thread starts. */
    virtual void prepare(const RowOptions&) {}
    /** True if values with members are taken apart even without the property Decompose. */
    virtual bool hasStructure() const { return false; }

    /** Sets what the following records consist of. `record` is a row that shows the present size of sequences. */
    virtual void fields(const Field& report, const char* record, std::size_t size) = 0;
    /** Takes a row, which may wait until write(). */
    virtual void row(const char* record, std::size_t size) = 0;
    /** The number of bytes that wait. */
    virtual std::size_t waiting() const = 0;
    /** Writes all rows that wait. Returns the reason of a failure, after which the report ends, or nothing. */
    virtual std::string write() = 0;
    /** The number of rows that wait; after a failure, of those that it lost. */
    virtual unsigned long rows() const = 0;
    /** How long the last rows may take when the report ends, until the others are lost. */
    virtual std::chrono::milliseconds patience() const { return std::chrono::hours(24 * 365); }
    /** The name of the target in errors. */
    virtual std::string name() const = 0;
};

}  // namespace OCL::reporting

#endif
