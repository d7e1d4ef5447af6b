// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/CallSource.hpp>

#include <rtt/internal/OperationTable.hpp>

namespace RTT {
namespace internal {

GenericCall::GenericCall(boost::shared_ptr<base::OperationCallerInterface> caller, const OperationTable& table,
                         std::vector<Source> arguments)
    : caller_(std::move(caller)), table_(&table), arguments_(std::move(arguments)), addresses_(arguments_.size() + 1) {}

void GenericCall::evaluateArguments() const {
    for (std::size_t i = 0; i != arguments_.size(); ++i) {
        base::DataSourceBase& source = *arguments_[i];
        source.evaluate();
        addresses_[i] =
            table_->types[i + 1].isOutput() ? source.getRawPointer() : const_cast<void*>(source.getRawConstPointer());
    }
}

void GenericCall::invoke(void* result) const {
    evaluateArguments();
    table_->invoke(*caller_, addresses_.data(), result);
    for (std::size_t i = 0; i != arguments_.size(); ++i)
        if (table_->types[i + 1].isOutput()) arguments_[i]->updated();
}

SentCall::shared_ptr GenericCall::send() const {
    evaluateArguments();
    return table_->send(*caller_, addresses_.data());
}

GenericCall GenericCall::copy(CopyMap& cloned) const {
    std::vector<Source> arguments;
    for (const Source& argument : arguments_) arguments.push_back(argument->copy(cloned));
    return GenericCall(caller_, *table_, std::move(arguments));
}

template class CallSource<void>;
template class CallSource<bool>;
template class CallSource<int>;
template class CallSource<unsigned>;
template class CallSource<double>;
template class CallSource<std::string>;
template class CallSource<FlowStatus>;
template class CallSource<WriteStatus>;

}  // namespace internal
}  // namespace RTT
