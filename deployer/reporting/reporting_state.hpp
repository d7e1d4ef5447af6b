// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OCL_REPORTING_REPORTING_STATE_HPP
#define ORO_OCL_REPORTING_REPORTING_STATE_HPP

#include "running_report.hpp"

#include <ocl/ReportingComponent.hpp>
#include <rtt/ConnPolicy.hpp>
#include <rtt/PropertyBag.hpp>

#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace OCL {

struct ReportingComponent::Impl {
    explicit Impl(ReportingComponent& component) : self(component) {}

    // --- report_entries.cpp; the caller holds `changes` ---
    bool addComponent(const std::string& component);
    bool addPort(const std::string& component, const std::string& port);
    bool addData(const std::string& component, const std::string& data);
    bool isReported(const std::string& name) const;
    /** Reported, and not by a port whose component has gone. */
    bool isConnected(const std::string& name) const;
    /** Properties and attributes: their component may have gone, or been replaced, since they were added. */
    void findValuesAnew();
    bool remove(const std::string& name);
    bool removeAllOf(const std::string& component);
    /** What ReportData says; reports all its errors. */
    bool addEntries();
    bool addEntry(const RTT::base::PropertyBase& entry);
    void rememberEntry(const std::string& kind, const std::string& value);
    void forgetEntry(const std::string& kind, const std::string& value);
    void forgetAll();

    reporting::ReportOptions options() const;
    bool isPeriodic() const;
    bool writeNewRows(reporting::RunningReport& from);

    ReportingComponent& self;

    // Properties
    bool writeHeader = true;
    bool repeatHeader = false;
    bool decompose = true;
    bool complexDecompose = false;
    bool snapshotOnly = false;
    bool synchronize = false;
    bool onlyNewData = false;
    int precision = 6;
    RTT::PropertyBag reportData;
    RTT::ConnPolicy policy = RTT::ConnPolicy::data(RTT::ConnPolicy::LOCK_FREE, true, false);
    unsigned int lostRows = 0;

    std::mutex changes;  // of the sources, by operations in any thread
    reporting::Sources sources;
    std::vector<reporting::Marshallers> marshallers;
    std::unique_ptr<reporting::TextTarget> target;  // for the next report

    std::mutex rows;  // held by snapshot() and by those who begin and end the report
    std::unique_ptr<reporting::RunningReport> report;
};

}  // namespace OCL

#endif
