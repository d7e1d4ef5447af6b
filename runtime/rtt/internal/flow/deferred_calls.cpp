// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/flow/deferred_calls.hpp>

namespace RTT::internal {

bool DeferredCalls::add(Call* own, Function function, void* argument) noexcept {
    if (!own) {
        std::uint32_t i = 0;
        while (i != kSpare && (spareUsed_ & (1u << i))) ++i;
        if (i == kSpare) return false;
        spareUsed_ |= 1u << i;
        own = &spare_[i];
    }
    *own = {function, argument, nullptr};
    (first_ ? last_->next : first_) = own;
    last_ = own;
    return true;
}

void DeferredCalls::run() {
    // A called function may write to ports and come here again.
    Batch batch{first_, nullptr, batches_};
    first_ = last_ = nullptr;
    batches_ = &batch;
    while (Call* const next = batch.first) {
        const Call call = *next;
        batch.first = call.next;
        if (isSpare(next)) spareUsed_ &= ~(1u << (next - spare_));
        batch.argument = call.argument;
        if (batch.argument) call.function(batch.argument);
    }
    batches_ = batch.outer;
}

unsigned DeferredCalls::cancel(const void* argument) noexcept {
    Batch waiting{first_, nullptr, batches_};
    const unsigned found = cancel(&waiting, argument);
    first_ = last_ = nullptr;
    prepend(waiting.first);
    return found;
}

void DeferredCalls::prepend(Call* first) noexcept {
    if (!first) return;
    Call* last = first;
    while (last->next) last = last->next;
    last->next = first_;
    first_ = first;
    if (!last_) last_ = last;
}

// The memory of a call may vanish with its argument, so the call is taken out. A spare one stays in its place, because
// only its own thread may mark it as free.
unsigned DeferredCalls::cancel(Batch* batch, const void* argument) noexcept {
    unsigned found = 0;
    for (; batch; batch = batch->outer)
        for (Call** link = &batch->first; Call* const call = *link;) {
            if (call->argument != argument) {
                link = &call->next;
                continue;
            }
            ++found;
            call->argument = nullptr;
            if (isSpare(call))
                link = &call->next;
            else
                *link = call->next;
        }
    return found;
}

unsigned DeferredCalls::making(const void* argument) const noexcept {
    unsigned found = 0;
    for (const Batch* batch = batches_; batch; batch = batch->outer) found += batch->argument == argument;
    return found;
}

unsigned DeferredCalls::abandon(const void* argument) noexcept { return abandon(batches_, argument); }

unsigned DeferredCalls::abandon(Batch* batch, const void* argument) noexcept {
    unsigned found = 0;
    for (; batch; batch = batch->outer)
        if (batch->argument == argument) {
            batch->argument = nullptr;
            ++found;
        }
    return found;
}

}  // namespace RTT::internal
