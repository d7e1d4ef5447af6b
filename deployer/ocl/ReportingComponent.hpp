// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OCL_REPORTING_COMPONENT_HPP
#define ORO_OCL_REPORTING_COMPONENT_HPP

#include <ocl/OCL.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/marsh/MarshallInterface.hpp>
#include <rtt/rtt-config.h>

#include <functional>
#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

namespace OCL {

namespace reporting {
class Report;
class RowSink;
class Source;
struct ReportOptions;
}  // namespace reporting

/**
 * A component that records output ports, properties and attributes of its peers as a table: a row has a time stamp and
 * one or more columns per value.
 *
 * With a periodic activity it writes a row in each cycle. Otherwise it writes one whenever a port has a new sample or,
 * with the property Snapshot, when snapshot() is called. The property ReportData, which configure() reads, and the
 * operations select what is reported; a change takes effect at the next start().
 *
 * FileReporting and ConsoleReporting determine where rows go. A class of your own may add marshallers.
 */
class OCL_API ReportingComponent : public RTT::TaskContext {
public:
    explicit ReportingComponent(std::string name = "Reporting");
    ~ReportingComponent() override;

    /**
     * Adds a pair of marshallers, which the component then owns: the header gets the first row once, the body gets each
     * row. One of them may be null; false if both are. They are called in this component's thread and allocate. Do not
     * call it while the component runs.
     */
    bool addMarshaller(RTT::marsh::MarshallInterface* header, RTT::marsh::MarshallInterface* body);
    bool removeMarshallers();

    // --- operations; false, and an error in the log, if there is no such peer or port ---
    /** Writes the present interface of a peer. */
    virtual bool screenComponent(const std::string& component);
    /** Reports all output ports of a peer. */
    bool reportComponent(const std::string& component);
    bool unreportComponent(const std::string& component);
    /** Reports a property or attribute of a peer. An unknown name is an error in the log, but returns true. */
    bool reportData(const std::string& component, const std::string& data);
    bool unreportData(const std::string& component, const std::string& data);
    /** Reports an output port of a peer; `port` may be in a service: "service.port". */
    bool reportPort(const std::string& component, const std::string& port);
    bool unreportPort(const std::string& component, const std::string& port);
    /** Writes a row now, unless the activity is periodic or the component does not run. Must be called in this
        component's own thread, in which the operation is executed. */
    void snapshot();

protected:
    bool configureHook() override;
    bool startHook() override;
    void updateHook() override;
    void stopHook() override;
    void cleanupHook() override;

    /** Writes the properties, attributes and ports of a peer. */
    bool screenImpl(const std::string& component, std::ostream& output);
    /** Sets where rows go, from the next start() to the stop() after it. */
    void writeTo(std::unique_ptr<reporting::RowSink> sink);
    typedef std::function<std::unique_ptr<reporting::Report>(const std::vector<std::shared_ptr<reporting::Source>>&,
                                                             const reporting::ReportOptions&)>
        ReportMaker;
    /** Sets what makes the report of the next start(), instead of a table; if it makes none, start() fails. */
    void reportBy(ReportMaker maker);
    /** Calls it with the report that is running, or null. No other thread begins or ends a report meanwhile. */
    void withReport(const std::function<void(reporting::Report*)>& use);

private:
    struct Impl;
    const std::unique_ptr<Impl> impl_;
};

}  // namespace OCL

#endif
