// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_CONSOLE_VALUE_TABLE_HPP
#define OROFORGE_CONSOLE_VALUE_TABLE_HPP

#include "screen.hpp"

#include <rtt/PropertyBag.hpp>

namespace RTT {
class ConfigurationInterface;
}

namespace OCL::console {

/** Writes name, type, value, unit and documentation of properties. The unit is the end of the documentation, in
    brackets. */
void writeProperties(Screen& screen, const RTT::PropertyBag& bag, const std::string& indent);
/** Writes name, type and value of attributes and constants. */
void writeAttributes(Screen& screen, const RTT::ConfigurationInterface& values, const std::string& indent);

/** Splits "the level [m]" into "the level" and "m". */
void splitUnit(std::string& doc, std::string& unit);

}  // namespace OCL::console

#endif
