// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The <simple> values of property files: text to property, and back.
#ifndef ORO_CPF_VALUES_HPP
#define ORO_CPF_VALUES_HPP

#include <rtt/PropertyBag.hpp>
#include <string>

namespace RTT {
namespace marsh {

/** What reading one value came to. */
struct SimpleValue {
    base::PropertyBase* property = nullptr;  ///< new; null if the text is not such a value
    bool knownType = true;
    bool trailingText = false;  ///< a number was followed by something else
    bool outOfRange = false;    ///< it is a number that the type does not have
    const char* expected = "";  ///< what such a value looks like
};

/** A new property of the type that `type` names in property files. */
SimpleValue readSimple(const std::string& type, const std::string& name, const std::string& description,
                       const std::string& text);

/** Sets `type` and `text` to what stands for the value in a property file; false if its type has no such form. */
bool writeSimple(const base::PropertyBase& property, std::string& type, std::string& text);

/** True if `name` is a type whose values are sequences of any length. */
bool isSequenceType(const std::string& name);

}  // namespace marsh
}  // namespace RTT

#endif
