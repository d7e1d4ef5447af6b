// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_EXTRAS_FILE_DESCRIPTOR_ACTIVITY_INTERFACE_HPP
#define ORO_EXTRAS_FILE_DESCRIPTOR_ACTIVITY_INTERFACE_HPP

#include <rtt/rtt-config.h>

namespace RTT {
namespace extras {

/**
 * The interface, for a component, of the activity that waits for its file descriptors:
 *
 *     if (auto* io = dynamic_cast<extras::FileDescriptorActivityInterface*>(getActivity())) io->watch(fd);
 *
 * isUpdated(), hasTimeout() and hasError() tell in updateHook() why it was called. All functions may be called from any
 * thread.
 */
class RTT_API FileDescriptorActivityInterface {
public:
    virtual ~FileDescriptorActivityInterface();

    /** Wakes the component when `fd` can be read, is at its end or has failed. Logs an error if `fd` is negative. */
    virtual void watch(int fd) = 0;
    /** Must be called before `fd` is closed. */
    virtual void unwatch(int fd) = 0;
    virtual void clearAllWatches() = 0;
    virtual bool isWatched(int fd) const = 0;
    /** True if `fd` was ready when the component was last woken. */
    virtual bool isUpdated(int fd) const = 0;
    /** True if the component was last woken because the time of setTimeout() was over and no descriptor was ready. */
    virtual bool hasTimeout() const = 0;
    /** True if the component was last woken because waiting failed. */
    virtual bool hasError() const = 0;

    /**
     * Wakes the component when no descriptor was ready for this time; 0, the default, means never. The time begins with
     * this call. Logs an error and ignores a negative time.
     */
    virtual void setTimeout(int milliseconds) = 0;
    virtual void setTimeout_us(int microseconds) = 0;
    virtual int getTimeout() const = 0;
    virtual int getTimeout_us() const = 0;
};

}  // namespace extras
}  // namespace RTT
#endif
