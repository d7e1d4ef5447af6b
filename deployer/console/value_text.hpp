// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Writes values as text.
#ifndef OROFORGE_CONSOLE_VALUE_TEXT_HPP
#define OROFORGE_CONSOLE_VALUE_TEXT_HPP

#include <rtt/base/DataSourceBase.hpp>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace OCL::console {

/** The value as text: texts in quotes, structs as `{x = 1, y = 2}`, the first elements of sequences as `[1, 2, … 98
    more]`. Numbers are hexadecimal if `hex`. */
std::string valueText(const RTT::base::DataSourceBase::shared_ptr& value, bool hex);

/** The members of a struct, the properties of a bag, or the first elements of a sequence, as "[0]", with the number of
    further ones in `left`. Empty for other values. */
std::vector<std::pair<std::string, RTT::base::DataSourceBase::shared_ptr>> partsOf(
    const RTT::base::DataSourceBase::shared_ptr& value, std::size_t& left);

}  // namespace OCL::console

#endif
