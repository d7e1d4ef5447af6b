// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_REPORTING_REPORT_HPP
#define OROFORGE_REPORTING_REPORT_HPP

namespace OCL::reporting {

/** What becomes of samples and values from start() to stop() of a reporter. Used by one thread at a time. */
class Report {
public:
    virtual ~Report() = default;

    /** Reads all sources; true if a port had a new sample. */
    virtual bool read() = 0;
    /** Writes what was read. */
    virtual void writeRow() = 0;
    /** Forgets samples that came before the report. */
    virtual void clearPorts() = 0;
    /** Selects whether new samples wake the component. */
    virtual void wakeOnData(bool on) = 0;
    /** Waits until everything is written. */
    virtual void finish() = 0;
    /** The number of rows or messages that are lost. */
    virtual unsigned long lost() const = 0;
    /** True if nothing more can be written. */
    virtual bool failed() const = 0;
};

}  // namespace OCL::reporting

#endif
