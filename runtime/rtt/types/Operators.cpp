// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "Operators.hpp"

#include "Types.hpp"
#include <mutex>

namespace RTT {
namespace types {

using base::DataSourceBase;

struct OperatorRepository::State {
    struct Entry {
        std::string op;
        ErasedFunction function;
    };
    std::mutex mutex;
    std::vector<Entry> entries;

    void add(std::string op, ErasedFunction function) {
        std::lock_guard<std::mutex> lock(mutex);
        entries.push_back({std::move(op), std::move(function)});
    }
    /** Those of that sign and number of operands whose first operand fits. */
    std::vector<ErasedFunction> candidates(const std::string& op, std::size_t arity, const DataSourceBase& first) {
        std::lock_guard<std::mutex> lock(mutex);
        std::vector<ErasedFunction> found;
        for (const auto& entry : entries)
            if (entry.function.arity == arity && entry.op == op && entry.function.accepts(0, first))
                found.push_back(entry.function);
        return found;
    }
};

OperatorRepository::OperatorRepository() : state_(new State) {}

OperatorRepository::~OperatorRepository() = default;

OperatorRepository::shared_ptr OperatorRepository::Instance() {
    // Never destroyed, as the types are not.
    static auto* instance = new shared_ptr(new OperatorRepository());
    return *instance;
}

OperatorRepository::shared_ptr operators() { return OperatorRepository::Instance(); }

void OperatorRepository::add(UnaryOp* op) {
    const std::unique_ptr<UnaryOp> owned(op);
    if (owned && owned->function.arity == 1) state_->add(owned->op, owned->function);
}

void OperatorRepository::add(BinaryOp* op) {
    const std::unique_ptr<BinaryOp> owned(op);
    if (owned && owned->function.arity == 2) state_->add(owned->op, owned->function);
}

void OperatorRepository::add(const OperatorRow* rows, std::size_t count) {
    for (std::size_t i = 0; i != count; ++i) {
        ErasedFunction function;
        function.call = rows[i].call;
        function.result = rows[i].result;
        function.arity = rows[i].second ? 2 : 1;
        function.arguments = {rows[i].first, rows[i].second, nullptr};
        state_->add(rows[i].op, function);
    }
}

DataSourceBase* OperatorRepository::applyUnary(const std::string& op, DataSourceBase* operand) {
    const DataSourceBase::shared_ptr source(operand);
    if (!source) return nullptr;
    for (const auto& function : state_->candidates(op, 1, *source))
        if (auto made = function.apply({source})) return DataSourceBase::release(std::move(made));
    return nullptr;
}

DataSourceBase* OperatorRepository::applyBinary(const std::string& op, DataSourceBase* first, DataSourceBase* second) {
    const DataSourceBase::shared_ptr a(first), b(second);
    if (!a || !b) return nullptr;
    const auto candidates = state_->candidates(op, 2, *a);
    for (const auto& function : candidates)
        if (auto made = function.apply({a, b})) return DataSourceBase::release(std::move(made));
    for (const auto& function : candidates) {
        const TypeInfo* wanted = Types()->getTypeById(function.arguments[1]());
        const auto converted = wanted ? wanted->convert(b) : b;
        if (auto made = function.apply({a, converted})) return DataSourceBase::release(std::move(made));
    }
    return nullptr;
}

}  // namespace types
}  // namespace RTT
