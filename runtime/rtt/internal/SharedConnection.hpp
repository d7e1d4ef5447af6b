// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A named storage with any number of writers and readers.
#ifndef ORO_SHARED_CONNECTION_HPP
#define ORO_SHARED_CONNECTION_HPP

#include <rtt/ConnPolicy.hpp>
#include <rtt/base/ChannelElementBase.hpp>

#include <atomic>
#include <map>
#include <string>
#include <vector>

namespace RTT {
namespace types {
struct Schema;
struct TypeOps;
}  // namespace types
namespace base {
class PortInterface;
}
namespace internal {

/** Exists as long as a port is connected to it or a pointer refers to it. */
class RTT_API SharedConnectionBase {
public:
    typedef boost::intrusive_ptr<SharedConnectionBase> shared_ptr;

    SharedConnectionBase(const std::string& name, base::ChannelElementBase::shared_ptr storage,
                         const ConnPolicy& policy, const base::PortInterface& first);

    const std::string& getName() const { return policy_.name_id; }
    const ConnPolicy& getPolicy() const { return policy_; }
    const base::ChannelElementBase::shared_ptr& storage() const { return storage_; }
    const types::TypeOps& ops() const { return ops_; }
    /** How the type of the port's samples differs from that of the first port, as a sentence; empty if it does not. */
    std::string difference(const base::PortInterface& port) const;

    void ref() { references_.fetch_add(1, std::memory_order_relaxed); }
    void deref();

private:
    friend class ConnectionManager;
    friend class SharedConnectionRepository;
    ~SharedConnectionBase();
    struct Member {
        const base::PortInterface* port;
        bool input;
    };
    void removeMember(const base::PortInterface& port);
    /** A new reference; null if the last one is gone already. */
    shared_ptr revive();

    base::ChannelElementBase::shared_ptr storage_;
    ConnPolicy policy_;
    const types::TypeOps& ops_;
    const types::Schema& schema_;
    std::vector<Member> members_;  // guarded by the lock of all connections
    std::atomic<int> references_{0};
};

inline void intrusive_ptr_add_ref(SharedConnectionBase* connection) { connection->ref(); }
inline void intrusive_ptr_release(SharedConnectionBase* connection) { connection->deref(); }

/** Finds the shared connections of the process by name; does not keep them alive. Thread-safe, takes a lock. */
class RTT_API SharedConnectionRepository {
public:
    static SharedConnectionRepository& Instance();

    /** Null if there is none of that name. */
    SharedConnectionBase::shared_ptr get(const std::string& name);
    /** `connection`, or the existing one of the same name. */
    SharedConnectionBase::shared_ptr add(SharedConnectionBase::shared_ptr connection);
    /** A name that no shared connection has had. */
    std::string uniqueName();

private:
    friend class SharedConnectionBase;
    SharedConnectionRepository() = default;
    void forget(SharedConnectionBase& connection);

    std::map<std::string, SharedConnectionBase*> connections_;
    unsigned long counter_ = 0;
};

}  // namespace internal
}  // namespace RTT

#endif
