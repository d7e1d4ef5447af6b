// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OCL_REPORTING_REPORTING_STATE_HPP
#define ORO_OCL_REPORTING_REPORTING_STATE_HPP

#include "running_report.hpp"

#include <ocl/ReportingComponent.hpp>
#include <rtt/ConnPolicy.hpp>
#include <rtt/PropertyBag.hpp>
#include <rtt/base/OutputPortInterface.hpp>
#include <rtt/internal/values/newer_properties.hpp>

#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace OCL {

struct ReportingComponent::Impl {
    explicit Impl(ReportingComponent& component) : self(component) {}

    // --- report_entries.cpp; the caller holds `changes` ---
    /** What happens to ports of a component that are reported already. */
    enum class Known {
        ConnectAnew,  ///< with a warning
        Stay
    };
    bool addComponent(const std::string& component, Known known);
    bool addPort(const std::string& component, const std::string& port);
    bool addData(const std::string& component, const std::string& data);
    bool isReported(const std::string& name);
    reporting::Sources::iterator find(const std::string& name);
    /** True if a source of that name is reported and up to date. */
    bool isReportedNow(const std::string& name);
    /** True if the source belongs to the component that is now the peer of that name. */
    bool isUpToDate(const reporting::Source& source) const;
    /** The sources that exist: components may have been destroyed or replaced since their values and ports were
        added. */
    reporting::Sources present();
    /** Replaces a source by the present one of that name. Logs an error and returns false if there is none. */
    bool renew(const reporting::Source& source);
    /** A free name for the component's own port that is connected to that one. */
    std::string freeName(const std::string& component, const std::string& port);
    bool connect(const std::string& component, const std::string& port, RTT::base::OutputPortInterface& output);
    /** Replaces the source of that name, or adds it after all others. */
    void put(std::shared_ptr<reporting::Source> source);
    bool remove(const std::string& name);
    bool removeAllOf(const std::string& component);
    /** Adds what ReportData lists; reports all errors. */
    bool addEntries();
    bool addEntry(const RTT::base::PropertyBase& entry);
    void rememberEntry(const std::string& kind, const std::string& value);
    bool forgetEntry(const std::string& kind, const std::string& value);
    void forgetAll();

    reporting::ReportOptions options() const;
    bool isPeriodic() const;
    bool writeNewRows(reporting::Report& from);
    std::unique_ptr<reporting::Report> makeReport(const reporting::Sources& present);

    ReportingComponent& self;
    /** Files for OCL have none of these; some are of derived classes. */
    const RTT::internal::NewerProperties newer{*self.properties(),
                                               {"RepeatHeader", "ComplexDecompose", "Precision", "Format", "address",
                                                "max_clients", "max_line", "max_backlog"}};

    // Properties
    bool writeHeader = true;
    bool repeatHeader = true;
    bool decompose = true;
    bool complexDecompose = false;
    bool snapshotOnly = false;
    bool synchronize = false;
    bool onlyNewData = false;
    int precision = 6;
    RTT::PropertyBag reportData;
    RTT::ConnPolicy policy = RTT::ConnPolicy::data(RTT::ConnPolicy::LOCK_FREE, true, false);
    unsigned int lostRows = 0;

    std::mutex changes;  // guards the sources, which operations in any thread may change
    reporting::Sources sources;
    std::vector<reporting::Marshallers> marshallers;
    std::unique_ptr<reporting::RowSink> sink;  // for the next report
    ReportMaker maker;                         // instead of the sink

    std::mutex rows;  // held by snapshot() and while the report begins or ends
    std::unique_ptr<reporting::Report> report;
};

}  // namespace OCL

#endif
