// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A queue of samples of any type.
#ifndef ORO_BUFFER_BASE_HPP
#define ORO_BUFFER_BASE_HPP

#include <rtt/base/StorageUsers.hpp>
#include <rtt/rtt-config.h>

#include <boost/shared_ptr.hpp>

namespace RTT {
class ConnPolicy;
namespace base {

class RTT_API BufferBase {
public:
    typedef int size_type;
    typedef boost::shared_ptr<BufferBase> shared_ptr;

    class RTT_API Options : public StorageUsers {
    public:
        Options(bool circular = false) : circular_(circular) {}
        Options(bool circular, unsigned int max_threads) : circular_(circular) { setThreads(max_threads); }
        Options(const ConnPolicy& policy);

        /** When full, drop the oldest sample instead of the new one. */
        bool circular() const { return circular_; }
        Options& circular(bool on) {
            circular_ = on;
            return *this;
        }
        /** The number of threads that use a lock-free buffer at once. */
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

    private:
        bool circular_;
    };

    virtual ~BufferBase();
    virtual size_type capacity() const = 0;
    virtual size_type size() const = 0;
    virtual bool empty() const = 0;
    virtual bool full() const = 0;
    virtual void clear() = 0;
    /** The number of samples lost because the buffer was full. */
    virtual size_type dropped() const = 0;
};

}  // namespace base
}  // namespace RTT

#endif
