// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Holds one sample of any type.
#ifndef ORO_CORELIB_DATA_OBJECT_BASE_HPP
#define ORO_CORELIB_DATA_OBJECT_BASE_HPP

#include <rtt/base/StorageUsers.hpp>
#include <rtt/rtt-config.h>

namespace RTT {
class ConnPolicy;
namespace base {

class RTT_API DataObjectBase {
public:
    /** For lock-free data objects: the number of threads that use one at once. */
    class RTT_API Options : public StorageUsers {
    public:
        Options() = default;
        Options(unsigned int max_threads) { setThreads(max_threads); }
        Options(const ConnPolicy& policy);

        using StorageUsers::max_threads;
        Options& max_threads(unsigned int n) {
            setThreads(n);
            return *this;
        }
        using StorageUsers::multiple_writers;
        Options& multiple_writers(bool on) {
            setSeveralWriters(on);
            return *this;
        }
        using StorageUsers::multiple_readers;
        Options& multiple_readers(bool on) {
            setSeveralReaders(on);
            return *this;
        }
    };

    virtual ~DataObjectBase();
    /** Drops the sample: NoData until the next Set(). Real-time safe. */
    virtual void clear() = 0;
};

}  // namespace base
}  // namespace RTT

#endif
