// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/calls/detail/part_send.hpp>

#include <rtt/Logger.hpp>
#include <rtt/internal/calls/operation_signature.hpp>
#include <rtt/types/TypeInfo.hpp>

#include <algorithm>
#include <stdexcept>

namespace RTT::internal::detail {

namespace {

/** Where the operation's values go, in order; null for one that the caller does not take. Empty if it takes none. */
std::vector<Source> collected(const OperationInterfacePart& part, const std::vector<Source>& values) {
    const OperationSignature signature = part.signature();
    std::vector<Source> given;
    if (!signature.result.isVoid()) given.push_back(values[0]);
    for (std::size_t i = 0; i != signature.arguments.size() && i + 1 != values.size(); ++i)
        if (signature.arguments[i].isOutput()) given.push_back(values[i + 1]);
    if (std::none_of(given.begin(), given.end(), [](const Source& value) { return value != nullptr; })) return {};
    if (given.size() != part.collectArity())
        throw std::runtime_error("what it changes does not follow from the types of its arguments");
    return given;
}

}  // namespace

PartSend::PartSend(const CallerSignature& signature, void* const* arguments, void* result)
    : values_(signature), arguments_(arguments, arguments + signature.arity), result_(result) {
    values_.take(arguments, result);
}

std::unique_ptr<PartSend> PartSend::make(const OperationInterfacePart& part, const CallerSignature& signature,
                                         ExecutionEngine* caller, void* const* arguments, void* result) {
    std::unique_ptr<PartSend> made(new PartSend(signature, arguments, result));
    const Source handle = part.produceHandle();
    if (!handle) return nullptr;
    // Before sending: an operation that cannot be collected must not run.
    made->collectFrom(handle, part);
    const Source sending = part.produceSend(made->values_.arguments(), caller);
    if (!sending || !handle->update(sending.get())) return nullptr;
    auto* const local = DataSource<SentCall::shared_ptr>::narrow(handle.get());
    return local && !local->rvalue() ? nullptr : std::move(made);
}

void PartSend::collectFrom(const Source& handle, const OperationInterfacePart& part) {
    handle_ = SendHandleC(handle, &part, part.getName());
    unsigned index = 0;
    for (const Source& value : collected(part, values_.all())) {
        const types::TypeInfo* const type = part.getCollectType(++index);
        const Source own = type ? type->buildValue() : Source();
        if (value && !takesCollected(*value))
            throw std::runtime_error("what it gives is of type " + value->getType() +
                                     ", which the type system does not know, and can only be called for");
        if (value && (!own || own->hasTypeOf(*value))) {
            handle_.arg(value);
            continue;
        }
        handle_.arg(own);
        if (value) conversions_.push_back(assignment(value, own, "a value that is collected"));
    }
    handle_.check();
}

SendStatus PartSend::collect(bool wait) {
    const SendStatus status = wait ? handle_.collect() : handle_.collectIfDone();
    if (status != SendSuccess) return status;
    for (const Assignment& conversion : conversions_) {
        if (run(*conversion)) continue;
        log(Error) << "operation '" << handle_.getOrp()->getName()
                   << "' was executed, but what it gave could not be converted" << endlog();
        return CollectFailure;
    }
    values_.give(arguments_.data(), result_);
    return status;
}

}  // namespace RTT::internal::detail
