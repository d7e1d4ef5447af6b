// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "Operators.hpp"

#include "Types.hpp"
#include <mutex>

namespace RTT::types {

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
    /** Those of that sign and number of operands that `fits`. */
    template <class Fits>
    std::vector<ErasedFunction> candidates(const std::string& op, std::size_t arity, Fits fits) {
        std::lock_guard<std::mutex> lock(mutex);
        std::vector<ErasedFunction> found;
        for (const auto& entry : entries)
            if (entry.function.arity == arity && entry.op == op && fits(entry.function))
                found.push_back(entry.function);
        return found;
    }
    template <class Op>
    void takeOver(Op* op, const char* prefix, std::size_t arity) {
        const std::unique_ptr<Op> owned(op);
        if (owned && owned->function.arity == arity) add(prefix + owned->op, owned->function);
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

void OperatorRepository::add(UnaryOp* op) { state_->takeOver(op, "", 1); }
void OperatorRepository::add(BinaryOp* op) { state_->takeOver(op, "", 2); }
void OperatorRepository::add(TernaryOp* op) { state_->takeOver(op, "", 3); }
void OperatorRepository::add(DotOp* op) { state_->takeOver(op, ".", 1); }

void OperatorRepository::add(const OperatorRow* rows, std::size_t count) {
    for (std::size_t i = 0; i != count; ++i) {
        ErasedFunction function;
        function.call = rows[i].call;
        function.result = rows[i].result;
        function.arity = rows[i].second ? 2 : 1;
        function.arguments = {rows[i].first, rows[i].second};
        state_->add(rows[i].op, function);
    }
}

DataSourceBase* OperatorRepository::apply(const std::string& op,
                                          const std::vector<DataSourceBase::shared_ptr>& operands) const {
    for (const auto& operand : operands)
        if (!operand) return nullptr;
    // Of several operands the first decides which operators there are.
    const bool single = operands.size() == 1;
    const auto candidates = state_->candidates(op, operands.size(), [&](const ErasedFunction& function) {
        return single || function.accepts(0, *operands[0]);
    });
    for (const auto& function : candidates)
        if (auto made = function.apply(operands)) return DataSourceBase::release(std::move(made));
    for (const auto& function : candidates) {
        auto converted = operands;
        for (std::size_t i = single ? 0 : 1; i != operands.size(); ++i)
            if (const TypeInfo* wanted = Types()->getTypeById(function.arguments[i]()))
                converted[i] = wanted->convert(operands[i]);
        if (auto made = function.apply(converted)) return DataSourceBase::release(std::move(made));
    }
    return nullptr;
}

DataSourceBase* OperatorRepository::applyUnary(const std::string& op, DataSourceBase* operand) {
    return apply(op, {operand});
}

DataSourceBase* OperatorRepository::applyBinary(const std::string& op, DataSourceBase* first, DataSourceBase* second) {
    return apply(op, {first, second});
}

DataSourceBase* OperatorRepository::applyTernary(const std::string& op, DataSourceBase* first, DataSourceBase* second,
                                                 DataSourceBase* third) {
    return apply(op, {first, second, third});
}

DataSourceBase* OperatorRepository::applyDot(const std::string& name, DataSourceBase* value) {
    return apply('.' + name, {value});
}

}  // namespace RTT::types
