// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "builtin_parts.hpp"

#include <rtt/rt_string.hpp>
#include <rtt/typekit/StdStringTypeInfo.hpp>
#include <rtt/types/CompositionFactory.hpp>
#include <rtt/types/StdVectorTypeInfo.hpp>

#include <new>

namespace RTT::types::builtin {

namespace {

/** Files store a real-time string as a string. */
struct TextForm : CompositionFactory {
    base::DataSourceBase::shared_ptr decomposeType(base::DataSourceBase::shared_ptr source) const override {
        const void* const text = types::detail::valueOfType(source, typeid(rt_string));
        if (!text) return nullptr;
        return new internal::ValueDataSource<std::string>(
            std::string(static_cast<const rt_string*>(text)->data(), static_cast<const rt_string*>(text)->size()));
    }
    bool composeType(base::DataSourceBase::shared_ptr source, base::DataSourceBase::shared_ptr target) const override {
        const void* const text = types::detail::valueOfType(source, typeid(std::string));
        void* const storage = text ? types::detail::storageOfType(target, typeid(rt_string)) : nullptr;
        if (!storage) return false;
        try {
            const std::string& given = *static_cast<const std::string*>(text);
            static_cast<rt_string*>(storage)->assign(given.data(), given.size());
        } catch (const std::bad_alloc&) {
            return false;  // real-time memory is used up
        }
        target->updated();
        return true;
    }
};

}  // namespace

void addTexts() {
    Types()->addType(new StdStringTypeInfo());
    Types()->addType(new StdBasicStringTypeInfo<rt_string>("rt_string"));
    Types()->type("rt_string")->setCompositionFactory(CompositionFactoryPtr(new TextForm()));
    Types()->addType(new StdVectorTypeInfo<double>());
}

}  // namespace RTT::types::builtin
