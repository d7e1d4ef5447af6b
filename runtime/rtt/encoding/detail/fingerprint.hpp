// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_ENCODING_DETAIL_FINGERPRINT_HPP
#define ORO_ENCODING_DETAIL_FINGERPRINT_HPP

#include <rtt/encoding/detail/form.hpp>

#include <cstdint>

namespace RTT {
namespace encoding {
namespace detail {

/** See Plan::fingerprint(). */
std::uint64_t fingerprintOf(const Form& form);

}  // namespace detail
}  // namespace encoding
}  // namespace RTT

#endif
