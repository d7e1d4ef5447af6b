// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_SCRIPTING_DETAIL_FUNCTION_POOL_HPP
#define ORO_SCRIPTING_DETAIL_FUNCTION_POOL_HPP

#include <rtt/os/Mutex.hpp>
#include <rtt/scripting/detail/function/function_call.hpp>

#include <atomic>
#include <memory>

namespace RTT::scripting::detail {

/** The executions of one function: compiles another one when all are taken. */
class FunctionPool : public std::enable_shared_from_this<FunctionPool> {
public:
    /** Keeps the functions that can be called by it. */
    FunctionPool(std::shared_ptr<const FunctionDefinition> definition, const Surroundings& where);
    ~FunctionPool();
    FunctionPool(const FunctionPool&) = delete;
    FunctionPool& operator=(const FunctionPool&) = delete;

    const std::shared_ptr<FunctionOwner>& owner() const { return owner_; }
    const FunctionDefinition& definition() const { return *definition_; }
    /** One that nobody else has; null, with the errors in `sink`, if it does not compile. Any thread; allocates, blocks. */
    FunctionCall::shared_ptr take(oroforge::diag::Sink& sink);
    /** The same; throws std::runtime_error with the first of the errors. */
    FunctionCall::shared_ptr take();
    /** By the last one who has it. Any thread; real-time safe, unless the pool is gone but for this. */
    static void giveBack(FunctionCall* call) noexcept;

private:
    FunctionCall* takeFree();
    FunctionCall* make(oroforge::diag::Sink& sink);

    const std::shared_ptr<const FunctionDefinition> definition_;
    const Functions functions_;
    Surroundings where_;
    const std::shared_ptr<FunctionOwner> owner_;
    os::Mutex lock_;
    FunctionCall* free_ = nullptr;                  // under the lock
    std::atomic<FunctionCall*> returned_{nullptr};  // anybody adds, takeFree() takes all
};

}  // namespace RTT::scripting::detail

#endif
