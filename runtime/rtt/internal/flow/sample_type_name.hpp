// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The name of the type of samples in messages, and whether two ports have the same definition of it.
#ifndef ORO_INTERNAL_SAMPLE_TYPE_NAME_HPP
#define ORO_INTERNAL_SAMPLE_TYPE_NAME_HPP

#include <rtt/rtt-config.h>
#include <string>

namespace RTT {
namespace base {
class PortInterface;
}
namespace types {
struct TypeOps;
}
namespace internal {

/** The name that a typekit gave the type, or its C++ name if none did. Not real-time safe. */
RTT_API std::string sampleTypeName(const base::PortInterface& port);
RTT_API std::string sampleTypeName(const types::TypeOps& ops);

/** Empty if the two local ports can exchange samples. If their plugins were built with different versions of a header:
    a sentence that names the first difference. For ports whose types have the same C++ name. Not real-time safe. */
RTT_API std::string sampleDifference(const base::PortInterface& a, const base::PortInterface& b);

}  // namespace internal
}  // namespace RTT

#endif
