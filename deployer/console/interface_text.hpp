// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What `help NAME` and a name alone show.
#ifndef OROFORGE_CONSOLE_INTERFACE_TEXT_HPP
#define OROFORGE_CONSOLE_INTERFACE_TEXT_HPP

#include "place.hpp"
#include "screen.hpp"

#include <string>
#include <vector>

namespace RTT {
class ConfigurationInterface;
class OperationInterface;
class ServiceRequester;
}  // namespace RTT

namespace OCL::console {

/** Everything that a component or service provides, operations with their arguments and documentation. */
void describeInterface(Screen& screen, const Target& target);
/** One operation, which there is. */
void describeOperation(Screen& screen, const RTT::OperationInterface& operations, const std::string& name,
                       const std::string& indent);
/** The constants and values that every script sees. */
void describeGlobals(Screen& screen);
void describeRequester(Screen& screen, const RTT::ServiceRequester& requester);
/** One property or attribute, with its members, their units and documentation. False if there is none of that name. */
bool describeValue(Screen& screen, const RTT::ConfigurationInterface& values, const std::string& name);
/** A type: its values if it is an enum, its members with their units and documentation, what converts to it. False if there is
    none of that name. */
bool describeType(Screen& screen, const std::string& name);
/** One port: its type, connections and how to use it. False if there is none of that name. */
bool describePort(Screen& screen, RTT::Service& service, const std::string& name, const std::string& path);

/** Above the operations that every component has. */
inline constexpr const char* kUsualOperations = "Operations of every component";
/** Puts them behind those of the component itself; where they begin. */
std::vector<std::string>::iterator standardOperationsLast(std::vector<std::string>& names);

/** "bool fill(double level, int times)". */
std::string signatureOf(const RTT::OperationInterface& operations, const std::string& name);

}  // namespace OCL::console

#endif
