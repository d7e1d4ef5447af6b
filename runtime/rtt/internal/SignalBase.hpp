// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_SIGNAL_BASE_HPP
#define ORO_SIGNAL_BASE_HPP

#include <rtt/rtt-config.h>

#include <boost/smart_ptr/intrusive_ptr.hpp>

#include <atomic>
#include <memory>
#include <mutex>
#include <vector>

namespace RTT {
namespace internal {

/** The connections of a signal, without the type of their functions. */
class RTT_API SignalBase {
public:
    /** One function with its subscription, which may be ended and renewed. */
    class RTT_API Connection : public std::enable_shared_from_this<Connection> {
    public:
        virtual ~Connection();
        /** Calls the function, with pointers to the arguments. */
        virtual void call(void* const* arguments) const = 0;
        bool connect();
        bool disconnect();
        bool connected() const { return connected_.load(std::memory_order_acquire); }
        /** Detaches it from its signal for good. */
        void orphan();

    private:
        friend class SignalBase;
        std::mutex mutex_;
        SignalBase* signal_ = nullptr;
        std::atomic<bool> connected_{false};
    };
    typedef std::shared_ptr<Connection> ConnectionPtr;

    SignalBase() = default;
    virtual ~SignalBase();
    SignalBase(const SignalBase&) = delete;
    SignalBase& operator=(const SignalBase&) = delete;

    /** The number of arguments of the functions. */
    virtual int arity() const = 0;
    /** Adds a function; without `connect` its handle can connect it later. Not real-time safe. */
    void add(const ConnectionPtr& connection, bool connect);
    /** Calls all connected functions with pointers to the arguments. Never locks; real-time safe if they are. */
    void emitErased(void* const* arguments) const;

private:
    struct List;
    friend void intrusive_ptr_add_ref(const List* list);
    friend void intrusive_ptr_release(const List* list);

    boost::intrusive_ptr<const List> snapshot() const;
    void change(const ConnectionPtr& connection, bool present);

    std::mutex mutex_;
    std::atomic<const List*> connected_{nullptr};  // null: none. A list never changes; it is replaced.
    std::vector<std::weak_ptr<Connection>> made_;  // connected or not
};

}  // namespace internal
}  // namespace RTT

#endif
