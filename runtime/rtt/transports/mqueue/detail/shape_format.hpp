// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The messages of types that have no transporter of their own.
#ifndef ORO_MQUEUE_DETAIL_SHAPE_FORMAT_HPP
#define ORO_MQUEUE_DETAIL_SHAPE_FORMAT_HPP

#include <rtt/transports/mqueue/message_format.hpp>

namespace RTT {
namespace types {
class TypeInfo;
}
namespace mqueue {
namespace detail {

/** That of the original toolchain for the types that it sends; for all others a fingerprint of the type's definition, 8
    bytes, and the sample in CDR. Null, with the reason in `why`, if the type has no shape. */
std::unique_ptr<MessageFormat> newFormatOf(const types::TypeInfo& type, std::string& why);

}  // namespace detail
}  // namespace mqueue
}  // namespace RTT

#endif
