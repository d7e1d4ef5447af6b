// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <ocl/ConsoleReporting.hpp>

#include "text_target.hpp"

namespace OCL {

ConsoleReporting::ConsoleReporting(std::string name, std::ostream& console)
    : ReportingComponent(name), console_(console) {}

ConsoleReporting::~ConsoleReporting() { stopForGood(); }

bool ConsoleReporting::startHook() {
    writeTo(reporting::useStream(console_));
    return ReportingComponent::startHook();
}

bool ConsoleReporting::screenComponent(const std::string& component) { return screenImpl(component, console_); }

}  // namespace OCL
