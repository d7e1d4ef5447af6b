// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_PRIMITIVE_TYPE_INFO_HPP
#define ORO_PRIMITIVE_TYPE_INFO_HPP

#include "CompositionHooks.hpp"
#include "TemplateStreamFactory.hpp"
#include "TemplateValueFactory.hpp"
#include "Types.hpp"
#include <boost/shared_ptr.hpp>

namespace RTT {
namespace types {

namespace detail {
/** The object registered for that C++ type, or a new one of that name. */
RTT_API TypeInfo* knownOrNewType(const std::string& name, const std::type_info& id);

template <class T, bool use_ostream>
struct StreamBase : TemplateStreamFactory<T> {};
template <class T>
struct StreamBase<T, false> {};
}  // namespace detail

/**
 * Generator for a value type without ports: values, variables, properties, and the text form of operator<< if
 * `use_ostream`. Derived generators call this one's installTypeInfoObject() and install their own factories after it;
 * what they override of the factories here, composeTypeImpl() and decomposeTypeImpl() included, is in use without that.
 * What they do not override of those two stays as the type had it, if it was registered before.
 */
template <typename T, bool use_ostream = false>
class PrimitiveTypeInfo : public TypeInfoGenerator,
                          public TemplateValueFactory<T>,
                          public CompositionByBag<T, CompositionHooks>,
                          public detail::StreamBase<T, use_ostream> {
public:
    typedef T UserType;
    typedef T PropertyType;

    explicit PrimitiveTypeInfo(std::string name) : tname(std::move(name)) {}

    const std::string& getTypeName() const override { return tname; }
    TypeInfo* getTypeInfoObject() const override { return detail::knownOrNewType(tname, typeid(T)); }
    bool installTypeInfoObject(TypeInfo* info) override {
        auto self = boost::dynamic_pointer_cast<PrimitiveTypeInfo>(this->getSharedPtr());
        info->setTypeId(&typeid(T));
        info->setOps(&typeOps<T>());
        info->setThunks(&thunks());
        info->setValueFactory(self);
        detail::installComposition(*info, self);
        if constexpr (use_ostream) info->setStreamFactory(self);
        return false;
    }

protected:
    const std::string tname;

private:
    static const TypeThunks& thunks() {
        static constexpr TypeThunks table = [] {
            TypeThunks t = detail::Thunks<T>::table();
            t.inputPort = nullptr;
            t.outputPort = nullptr;
            t.dataStorage = nullptr;
            return t;
        }();
        return table;
    }
};

}  // namespace types
}  // namespace RTT

// Users rely on it for more than this header needs.
#include <rtt/types/typekit_includes.hpp>
#include <rtt/usual_includes.hpp>

#endif
