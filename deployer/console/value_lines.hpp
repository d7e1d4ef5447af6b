// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_CONSOLE_VALUE_LINES_HPP
#define OROFORGE_CONSOLE_VALUE_LINES_HPP

#include <rtt/base/DataSourceBase.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace OCL::console {

/** The parts of a value that has some, as "name = value" where that fits into `width`, else as "name" with its own
    parts below it. At most `most` lines, the last of which then says that there are more. Empty if the value has no
    parts. */
std::vector<std::string> valueLines(const RTT::base::DataSourceBase::shared_ptr& value, bool hex, std::size_t width,
                                    std::size_t most);

}  // namespace OCL::console

#endif
