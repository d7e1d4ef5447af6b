// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_TINY_DEMARSHALLER_HPP
#define ORO_TINY_DEMARSHALLER_HPP

#include "PropertyDemarshaller.hpp"

namespace RTT {
namespace marsh {

/** Another name of PropertyDemarshaller. */
class RTT_API TinyDemarshaller : public PropertyDemarshaller {
public:
    using PropertyDemarshaller::PropertyDemarshaller;
};

}  // namespace marsh
}  // namespace RTT

#endif
