// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_SIGNAL_BASE_HPP
#define ORO_SIGNAL_BASE_HPP

#include <rtt/rtt-config.h>

#include <atomic>
#include <memory>
#include <mutex>
#include <vector>

namespace RTT {
namespace internal {

/** The connections of a signal, without the type of their functions. */
class RTT_API SignalBase {
public:
    /** One function that is, or was, or will be called. */
    class RTT_API Connection : public std::enable_shared_from_this<Connection> {
    public:
        virtual ~Connection();
        bool connect();
        bool disconnect();
        bool connected() const { return connected_.load(std::memory_order_acquire); }
        /** The signal lets go of it. */
        void orphan();

    private:
        friend class SignalBase;
        std::mutex mutex_;
        SignalBase* signal_ = nullptr;
        std::atomic<bool> connected_{false};
    };
    typedef std::shared_ptr<Connection> ConnectionPtr;
    typedef std::vector<ConnectionPtr> Connections;

    SignalBase() = default;
    virtual ~SignalBase();
    SignalBase(const SignalBase&) = delete;
    SignalBase& operator=(const SignalBase&) = delete;

    /** The number of arguments of the functions. */
    virtual int arity() const = 0;

protected:
    void add(const ConnectionPtr& connection, bool connect);
    /** The functions at this moment, in order of connection; null if none. The list never changes, it is replaced. */
    std::shared_ptr<const Connections> snapshot() const;

private:
    void change(const ConnectionPtr& connection, bool present);

    std::mutex mutex_;
    std::shared_ptr<const Connections> connections_;
    std::atomic<bool> any_{false};
};

}  // namespace internal
}  // namespace RTT

#endif
