// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_DISPOSABLE_INTERFACE_HPP
#define ORO_DISPOSABLE_INTERFACE_HPP

#include <rtt/rtt-config.h>

#include <boost/shared_ptr.hpp>

namespace RTT {
namespace base {

/** A message for an ExecutionEngine: executed once in its thread, or disposed of if that will never happen. */
class RTT_API DisposableInterface {
public:
    typedef boost::shared_ptr<DisposableInterface> shared_ptr;

    virtual ~DisposableInterface();
    /** Executes and then releases itself. */
    virtual void executeAndDispose() = 0;
    /** Releases itself without executing. */
    virtual void dispose() = 0;
    /** True if the execution threw. */
    virtual bool isError() const;
};

}  // namespace base
}  // namespace RTT

#endif
