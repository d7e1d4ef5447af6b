// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_TYPE_INFO_NAME_HPP
#define ORO_TYPE_INFO_NAME_HPP

#include "Types.hpp"

namespace RTT {
namespace types {

namespace detail {
RTT_API TypeInfo* knownOrNewType(const std::string& name, const std::type_info& id);
}

/** Gives a C++ type a name and nothing else: it can be named in signatures, but not made, printed or transported. */
template <class T>
class TypeInfoName : public TypeInfoGenerator {
public:
    explicit TypeInfoName(const std::string& name) : name_(name) {}

    const std::string& getTypeName() const override { return name_; }
    TypeInfo* getTypeInfoObject() const override { return detail::knownOrNewType(name_, typeid(T)); }
    bool installTypeInfoObject(TypeInfo* info) override {
        info->setTypeId(&typeid(T));
        return true;
    }

private:
    std::string name_;
};

}  // namespace types
}  // namespace RTT

#endif
