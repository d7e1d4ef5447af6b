// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/syntax/script_text.hpp>

#include <cerrno>
#include <fstream>
#include <sstream>
#include <system_error>

namespace RTT::scripting::detail {

std::optional<std::string> readScript(const std::string& file, oroforge::diag::Sink& sink) {
    std::ifstream in(file, std::ios::binary);
    std::ostringstream text;
    // A directory can be opened but not read.
    if (in && (in.peek() == std::ifstream::traits_type::eof() ? in.eof() && !in.bad() : bool(text << in.rdbuf())))
        return text.str();
    sink.error({file, 0, 0}, "OPS411", "cannot read the script: " + std::generic_category().message(errno));
    return std::nullopt;
}

}  // namespace RTT::scripting::detail
