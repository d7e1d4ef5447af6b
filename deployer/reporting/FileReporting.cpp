// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <ocl/FileReporting.hpp>

#include "text_sink.hpp"

#include <rtt/Logger.hpp>

#include <iostream>
#include <sstream>

namespace OCL {

FileReporting::FileReporting(const std::string& name) : ReportingComponent(name) {
    addProperty("ReportFile", reportFile_).doc("The file to write to; it begins anew with each start.");
    addProperty("Format", format_).doc("The format of the rows: columns or csv.");
}

FileReporting::~FileReporting() { stopForGood(); }

bool FileReporting::configureHook() {
    return reporting::textFormat(format_, getName()) && ReportingComponent::configureHook();
}

bool FileReporting::startHook() {
    const auto format = reporting::textFormat(format_, getName());
    if (!format) return false;
    std::string error;
    writeTo(nullptr);  // a start that failed may have left the file open
    std::unique_ptr<reporting::TextTarget> file = reporting::openFile(reportFile_, error);
    if (!file) {
        RTT::log(RTT::Error) << "could not open file '" << reportFile_ << "' for reporting: " << error << RTT::endlog();
        return false;
    }
    writeTo(reporting::textSink(std::move(file), *format));
    return ReportingComponent::startHook();
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
