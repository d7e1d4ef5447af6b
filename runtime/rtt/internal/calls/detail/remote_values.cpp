// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/calls/detail/remote_values.hpp>

#include <rtt/internal/DataSources.hpp>
#include <rtt/internal/calls/operation_signature.hpp>
#include <rtt/types/TypeInfo.hpp>
#include <rtt/types/TypeInfoRepository.hpp>
#include <rtt/types/TypeOps.hpp>
#include <rtt/types/Types.hpp>

#include <boost/core/demangle.hpp>

#include <stdexcept>

namespace RTT::internal::detail {

namespace {

/** Refers to a value of a type that the type system does not know. */
class AddressSource final : public base::DataSourceBase {
public:
    typedef void (*Assign)(void* to, const void* from);
    AddressSource(const std::type_info& type, Assign assign) : type_(type), assign_(assign) {}
    void refer(void* at) { at_ = at; }
    bool takesValues() const { return assign_ != nullptr; }

    bool evaluate() const override { return true; }
    bool isAssignable() const override { return true; }
    bool assignValue(const void* value) override {
        if (!assign_ || !at_) return false;
        assign_(at_, value);
        return true;
    }
    const std::type_info* getTypeId() const override { return &type_; }
    void* getRawPointer() override { return at_; }
    const void* getRawConstPointer() override { return at_; }
    std::string getType() const override { return boost::core::demangle(type_.name()); }
    const types::TypeInfo* getTypeInfo() const override { return DataSourceTypeInfo<UnknownType>::getTypeInfo(); }
    AddressSource* clone() const override {
        auto* const made = new AddressSource(type_, assign_);
        made->refer(at_);
        return made;
    }
    AddressSource* copy(std::map<const DataSourceBase*, DataSourceBase*>&) const override {
        return const_cast<AddressSource*>(this);
    }

private:
    const std::type_info& type_;
    const Assign assign_;
    void* at_ = nullptr;
};

Source makeSource(const CallerValue& value, AddressSource::Assign assign) {
    const types::TypeInfo* const info = types::Types()->getTypeById(value.type);
    if (info && info->getOps())
        if (const Source variable = info->buildValue()) return variable;
    return new AddressSource(*value.type, assign);
}

/** For arguments that the caller does not want back. */
void discard(void*, const void*) {}

/** Assigns the value of a variable that makeSource() made. */
void assign(void* to, base::DataSourceBase& from) {
    from.getTypeInfo()->getOps()->assign(to, from.getRawConstPointer());
}

}  // namespace

bool takesCollected(base::DataSourceBase& value) {
    const auto* const address = dynamic_cast<const AddressSource*>(&value);
    return !address || address->takesValues();
}

Assignment assignment(const Source& to, const Source& from, const char* what) {
    try {
        return Assignment(to->updateAction(from.get()));
    } catch (const bad_assignment&) {
        throw std::runtime_error(std::string(what) + " is of type " + from->getType() + ", not " + to->getType());
    }
}

bool run(base::ActionInterface& assignment) {
    assignment.readArguments();
    return assignment.execute();
}

CallerSources::CallerSources(const CallerSignature& signature) : signature_(signature) {
    const bool hasResult = *signature.values[0].type != typeid(void);
    if (hasResult && !signature.assignResult)
        throw std::runtime_error("its result would be a reference, cannot be assigned, or has no default value");
    sources_.push_back(hasResult ? makeSource(signature.values[0], signature.assignResult) : nullptr);
    for (unsigned i = 1; i <= signature.arity; ++i) {
        const CallerValue& value = signature.values[i];
        sources_.push_back(makeSource(value, value.isOutput ? nullptr : &discard));
    }
}

void CallerSources::expectFrom(const Source& call) {
    call_ = call;
    if (!sources_[0] || call->hasTypeOf(*sources_[0])) return;
    const types::TypeInfo* const type = call->getTypeInfo();
    if (type && type->getOps()) received_ = type->buildValue();
    convert_ = assignment(sources_[0], received_ ? received_ : call, "its result");
}

Outcome CallerSources::execute() const {
    // Calls first and then converts, to know which of the two failed.
    if (received_ || !convert_) {
        if (!call_->evaluate()) return Outcome::notExecuted;
        if (!convert_) return Outcome::done;
        if (!received_->assignValue(call_->getRawConstPointer())) return Outcome::notConverted;
    }
    return run(*convert_) ? Outcome::done : Outcome::notConverted;
}

void CallerSources::take(void* const* arguments, void* result) {
    for (unsigned i = 0; i <= signature_.arity; ++i) {
        void* const at = i == 0 ? result : arguments[i - 1];
        if (auto* const address = dynamic_cast<AddressSource*>(sources_[i].get()))
            address->refer(at);
        else if (i != 0)
            sources_[i]->assignValue(at);
    }
}

void CallerSources::give(void* const* arguments, void* result) const {
    for (unsigned i = 0; i != signature_.arity; ++i) {
        base::DataSourceBase& source = *sources_[i + 1];
        if (signature_.values[i + 1].isOutput && source.getRawConstPointer() != arguments[i])
            assign(arguments[i], source);
    }
    if (!sources_[0]) return;
    const void* const value = (call_ && !convert_ ? *call_ : *sources_[0]).getRawConstPointer();
    if (value && value != result) signature_.assignResult(result, value);
}

void checkOutputs(const OperationInterfacePart& part, const CallerSignature& signature) {
    unsigned index = 0;
    for (const OperationSignature::Value& argument : part.signature().arguments) {
        if (++index > signature.arity) return;  // reported elsewhere
        if (argument.isOutput() && signature.values[index].isConstant)
            throw std::runtime_error("argument " + std::to_string(index) +
                                     " is changed by it, the caller's is constant");
    }
}

}  // namespace RTT::internal::detail
