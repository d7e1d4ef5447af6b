// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A place for one sample, whatever its type.
#ifndef ORO_CORELIB_DATA_OBJECT_BASE_HPP
#define ORO_CORELIB_DATA_OBJECT_BASE_HPP

#include <rtt/rtt-config.h>

namespace RTT {
class ConnPolicy;
namespace base {

class RTT_API DataObjectBase {
public:
    /** For lock-free data objects: how many threads use it at once. */
    class RTT_API Options {
    public:
        Options(unsigned int max_threads = 2) : max_threads_(max_threads) {}
        Options(const ConnPolicy& policy);

        unsigned int max_threads() const { return max_threads_; }
        Options& max_threads(unsigned int n) {
            max_threads_ = n;
            return *this;
        }

    private:
        unsigned int max_threads_;
    };

    virtual ~DataObjectBase();
    /** Forgets the sample: NoData until the next Set(). Real-time safe. */
    virtual void clear() = 0;
};

}  // namespace base
}  // namespace RTT

#endif
