// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/function/function_pool.hpp>

#include <rtt/ExecutionEngine.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/os/MutexLock.hpp>
#include <rtt/types/conversion_watch.hpp>

#include <diag/print.hpp>

#include <stdexcept>

namespace RTT::scripting::detail {

namespace {

/** The functions that this thread is compiling: after a redefinition, a function may call itself by the name of its
    operation. */
struct Making {
    const FunctionPool* const pool;
    const Making* const outer;
    static thread_local const Making* innermost;

    explicit Making(const FunctionPool* made) : pool(made), outer(innermost) { innermost = this; }
    ~Making() { innermost = outer; }
    static bool includes(const FunctionPool* pool) {
        for (const Making* making = innermost; making; making = making->outer)
            if (making->pool == pool) return true;
        return false;
    }
};
thread_local const Making* Making::innermost = nullptr;

}  // namespace

FunctionPool::FunctionPool(std::shared_ptr<const FunctionDefinition> definition, const CompileContext& where)
    : definition_(std::move(definition)),
      functions_(where.functions && !definition_->functions ? *where.functions : Functions()),
      where_(where),
      owner_(std::make_shared<FunctionOwner>()) {
    where_.functions = &functions_;
    where_.known = nullptr;
    where_.caller = where.component->engine();
    where_.file = definition_->file;
    where_.text = definition_->text;
    where_.sink = nullptr;
    owner_->function = definition_->name;
    owner_->component = where.component->getName();
    owner_->file = definition_->file;
    owner_->text = definition_->text;
    owner_->gate = where.component->engine()->gate();
    owner_->roundLimit = where.roundLimit;
}

FunctionPool::~FunctionPool() {
    while (FunctionCall* const call = takeFree()) delete call;
}

FunctionCall* FunctionPool::takeFree() {
    const os::MutexLock lock(lock_);
    if (!free_) free_ = returned_.exchange(nullptr, std::memory_order_acquire);
    FunctionCall* const taken = free_;
    if (taken) free_ = taken->next_;
    return taken;
}

FunctionCall* FunctionPool::make(oroforge::diag::Sink& sink) {
    const ast::Place at = definition_->tree->name.at;
    const oroforge::diag::Location place{definition_->file, at.line, at.column};
    if (owner_->gate->closed()) {
        sink.error(place, "OPS206", owner_->describe() + " cannot be called: the component was destroyed");
        return nullptr;
    }
    if (Making::includes(this)) {
        sink.error(place, "OPS207", owner_->describe() + " calls itself");
        return nullptr;
    }
    const Making making(this);
    CompileContext where = where_;
    where.sink = &sink;
    const auto peers = where.peers = std::make_shared<Peers>();
    std::unique_ptr<Activation> activation = Compiler(std::move(where)).function(*definition_);
    return activation ? new FunctionCall(owner_, std::move(activation), peers) : nullptr;
}

FunctionCall::shared_ptr FunctionPool::take(oroforge::diag::Sink& sink) {
    FunctionCall* call = takeFree();
    if (!call) call = make(sink);
    if (call) call->pool_ = shared_from_this();
    return call;
}

FunctionCall::shared_ptr FunctionPool::take() {
    // Warnings about conversions were given where it was defined.
    const types::detail::ConversionWatch unheard;
    oroforge::diag::Sink sink;
    FunctionCall::shared_ptr call = take(sink);
    if (call) return call;
    for (const auto& diagnostic : sink.sorted())
        if (diagnostic.severity == oroforge::diag::Severity::Error)
            throw std::runtime_error(oroforge::diag::toString(diagnostic));
    throw std::runtime_error(owner_->describe() + " does not compile any more");
}

void FunctionPool::giveBack(FunctionCall* call) noexcept {
    const std::shared_ptr<FunctionPool> pool = std::move(call->pool_);
    FunctionCall* first = pool->returned_.load(std::memory_order_relaxed);
    do call->next_ = first;
    while (!pool->returned_.compare_exchange_weak(first, call, std::memory_order_release, std::memory_order_relaxed));
}

}  // namespace RTT::scripting::detail
