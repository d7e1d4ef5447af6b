// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/values/value_place.hpp>

#include <rtt/base/ActionInterface.hpp>

namespace RTT::internal {

ValuePlace::ValuePlace(base::DataSourceBase* parent_) : parent(parent_) {}

ValuePlace::~ValuePlace() = default;

namespace {

char* beginOf(base::DataSourceBase& source) {
    return static_cast<char*>(source.isAssignable() ? source.getRawPointer()
                                                    : const_cast<void*>(source.getRawConstPointer()));
}

}  // namespace

PartOffset::PartOffset(void* at, base::DataSourceBase& parent)
    : at_(at), offset_(static_cast<const char*>(at) - beginOf(parent)) {}

void* PartOffset::movedIn(base::DataSourceBase& copyOfParent) const { return beginOf(copyOfParent) + offset_; }

PartPlace::PartPlace(void* at, base::DataSourceBase* parent, const types::TypeOps& ops)
    : ValuePlace(parent), offset_(at, *parent), ops_(ops) {}

bool PartPlace::evaluate() const { return parent->evaluate(); }

void* PartPlace::value() const { return offset_.addressIn(*parent); }

void* PartPlace::get() const { return value(); }

void* PartPlace::forChange() { return value(); }

void PartPlace::assign(const void* from) {
    ops_.assign(value(), from);
    parent->updated();
}

void PartPlace::updated() { parent->updated(); }

bool PartPlace::isAssignable() const { return true; }

bool PartPlace::isFixed() const { return parent->hasFixedAddress(); }

ValuePlace* PartPlace::clone() const { return new PartPlace(value(), parent.get(), ops_); }

ValuePlace* PartPlace::copy(std::map<const base::DataSourceBase*, base::DataSourceBase*>& cloned) const {
    base::DataSourceBase* const copied = parent->copy(cloned);
    return new PartPlace(offset_.movedIn(*copied), copied, ops_);
}

ElementPlace::ElementPlace(base::DataSourceBase* parent, base::DataSourceBase* index, const types::SequenceOps* ops,
                           base::DataSourceBase* spare, void (*reset)(void*))
    : ValuePlace(parent), index_(index), ops_(ops), spare_(spare), spareAt_(spare->getRawPointer()), reset_(reset) {}

bool ElementPlace::evaluate() const { return parent->evaluate() && index_->evaluate(); }

std::size_t ElementPlace::position() const {
    const void* value = index_->getRawConstPointer();
    if (*index_->getTypeId() == typeid(unsigned int)) return *static_cast<const unsigned int*>(value);
    // A negative index becomes one beyond the end of any container.
    return static_cast<std::size_t>(static_cast<long long>(*static_cast<const int*>(value)));
}

bool ElementPlace::load(void* element) const {
    const void* container = parent->getRawConstPointer();
    const std::size_t at = position();
    if (!container || at >= ops_->size(container)) return false;
    ops_->load(container, at, element);
    return true;
}

bool ElementPlace::store(const void* element) const {
    void* container = parent->getRawPointer();
    const std::size_t at = position();
    if (!container || !ops_->store || at >= ops_->size(container)) return false;
    ops_->store(container, at, element);
    parent->updated();
    return true;
}

void* ElementPlace::element(bool forWriting) const {
    if (ops_->at) {
        void* container = forWriting ? parent->getRawPointer() : const_cast<void*>(parent->getRawConstPointer());
        const std::size_t at = position();
        if (void* found = container && at < ops_->size(container) ? ops_->at(container, at) : nullptr) return found;
    }
    if (!load(spareAt_)) reset_(spareAt_);
    return spareAt_;
}

void* ElementPlace::value() const { return element(false); }

void* ElementPlace::get() const {
    evaluate();
    return element(false);
}

void* ElementPlace::forChange() {
    evaluate();
    return element(true);
}

void ElementPlace::assign(const void* value) {
    evaluate();
    // If elements have no address, updated() may follow and store the spare value again.
    if (!ops_->at) spare_->assignValue(value);
    store(value);
}

void ElementPlace::updated() {
    if (!ops_->at)
        store(spareAt_);
    else
        parent->updated();
}

bool ElementPlace::isAssignable() const { return (ops_->at || ops_->store) && parent->isAssignable(); }

bool ElementPlace::isFixed() const { return false; }

ValuePlace* ElementPlace::clone() const {
    return new ElementPlace(parent.get(), index_.get(), ops_, spare_->clone(), reset_);
}

ValuePlace* ElementPlace::copy(std::map<const base::DataSourceBase*, base::DataSourceBase*>& cloned) const {
    return new ElementPlace(parent->copy(cloned), index_->copy(cloned), ops_, spare_->clone(), reset_);
}

ActionPlace::ActionPlace(base::ActionInterface* action, base::DataSourceBase* parent)
    : ValuePlace(parent), action_(action) {}

ActionPlace::~ActionPlace() = default;

bool ActionPlace::evaluate() const {
    action_->readArguments();
    return action_->execute() && parent->evaluate();
}

void* ActionPlace::value() const { return const_cast<void*>(parent->getRawConstPointer()); }

void* ActionPlace::get() const {
    action_->readArguments();
    action_->execute();
    parent->evaluate();
    return value();
}

void* ActionPlace::forChange() { return value(); }

void* ActionPlace::raw() { return nullptr; }

void ActionPlace::assign(const void*) {}

void ActionPlace::updated() {}

bool ActionPlace::isAssignable() const { return false; }

void ActionPlace::reset() {
    parent->reset();
    action_->reset();
}

bool ActionPlace::isFixed() const { return false; }

bool ActionPlace::isPart() const { return false; }

ValuePlace* ActionPlace::clone() const { return new ActionPlace(action_->clone(), parent.get()); }

ValuePlace* ActionPlace::copy(std::map<const base::DataSourceBase*, base::DataSourceBase*>& cloned) const {
    return new ActionPlace(action_->copy(cloned), parent->copy(cloned));
}

}  // namespace RTT::internal
