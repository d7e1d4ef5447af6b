// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_CPF_WRITER_HPP
#define ORO_CPF_WRITER_HPP

#include <rtt/PropertyBag.hpp>
#include <string>

namespace RTT {
namespace marsh {

/** The text of a property file. Values of types that cannot be taken apart are left out, with an error in the log. */
RTT_API std::string cpfText(const PropertyBag& bag);

/** Puts the head and the root element of a property file around the items. */
RTT_API std::string cpfFrame(const std::string& items);

/** The element for one property, indented and with a line end; empty if the property is left out. */
RTT_API std::string cpfItem(base::PropertyBase& property, std::size_t indent);

/** Replaces the file as a whole or not at all. Logs an error and returns false if it cannot be written. */
RTT_API bool writeFile(const std::string& file, const std::string& text);

}  // namespace marsh
}  // namespace RTT

#endif
