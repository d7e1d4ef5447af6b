// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <ocl/NetcdfReporting.hpp>

#include "netcdf_writer.hpp"

#include <ocl/Component.hpp>
#include <rtt/Logger.hpp>
#include <rtt/plugin/shared_library.hpp>

namespace OCL {
namespace {

const char kHere = 0;

/** The module is beside this library, in a folder where nobody looks for component libraries. */
std::unique_ptr<reporting::RowSink> openFile(const std::string& name, std::string& error) {
    using RTT::plugin::SharedLibrary;
    const std::string here = SharedLibrary::fileWith(&kHere);
    const std::string file =
        here.substr(0, here.rfind('/') + 1) + "netcdf/libocl-netcdf-writer-" OROCOS_TARGET_NAME ".so";
    SharedLibrary module(file, SharedLibrary::Local, error);
    auto* const open = module ? module.function<decltype(oclNetcdfSink)>("oclNetcdfSink") : nullptr;
    if (!open) {
        error = "cannot load '" + file + "': " + (module ? "it is of another version" : error) +
                "; Debian has this file in oroforge-netcdf, and what it needs in libnetcdf19";
        return nullptr;
    }
    module.keep();
    return std::unique_ptr<reporting::RowSink>(open(name, error));
}

}  // namespace

NetcdfReporting::NetcdfReporting(const std::string& name) : ReportingComponent(name) {
    addProperty("ReportFile", reportFile_).doc("The NetCDF file to write to; it begins anew with each start.");
}

NetcdfReporting::~NetcdfReporting() { stopForGood(); }

bool NetcdfReporting::startHook() {
    std::string error;
    writeTo(nullptr);  // a start that failed may have left the file open
    std::unique_ptr<reporting::RowSink> file = openFile(reportFile_, error);
    if (!file) {
        RTT::log(RTT::Error) << "could not create '" << reportFile_ << "' for reporting: " << error << RTT::endlog();
        return false;
    }
    writeTo(std::move(file));
    return ReportingComponent::startHook();
}

}  // namespace OCL

ORO_CREATE_COMPONENT_LIBRARY()
ORO_LIST_COMPONENT_TYPE(OCL::NetcdfReporting)
