// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_TEMPLATE_COMPOSITION_FACTORY_HPP
#define ORO_TEMPLATE_COMPOSITION_FACTORY_HPP

#include <rtt/PropertyBag.hpp>
#include <rtt/internal/DataSources.hpp>
#include "CompositionFactory.hpp"
#include "StreamFactory.hpp"
#include "TypeInfo.hpp"

namespace RTT {
namespace types {

/** Base of factories that turn a T into a property bag and back: override the two …Impl functions. */
template <class T>
class TemplateCompositionFactory : public CompositionFactory {
public:
    typedef typename internal::DataSource<T>::const_reference_t param_t;
    typedef typename internal::AssignableDataSource<T>::reference_t reference_t;

    base::DataSourceBase::shared_ptr decomposeType(base::DataSourceBase::shared_ptr source) const override {
        const void* value = detail::valueOfType(source, typeid(T));
        if (!value) return nullptr;
        boost::intrusive_ptr<internal::ValueDataSource<PropertyBag>> bag(new internal::ValueDataSource<PropertyBag>());
        bag->set().setType(source->getTypeName());
        return decomposeTypeImpl(*static_cast<const T*>(value), bag->set()) ? bag : nullptr;
    }
    bool composeType(base::DataSourceBase::shared_ptr source, base::DataSourceBase::shared_ptr target) const override {
        const void* bag = detail::valueOfType(source, typeid(PropertyBag));
        void* value = bag ? detail::storageOfType(target, typeid(T)) : nullptr;
        if (!value || !composeTypeImpl(*static_cast<const PropertyBag*>(bag), *static_cast<T*>(value))) return false;
        target->updated();
        return true;
    }

    /** Sets `result` from the members in `source`. */
    virtual bool composeTypeImpl(const PropertyBag& source, reference_t result) const = 0;
    /** Adds the members of `source` to `target`, which must not refer to it. */
    virtual bool decomposeTypeImpl(param_t source, PropertyBag& target) const = 0;
};

}  // namespace types
}  // namespace RTT

#endif
