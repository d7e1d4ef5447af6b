// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Conversion of values to property bags and back, to be overridden by generators and factories.
#ifndef ORO_COMPOSITION_HOOKS_HPP
#define ORO_COMPOSITION_HOOKS_HPP

#include <rtt/PropertyBag.hpp>
#include <rtt/internal/DataSources.hpp>
#include "CompositionFactory.hpp"
#include "StreamFactory.hpp"
#include "TypeInfo.hpp"

namespace RTT {
namespace types {

/**
 * The functions that generators of values may override. This is not a CompositionFactory, so that a generator may also
 * derive from one; an override then counts for both.
 */
class RTT_API CompositionHooks {
public:
    virtual ~CompositionHooks();

    /** As in CompositionFactory. */
    virtual base::DataSourceBase::shared_ptr decomposeType(base::DataSourceBase::shared_ptr source) const = 0;
    virtual bool composeType(base::DataSourceBase::shared_ptr source,
                             base::DataSourceBase::shared_ptr target) const = 0;

    /** The factory that the type had before these hooks, used for what they do not override; or null. */
    const CompositionFactoryPtr& formerComposition() const { return former_; }
    void setFormerComposition(CompositionFactoryPtr former) { former_ = std::move(former); }

private:
    CompositionFactoryPtr former_;
};

namespace detail {
/**
 * Sets the value at `value`, of C++ type `id`: by `former` if it can. Otherwise sets members by the items of their
 * names, while other members keep their values, or the elements of a type that has elements and no text form.
 */
RTT_API bool composeMembers(const PropertyBag& source, const std::type_info& id, void* value,
                            const CompositionFactoryPtr& former);
/** Makes the bag, and the bags in it, own all their items. */
RTT_API void ownAll(PropertyBag& bag);
/** Makes `type` use the hooks, and its present factory for what they do not override. */
RTT_API void installComposition(TypeInfo& type, const boost::shared_ptr<CompositionHooks>& hooks);
}  // namespace detail

/** Implements both functions of `Base` (CompositionHooks or CompositionFactory) by two that know the type T. */
template <class T, class Base>
class CompositionByBag : public Base {
public:
    typedef typename internal::DataSource<T>::const_reference_t param_t;
    typedef typename internal::AssignableDataSource<T>::reference_t reference_t;

    base::DataSourceBase::shared_ptr decomposeType(base::DataSourceBase::shared_ptr source) const override {
        const void* value = detail::valueOfType(source, typeid(T));
        if (!value) return nullptr;
        boost::intrusive_ptr<internal::ValueDataSource<PropertyBag>> bag(new internal::ValueDataSource<PropertyBag>());
        bag->set().setType(source->getTypeName());
        const bool done = decomposeTypeImpl(*static_cast<const T*>(value), bag->set());
        detail::ownAll(bag->set());
        return done ? bag : nullptr;
    }
    bool composeType(base::DataSourceBase::shared_ptr source, base::DataSourceBase::shared_ptr target) const override {
        const void* bag = detail::valueOfType(source, typeid(PropertyBag));
        void* value = bag ? detail::storageOfType(target, typeid(T)) : nullptr;
        if (!value || !composeTypeImpl(*static_cast<const PropertyBag*>(bag), *static_cast<T*>(value))) return false;
        target->updated();
        return true;
    }

    /** Sets `result` from the members in `source`. Default: through the members of the registered type. */
    virtual bool composeTypeImpl(const PropertyBag& source, reference_t result) const {
        if constexpr (std::is_base_of_v<CompositionHooks, Base>)
            return detail::composeMembers(source, typeid(T), std::addressof(result), this->formerComposition());
        else
            return detail::composeMembers(source, typeid(T), std::addressof(result), nullptr);
    }
    /** Adds the members of `source` to `target` as new properties, which must not refer to it and which the bag will
        own even if they are only add()ed. Default: false, there is no special form. */
    virtual bool decomposeTypeImpl(param_t, PropertyBag&) const { return false; }
};

}  // namespace types
}  // namespace RTT

#endif
