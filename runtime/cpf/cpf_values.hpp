// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Converts the <simple> values of property files to properties and back.
#ifndef ORO_CPF_VALUES_HPP
#define ORO_CPF_VALUES_HPP

#include <rtt/PropertyBag.hpp>
#include <string>

namespace RTT {
namespace marsh {

/** The result of reading one value. */
struct SimpleValue {
    base::PropertyBase* property = nullptr;  ///< owned by the caller; null if the text is not such a value
    bool knownType = true;
    bool trailingText = false;  ///< the number is followed by other text
    bool outOfRange = false;    ///< the number does not fit into the type
    const char* expected = "";  ///< what the message expects instead
};

/** Makes a property of the type that property files call `type`. */
SimpleValue readSimple(const std::string& type, const std::string& name, const std::string& description,
                       const std::string& text);

/** Sets `type` and `text` as a property file writes them; false if the type of the value has no such form. */
bool writeSimple(const base::PropertyBase& property, std::string& type, std::string& text);

/** True if `name` is the type of a sequence of any length. */
bool isSequenceType(const std::string& name);

}  // namespace marsh
}  // namespace RTT

#endif
