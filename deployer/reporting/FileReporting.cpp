// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <ocl/FileReporting.hpp>

#include "text_target.hpp"

#include <rtt/Logger.hpp>

#include <iostream>
#include <sstream>

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
    if (component.find('/') != std::string::npos) {
        RTT::log(RTT::Error) << "could not screen component '" << component
                             << "': a name with a '/' would write to another folder" << RTT::endlog();
        return false;
    }
    const std::string name = component + ".screen";
    std::string error;
    std::ostringstream text;
    if (!screenImpl(component, text)) return false;
    if (const std::unique_ptr<reporting::TextTarget> file = reporting::openFile(name, error))
        error = file->write(text.str().data(), text.str().size());
    if (error.empty()) return true;
    RTT::log(RTT::Error) << "could not write file '" << name << "': " << error << RTT::endlog();
    return false;
}

}  // namespace OCL
