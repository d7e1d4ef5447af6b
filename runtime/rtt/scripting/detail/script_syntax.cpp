// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/script_syntax.hpp>

#include <rtt/scripting/detail/parser.hpp>
#include <rtt/scripting/detail/script_text.hpp>

namespace RTT {
namespace scripting {
namespace detail {

void checkSyntax(const std::string& file, oroforge::diag::Sink& sink) {
    if (const auto text = readScript(file, sink)) (void)parse(*text, file, sink);
}

}  // namespace detail
}  // namespace scripting
}  // namespace RTT
