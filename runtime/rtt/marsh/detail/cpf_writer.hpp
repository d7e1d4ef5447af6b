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

/** Replaces the file as a whole or not at all; false, and an error in the log, if it cannot be written. */
RTT_API bool writeFile(const std::string& file, const std::string& text);

}  // namespace marsh
}  // namespace RTT

#endif
