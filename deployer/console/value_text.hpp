// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Writes values as text.
#ifndef OROFORGE_CONSOLE_VALUE_TEXT_HPP
#define OROFORGE_CONSOLE_VALUE_TEXT_HPP

#include <rtt/base/DataSourceBase.hpp>

#include <string>

namespace OCL::console {

/** The value as text: texts in quotes, structs as `{x = 1, y = 2}`, the first elements of sequences as `[1, 2, … 98
    more]`. Numbers are hexadecimal if `hex`. */
std::string valueText(const RTT::base::DataSourceBase::shared_ptr& value, bool hex);

}  // namespace OCL::console

#endif
