// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OS_TERMINAL_BUFFER_HPP
#define ORO_OS_TERMINAL_BUFFER_HPP

#include <rtt/rtt-config.h>

#include <streambuf>

namespace RTT {
namespace os {

/** Base of a buffer that code puts into std::cerr for a time and that passes all text on to the terminal: the log keeps
    its colours there. */
class RTT_API TerminalBuffer : public std::streambuf {};

}  // namespace os
}  // namespace RTT
#endif
