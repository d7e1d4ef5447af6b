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

/** Name, type, value, unit and documentation of properties. The unit is what stands at the end of the documentation in
    brackets. */
void writeProperties(Screen& screen, const RTT::PropertyBag& bag, const std::string& indent);
/** Name, type and value of attributes and constants. */
void writeAttributes(Screen& screen, const RTT::ConfigurationInterface& values, const std::string& indent);

/** "the level [m]" → "the level" and "m". */
void splitUnit(std::string& doc, std::string& unit);

}  // namespace OCL::console

#endif
