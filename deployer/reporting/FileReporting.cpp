// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <ocl/FileReporting.hpp>

#include "screen_file.hpp"
#include "text_target.hpp"

#include <rtt/Logger.hpp>

#include <iostream>

namespace OCL {

FileReporting::FileReporting(const std::string& name) : ReportingComponent(name) {
    addProperty("ReportFile", reportFile_).doc("The file to write to; it begins anew with each start.");
}

FileReporting::~FileReporting() { stopForGood(); }

bool FileReporting::startHook() {
    std::string error;
    writeTo(nullptr);  // a start that failed may have left the file open
    writeTo(reporting::openFile(reportFile_, error));
    if (!error.empty())
        RTT::log(RTT::Error) << "could not open file '" << reportFile_ << "' for reporting: " << error << RTT::endlog();
    return error.empty() && ReportingComponent::startHook();
}

bool FileReporting::screenComponent(const std::string& component) {
    if (!getPeer(component)) return screenImpl(component, std::cerr);  // which reports the error
    return reporting::writeScreenFile(component, [&](std::ostream& to) { return screenImpl(component, to); });
}

}  // namespace OCL
