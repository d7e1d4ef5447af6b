// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <ocl/ConsoleReporting.hpp>

#include "text_sink.hpp"

namespace OCL {

ConsoleReporting::ConsoleReporting(std::string name, std::ostream& console)
    : ReportingComponent(name), console_(console) {
    addProperty("Format", format_).doc("The format of the rows: columns or csv.");
}

ConsoleReporting::~ConsoleReporting() { stopForGood(); }

bool ConsoleReporting::configureHook() {
    return reporting::textFormat(format_, getName()) && ReportingComponent::configureHook();
}

bool ConsoleReporting::startHook() {
    const auto format = reporting::textFormat(format_, getName());
    if (!format) return false;
    writeTo(reporting::textSink(reporting::useStream(console_), *format));
    return ReportingComponent::startHook();
}

bool ConsoleReporting::screenComponent(const std::string& component) { return screenImpl(component, console_); }

}  // namespace OCL
