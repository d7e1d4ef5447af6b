// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_ACTION_INTERFACE_HPP
#define ORO_ACTION_INTERFACE_HPP

#include <rtt/rtt-config.h>
#include <map>

namespace RTT {
namespace base {

class DataSourceBase;

/**
 * One executable step on data, such as an assignment. Run in two phases: readArguments() evaluates the
 * right-hand sides, execute() applies them. Both are as real-time safe as the copied types are; neither
 * may be called from two threads at a time.
 */
class RTT_API ActionInterface {
public:
    ActionInterface() = default;
    ActionInterface(const ActionInterface&) = delete;
    ActionInterface& operator=(const ActionInterface&) = delete;
    virtual ~ActionInterface();

    /** Evaluates the values for execute(). */
    virtual void readArguments() = 0;
    /** Runs the action; false if it failed. */
    virtual bool execute() = 0;
    /** Makes the action ready to be run again. */
    virtual void reset();
    /** True if the last execute() was accepted. */
    virtual bool valid() const;

    /** A new action on the same data. The caller owns it. */
    virtual ActionInterface* clone() const = 0;
    /** A new action on copies of the data; `alreadyCloned` maps originals to copies. */
    virtual ActionInterface* copy(std::map<const DataSourceBase*, DataSourceBase*>& alreadyCloned) const;
};

}  // namespace base
}  // namespace RTT

#endif
