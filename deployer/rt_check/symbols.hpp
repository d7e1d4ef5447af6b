// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_RT_CHECK_SYMBOLS_HPP
#define OROFORGE_RT_CHECK_SYMBOLS_HPP

namespace oroforge::rt_check {

/**
 * "'Class::function(int)' (file+0x1234)" for a return address, without the parts that are unknown. The offset is that
 * of the call, as addr2line needs it. Never freed.
 */
char* describeFrame(void* returnAddress);

/** True if `frame`, a text of describeFrame(), is a function of the pool of real-time memory. */
bool isMemoryPoolFunction(const char* frame) noexcept;

}  // namespace oroforge::rt_check

#endif
