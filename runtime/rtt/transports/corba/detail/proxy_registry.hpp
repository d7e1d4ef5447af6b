// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_CORBA_DETAIL_PROXY_REGISTRY_HPP
#define ORO_CORBA_DETAIL_PROXY_REGISTRY_HPP

#include <rtt/transports/corba/TaskContextC.h>
#include <rtt/transports/corba/corba.h>

#include <condition_variable>
#include <list>
#include <memory>
#include <mutex>

namespace RTT {
namespace corba {
class TaskContextProxy;
namespace detail {

/** All proxies of this process, so that a component of another one has one. Any thread may use it. */
class ProxyRegistry {
    struct Entry {
        TaskContextProxy* proxy;
        unsigned holders;  // guarded by the mutex of the registry
    };

public:
    /** While one exists, remove() of the proxy does not return, so that nobody destroys it. */
    class Held {
    public:
        Held() = default;
        explicit Held(std::shared_ptr<Entry> entry) : entry_(std::move(entry)) {}
        Held(Held&&) = default;
        Held& operator=(Held&&) = delete;
        ~Held();
        /** Null if there is none. */
        TaskContextProxy* get() const { return entry_ ? entry_->proxy : nullptr; }

    private:
        std::shared_ptr<Entry> entry_;
    };

    static ProxyRegistry& instance();

    void add(TaskContextProxy& proxy);
    /** Nobody finds it any more. Blocks while somebody holds it. Nothing happens if it is not there. */
    void remove(TaskContextProxy& proxy);
    /** The first that was added for that component. */
    Held find(CTaskContext_ptr task);
    /** Adds `made`, unless another thread has added one for that component meanwhile: gives that which is there. */
    Held addOrFind(TaskContextProxy& made, CTaskContext_ptr task);

private:
    /** Only while the mutex is held. */
    Held findLocked(CTaskContext_ptr task);

    std::mutex mutex_;
    std::condition_variable left_;
    std::list<std::shared_ptr<Entry>> all_;
};

}  // namespace detail
}  // namespace corba
}  // namespace RTT

#endif
