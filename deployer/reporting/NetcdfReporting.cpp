// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <ocl/NetcdfReporting.hpp>

#include "netcdf_sink.hpp"

#include <ocl/Component.hpp>
#include <rtt/Logger.hpp>

namespace OCL {

NetcdfReporting::NetcdfReporting(const std::string& name) : ReportingComponent(name) {
    addProperty("ReportFile", reportFile_).doc("The NetCDF file to write to; it begins anew with each start.");
}

NetcdfReporting::~NetcdfReporting() { stopForGood(); }

bool NetcdfReporting::startHook() {
    std::string error;
    writeTo(nullptr);  // a start that failed may have left the file open
    std::unique_ptr<reporting::NetcdfFile> file = reporting::NetcdfFile::open(reportFile_, error);
    if (!file) {
        RTT::log(RTT::Error) << "could not create '" << reportFile_ << "' for reporting: " << error << RTT::endlog();
        return false;
    }
    writeTo(reporting::netcdfSink(std::move(file)));
    return ReportingComponent::startHook();
}

}  // namespace OCL

ORO_CREATE_COMPONENT_LIBRARY()
ORO_LIST_COMPONENT_TYPE(OCL::NetcdfReporting)
