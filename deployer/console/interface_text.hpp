// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The output of `help NAME` and of a name alone.
#ifndef OROFORGE_CONSOLE_INTERFACE_TEXT_HPP
#define OROFORGE_CONSOLE_INTERFACE_TEXT_HPP

#include "place.hpp"
#include "screen.hpp"
#include "visits.hpp"

#include <string>
#include <vector>

namespace RTT {
class ConfigurationInterface;
class OperationInterface;
class ServiceRequester;
}  // namespace RTT

namespace OCL::console {

/** Describes everything that a component or service provides; operations with arguments and documentation. `around` is
    that of list(). */
void describeInterface(Screen& screen, const NamedObject& target, const std::vector<Gate>& around);
/** Describes an operation, which must exist. */
void describeOperation(Screen& screen, const RTT::OperationInterface& operations, const std::string& name,
                       const std::string& indent);
/** Describes the constants and values that every script sees. */
void describeGlobals(Screen& screen);
void describeRequester(Screen& screen, const RTT::ServiceRequester& requester);
/** Describes a property or attribute and its members, with units and documentation. False if there is none of that
    name. */
bool describeValue(Screen& screen, const RTT::ConfigurationInterface& values, const std::string& name);
/** Describes a type: the values of an enum, members with units and documentation, and what converts to it. False if
    there is none of that name. */
bool describeType(Screen& screen, const std::string& name);
/** Describes a port: its type, its connections, its last sample and how to use it. False if there is none of that
    name. */
bool describePort(Screen& screen, RTT::Service& service, const std::string& name, const std::string& path,
                  const std::vector<Gate>& around);

/** The title of the operations that every component has. */
inline constexpr const char* kUsualOperations = "Operations of every component";
/** Moves the operations that every component has behind the others, and returns where they begin. */
std::vector<std::string>::iterator standardOperationsLast(std::vector<std::string>& names);

/** "bool fill(double level, int times)". */
std::string signatureOf(const RTT::OperationInterface& operations, const std::string& name);

}  // namespace OCL::console

#endif
