// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_SIZE_LIMIT_HPP
#define ORO_SIZE_LIMIT_HPP

#include <rtt/rtt-config.h>

#include <cstddef>
#include <string>

namespace RTT {
namespace types {

/**
 * Limits how many elements or letters scripts may ask for at once, in `var array a(n)`, `array(n)` and the like, so
 * that a wrong number cannot use up the memory of the machine. Any thread, real-time safe.
 */
RTT_API void setSizeLimit(std::size_t elements) noexcept;
RTT_API std::size_t sizeLimit() noexcept;
/** The initial limit. */
constexpr std::size_t kUsualSizeLimit = 10'000'000;

/** Real-time safe. */
inline bool isWithinSizeLimit(std::size_t elements) noexcept { return elements <= sizeLimit(); }
/** "N elements: ..." for errors; names the option of the deployer that raises the limit. */
RTT_API std::string beyondSizeLimit(std::size_t elements);

}  // namespace types
}  // namespace RTT

#endif
