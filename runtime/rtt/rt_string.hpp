// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_RT_STRING_HPP
#define ORO_RT_STRING_HPP

#include <rtt/os/oro_allocator.hpp>

#include <string>

namespace RTT {

/**
 * A string with its characters in real-time memory, so that real-time threads may change and send it. Up to 15
 * characters need no memory at all. Throws std::bad_alloc when the memory is used up.
 */
typedef std::basic_string<char, std::char_traits<char>, os::rt_allocator<char>> rt_string;

/** The same text as a std::string. Not real-time safe. */
inline std::string makeString(const rt_string& text) { return std::string(text.data(), text.size()); }

/** The same text in real-time memory. */
inline rt_string makeRTString(const std::string& text) { return rt_string(text.data(), text.size()); }

}  // namespace RTT
#endif
