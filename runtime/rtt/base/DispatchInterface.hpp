// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_DISPATCH_INTERFACE_HPP
#define ORO_DISPATCH_INTERFACE_HPP

#include <rtt/base/DisposableInterface.hpp>

namespace RTT {
namespace base {

/** A message that queues itself. */
class RTT_API DispatchInterface : public DisposableInterface {
public:
    /** Queues this; false if it was refused. */
    virtual bool dispatchI() = 0;
};

}  // namespace base
}  // namespace RTT

#endif
