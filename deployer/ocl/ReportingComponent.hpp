// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OCL_REPORTING_COMPONENT_HPP
#define ORO_OCL_REPORTING_COMPONENT_HPP

#include <ocl/OCL.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/marsh/MarshallInterface.hpp>
#include <rtt/rtt-config.h>

#include <iosfwd>
#include <memory>
#include <string>

namespace OCL {

namespace reporting {
class TextTarget;
}

/**
 * A component that writes down what its peers' output ports send and what their properties and attributes are, as a table: a
 * row is a time stamp and one or more columns per value.
 *
 * With a periodic activity it writes a row in each cycle. Without, it writes one whenever a port has a new sample, or, with the
 * property Snapshot, when snapshot() is called. What is reported is set by the property ReportData, which configure() reads,
 * or by the operations; a change takes effect with the next start().
 *
 * FileReporting and ConsoleReporting say where the rows go. A class of your own adds marshallers.
 */
class OCL_API ReportingComponent : public RTT::TaskContext {
public:
    explicit ReportingComponent(std::string name = "Reporting");
    ~ReportingComponent() override;

    /** Has each report written by these too, both of which it owns from now on: the header gets the first row once, the body
        gets every row. One of them may be null; false if both are. They allocate and are called in this component's thread. Not
        while the component runs. */
    bool addMarshaller(RTT::marsh::MarshallInterface* header, RTT::marsh::MarshallInterface* body);
    bool removeMarshallers();

    // --- operations; false, and an error in the log, if there is no such peer or port ---
    /** Writes down what the interface of a peer is at this moment. */
    virtual bool screenComponent(const std::string& component);
    /** Reports all output ports of a peer. */
    bool reportComponent(const std::string& component);
    bool unreportComponent(const std::string& component);
    /** Reports a property or attribute of a peer. An unknown name is an error in the log, but not false. */
    bool reportData(const std::string& component, const std::string& data);
    bool unreportData(const std::string& component, const std::string& data);
    /** Reports an output port of a peer; `port` may name one of a service: "service.port". */
    bool reportPort(const std::string& component, const std::string& port);
    bool unreportPort(const std::string& component, const std::string& port);
    /** Writes a row now, unless the activity is periodic or the component does not run. For this component's own thread, in
        which the operation is executed. */
    void snapshot();

protected:
    bool configureHook() override;
    bool startHook() override;
    void updateHook() override;
    void stopHook() override;
    void cleanupHook() override;

    /** Writes the properties, attributes and ports of a peer. */
    bool screenImpl(const std::string& component, std::ostream& output);
    /** Rows go there as text, from the next start() to the stop() after it. */
    void writeTo(std::unique_ptr<reporting::TextTarget> target);

private:
    struct Impl;
    const std::unique_ptr<Impl> impl_;
};

}  // namespace OCL

#endif
