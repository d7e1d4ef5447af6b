// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_SCRIPTING_DETAIL_FUNCTION_POOL_HPP
#define ORO_SCRIPTING_DETAIL_FUNCTION_POOL_HPP

#include <rtt/os/Mutex.hpp>
#include <rtt/scripting/detail/function/function_call.hpp>

#include <atomic>
#include <memory>

namespace RTT::scripting::detail {

/** The executions of one function. Compiles another one when all are in use. */
class FunctionPool : public std::enable_shared_from_this<FunctionPool> {
public:
    /** Keeps the functions that it can call. */
    FunctionPool(std::shared_ptr<const FunctionDefinition> definition, const CompileContext& where);
    ~FunctionPool();
    FunctionPool(const FunctionPool&) = delete;
    FunctionPool& operator=(const FunctionPool&) = delete;

    const std::shared_ptr<FunctionOwner>& owner() const { return owner_; }
    const FunctionDefinition& definition() const { return *definition_; }
    /** An unused execution. If the function does not compile, reports errors to `sink` and returns null. Any thread;
        allocates, blocks. */
    FunctionCall::shared_ptr take(oroforge::diag::Sink& sink);
    /** The same; throws std::runtime_error with the first of the errors. */
    FunctionCall::shared_ptr take();
    /** Called when the last reference is gone. Any thread; real-time safe, unless this was the last reference to the
        pool. */
    static void giveBack(FunctionCall* call) noexcept;

private:
    FunctionCall* takeFree();
    FunctionCall* make(oroforge::diag::Sink& sink);

    const std::shared_ptr<const FunctionDefinition> definition_;
    const Functions functions_;
    CompileContext where_;
    const std::shared_ptr<FunctionOwner> owner_;
    os::Mutex lock_;
    FunctionCall* free_ = nullptr;                  // guarded by the lock
    std::atomic<FunctionCall*> returned_{nullptr};  // any thread adds, takeFree() takes all
};

}  // namespace RTT::scripting::detail

#endif
