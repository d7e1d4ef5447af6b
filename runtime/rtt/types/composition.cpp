// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Property bags of types whose generators only give access to members.
#include "CompositionHooks.hpp"

#include <rtt/Logger.hpp>
#include <rtt/internal/values/property_update.hpp>
#include "CompositionFactory.hpp"
#include "Types.hpp"
#include <rtt/types/member_update.hpp>
#include <algorithm>

namespace RTT::types {

using base::DataSourceBase;
using SourcePtr = DataSourceBase::shared_ptr;

CompositionHooks::~CompositionHooks() = default;

namespace detail {

namespace {

/** False if the source has none of these types, which must be integers. */
template <class... Number>
bool readWhole(const SourcePtr& source, long long& number) {
    const auto isOne = [&](auto zero) {
        const void* const value = valueOfType(source, typeid(zero));
        if (value) number = static_cast<long long>(*static_cast<const decltype(zero)*>(value));
        return value != nullptr;
    };
    return (isOne(Number()) || ...);
}

bool readCount(const SourcePtr& source, long long& count) {
    return readWhole<int, unsigned, long, unsigned long, long long, unsigned long long, short, unsigned short>(source,
                                                                                                               count);
}

class HookedComposition : public CompositionFactory {
public:
    explicit HookedComposition(const boost::shared_ptr<CompositionHooks>& hooks) : hooks_(hooks) {}

    SourcePtr decomposeType(SourcePtr source) const override {
        const SourcePtr own = hooks_->decomposeType(source);
        const CompositionFactoryPtr& former = hooks_->formerComposition();
        return own || !former ? own : former->decomposeType(source);
    }
    bool composeType(SourcePtr source, SourcePtr target) const override {
        if (hooks_->composeType(source, target)) return true;
        // Hooks that are not overridden ask for a bag themselves.
        const CompositionFactoryPtr& former = hooks_->formerComposition();
        return former && !valueOfType(source, typeid(PropertyBag)) && former->composeType(source, target);
    }
    bool asks(const CompositionHooks* hooks) const { return hooks_.get() == hooks; }

private:
    boost::shared_ptr<CompositionHooks> hooks_;
};

bool setPart(const SourcePtr& part, const base::PropertyBase& item) {
    if (updateWithConversion(part, item.getDataSource())) return true;
    log(Error) << "part " << item.getName() << " of type " << part->getTypeName() << " cannot take a value of type "
               << item.getType() << endlog();
    return false;
}

/** Sets elements by index, for types that have a size and elements instead of members. */
bool composeElements(const PropertyBag& source, const SourcePtr& target) {
    const TypeInfo* type = target->getTypeInfo();
    const std::size_t first = firstElement(source);
    const int count = static_cast<int>(source.size() - first);
    if (elementCount(target) != count && !type->resize(target, count)) return false;
    for (int i = 0; i != count; ++i) {
        const SourcePtr element = elementOf(target, i);
        if (!element || !setPart(element, *source.getItem(first + static_cast<std::size_t>(i)))) return false;
    }
    target->updated();
    return true;
}

}  // namespace

CompositionFactoryPtr compositionBy(const boost::shared_ptr<CompositionHooks>& hooks) {
    return CompositionFactoryPtr(new HookedComposition(hooks));
}

void ownAll(PropertyBag& bag) {
    for (std::size_t i = 0; i != bag.size(); ++i) {
        base::PropertyBase* const item = bag.getItem(i);
        bag.ownProperty(item);
        if (PropertyBag* const inner = internal::detail::bagOf(*item)) ownAll(*inner);
    }
}

void installComposition(TypeInfo& type, const boost::shared_ptr<CompositionHooks>& hooks) {
    const CompositionFactoryPtr former = type.getCompositionFactory();
    // A generator that has installed itself, as a factory or by these hooks, stays.
    if (former && dynamic_cast<const CompositionHooks*>(former.get()) == hooks.get()) return;
    const auto* hooked = dynamic_cast<const HookedComposition*>(former.get());
    if (hooked && hooked->asks(hooks.get())) return;
    hooks->setFormerComposition(former);
    type.setCompositionFactory(compositionBy(hooks));
}

int elementCount(const SourcePtr& source) {
    long long count = 0;  // the member holds the value that is looked at
    return readCount(source->getMember("size"), count) ? static_cast<int>(count) : -1;
}

SourcePtr elementOf(const SourcePtr& source, int index) {
    const SourcePtr element = source->getMember(SourcePtr(new internal::ConstantDataSource<int>(index)));
    return element ? element : source->getMember(std::to_string(index));
}

bool isText(const SourcePtr& source) {
    const std::vector<std::string> names = source->getMemberNames();
    if (!source->getTypeInfo()->isStreamable() || std::find(names.begin(), names.end(), "size") == names.end())
        return false;
    const SourcePtr letter = elementOf(source, 0);  // also of an empty one
    return letter && letter->getTypeId() && *letter->getTypeId() == typeid(char);
}

std::size_t firstElement(const PropertyBag& bag) {
    const base::PropertyBase* const first = bag.getItem(0);
    long long said = 0;
    if (!first || first->getName() != "Size" || !readCount(first->getDataSource(), said)) return 0;
    if (static_cast<std::size_t>(said) != bag.size() - 1)
        log(Warning) << "a sequence of type " << bag.getType() << " has " << bag.size() - 1
                     << " elements, though its Size is " << said << endlog();
    return 1;
}

bool composeMembers(const PropertyBag& source, const std::type_info& id, void* value,
                    const CompositionFactoryPtr& former) {
    const TypeInfo* type = Types()->getTypeById(&id);
    const SourcePtr target = type ? type->buildReference(value) : nullptr;
    if (!target) return false;
    const SourcePtr bag(new internal::ConstReferenceDataSource<PropertyBag>(source));
    if (former && former->composeType(bag, target)) return true;
    // Former hooks have tried the members.
    if (dynamic_cast<const HookedComposition*>(former.get())) return false;
    bool complete = true, any = false;
    for (const auto& name : target->getMemberNames()) {
        const SourcePtr member = target->getMember(name);
        if (!member || !member->isAssignable()) continue;
        any = true;
        const base::PropertyBase* item = source.find(name);
        if (item) complete = setPart(member, *item) && complete;
    }
    // A text also has elements, but cannot be composed from them.
    if (!any) return !isText(target) && elementCount(target) >= 0 && composeElements(source, target);
    target->updated();
    return complete;
}

}  // namespace detail

}  // namespace RTT::types
