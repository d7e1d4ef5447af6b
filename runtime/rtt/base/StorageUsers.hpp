// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The number of threads that use a buffer or a data object, according to its options.
#ifndef ORO_STORAGE_USERS_HPP
#define ORO_STORAGE_USERS_HPP

#include <rtt/rtt-config.h>

namespace RTT {
class ConnPolicy;
namespace base {

/** The number of threads that may use a lock-free storage at once: given, or derived from its writers and readers. */
class RTT_API StorageUsers {
public:
    /** The given number. If that is 0: 2, plus 10 for several writers, plus 10 for several readers. */
    unsigned int max_threads() const {
        return max_threads_ != 0 ? max_threads_ : 2 + (several_writers_ ? 10 : 0) + (several_readers_ ? 10 : 0);
    }
    bool multiple_writers() const { return several_writers_; }
    bool multiple_readers() const { return several_readers_; }

protected:
    StorageUsers() = default;
    /** The users of a connection with that policy. */
    explicit StorageUsers(const ConnPolicy& policy);
    void setThreads(unsigned int number) { max_threads_ = number; }
    void setSeveralWriters(bool on) { several_writers_ = on; }
    void setSeveralReaders(bool on) { several_readers_ = on; }

private:
    unsigned int max_threads_ = 0;
    bool several_writers_ = false, several_readers_ = false;
};

}  // namespace base
}  // namespace RTT

#endif
