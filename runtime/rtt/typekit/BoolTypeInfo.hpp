// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_BOOL_TYPE_INFO_HPP
#define ORO_BOOL_TYPE_INFO_HPP

#include <rtt/types/TemplateTypeInfo.hpp>
#include <string>

namespace RTT {
namespace types {

/** Generator for bool: writes "true" or "false", and also reads 1 and 0. */
struct BoolTypeInfo : TemplateTypeInfo<bool, true> {
    explicit BoolTypeInfo(const std::string& name = "bool") : TemplateTypeInfo<bool, true>(name) {}

    std::ostream& write(std::ostream& os, base::DataSourceBase::shared_ptr source) const override {
        const void* value = detail::valueOfType(source, typeid(bool));
        return value ? os << (*static_cast<const bool*>(value) ? "true" : "false") : os;
    }
    std::istream& read(std::istream& is, base::DataSourceBase::shared_ptr target) const override {
        void* storage = detail::storageOfType(target, typeid(bool));
        std::string text;
        is >> text;
        const bool yes = text == "true" || text == "1";
        if (!storage || (!yes && text != "false" && text != "0")) {
            is.setstate(std::ios::failbit);
            return is;
        }
        *static_cast<bool*>(storage) = yes;
        target->updated();
        return is;
    }
};

}  // namespace types
}  // namespace RTT

#endif
