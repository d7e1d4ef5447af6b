// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_TEMPLATE_VALUE_FACTORY_HPP
#define ORO_TEMPLATE_VALUE_FACTORY_HPP

#include "TypeThunks.hpp"
#include "ValueFactory.hpp"

namespace RTT {
namespace types {

/** A value factory that uses the thunks of T; hand-written typekits may override its functions. */
template <class T>
class TemplateValueFactory : public ValueFactory {
public:
    typedef T UserType;
    typedef T PropertyType;

    base::AttributeBase* buildConstant(std::string name, base::DataSourceBase::shared_ptr value, int) const override {
        const auto& t = typeThunks<T>();
        return t.constant ? t.constant(name, value.get()) : nullptr;
    }
    base::AttributeBase* buildVariable(std::string name, int sizehint) const override {
        return typeThunks<T>().variable(name, sizehint);
    }
    base::AttributeBase* buildAlias(std::string name, base::DataSourceBase::shared_ptr source) const override {
        return source && source->getTypeId() && *source->getTypeId() == typeid(T) ? new Alias(name, source) : nullptr;
    }
    base::DataSourceBase::shared_ptr buildActionAlias(base::ActionInterface* action,
                                                      base::DataSourceBase::shared_ptr source) const override {
        const auto& t = typeThunks<T>();
        return t.actionAlias ? t.actionAlias(action, source.get()) : nullptr;
    }
    base::PropertyBase* buildProperty(const std::string& name, const std::string& description,
                                      base::DataSourceBase::shared_ptr source = nullptr) const override {
        return typeThunks<T>().property(name, description, source.get());
    }
    base::AttributeBase* buildAttribute(std::string name,
                                        base::DataSourceBase::shared_ptr source = nullptr) const override {
        return typeThunks<T>().attribute(name, source.get());
    }
    base::DataSourceBase::shared_ptr buildValue() const override { return typeThunks<T>().value(); }
    base::DataSourceBase::shared_ptr buildReference(void* value) const override {
        return typeThunks<T>().reference(value);
    }
};

}  // namespace types
}  // namespace RTT

#endif
