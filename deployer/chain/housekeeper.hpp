// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_CHAIN_HOUSEKEEPER_HPP
#define OROFORGE_CHAIN_HOUSEKEEPER_HPP

#include <rtt/base/DisposableInterface.hpp>

#include <atomic>
#include <mutex>

namespace OCL::chain {

/** Does work of a chain in the thread of the GlobalEngine, if a real-time thread asks for it. Made once; the chain and
    the queue both own it, because it may still be queued when the chain is destroyed. */
class Housekeeper : public RTT::base::DisposableInterface {
public:
    typedef void (*Work)(void* chain);
    Housekeeper(Work work, void* chain) : work_(work), chain_(chain) {}

    /** The work will be done soon, once for all requests until it begins. Any thread; real-time safe. */
    void request();
    /** Waits for the work in progress; none is done afterwards. The owner's last call. */
    void dismiss();

    void executeAndDispose() override;
    void dispose() override;
    bool isError() const override { return false; }

private:
    ~Housekeeper() override = default;
    void release();

    const Work work_;
    std::mutex mutex_;
    void* chain_;  // guarded by mutex_; null once dismissed
    std::atomic<bool> queued_{false};
    std::atomic<int> owners_{1};
};

}  // namespace OCL::chain

#endif
