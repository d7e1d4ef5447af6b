// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The other integers of C++, with the names that ROS messages use. They are printed and stored as numbers.
#include "builtin_parts.hpp"

#include <rtt/types/CompositionFactory.hpp>
#include <rtt/types/TemplateTypeInfo.hpp>
#include <limits>

namespace RTT::types::builtin {

namespace {

/** Values of T are shown, read and stored as `Wide`. */
template <class T, class Wide>
class SmallNumberInfo : public TemplateTypeInfo<T, true>, public CompositionFactory {
public:
    explicit SmallNumberInfo(const std::string& name) : TemplateTypeInfo<T, true>(name) {}

    bool installTypeInfoObject(TypeInfo* info) override {
        TemplateTypeInfo<T, true>::installTypeInfoObject(info);
        info->setCompositionFactory(boost::dynamic_pointer_cast<SmallNumberInfo>(this->getSharedPtr()));
        return false;
    }
    std::ostream& write(std::ostream& os, base::DataSourceBase::shared_ptr source) const override {
        const void* value = detail::valueOfType(source, typeid(T));
        return value ? os << static_cast<Wide>(*static_cast<const T*>(value)) : os;
    }
    std::istream& read(std::istream& is, base::DataSourceBase::shared_ptr target) const override {
        Wide number = 0;
        if (is >> number && !store(number, target)) is.setstate(std::ios::failbit);
        return is;
    }
    base::DataSourceBase::shared_ptr decomposeType(base::DataSourceBase::shared_ptr source) const override {
        const void* value = detail::valueOfType(source, typeid(T));
        return value ? new internal::ValueDataSource<Wide>(*static_cast<const T*>(value)) : nullptr;
    }
    bool composeType(base::DataSourceBase::shared_ptr source, base::DataSourceBase::shared_ptr target) const override {
        return take<int>(source, target) || take<unsigned int>(source, target) || take<long long>(source, target) ||
               take<unsigned long long>(source, target) || take<unsigned char>(source, target);
    }

private:
    template <class From>
    static bool take(const base::DataSourceBase::shared_ptr& source, const base::DataSourceBase::shared_ptr& target) {
        const void* value = detail::valueOfType(source, typeid(From));
        return value && store(*static_cast<const From*>(value), target);
    }
    template <class From>
    static bool store(From number, const base::DataSourceBase::shared_ptr& target) {
        void* storage = detail::storageOfType(target, typeid(T));
        const T small = static_cast<T>(number);
        if (!storage || static_cast<From>(small) != number || (small < 0) != (number < 0)) return false;
        *static_cast<T*>(storage) = small;
        target->updated();
        return true;
    }
};

}  // namespace

void addSmallNumbers() {
    const auto types = Types();
    types->addType(new SmallNumberInfo<signed char, int>("int8"));
    types->addType(new SmallNumberInfo<unsigned char, unsigned int>("uint8"));
    types->addType(new SmallNumberInfo<short, int>("int16"));
    types->addType(new SmallNumberInfo<unsigned short, unsigned int>("uint16"));
    types->addType(new SmallNumberInfo<long, long long>("int64"));
    types->addType(new SmallNumberInfo<unsigned long, unsigned long long>("uint64"));
}

}  // namespace RTT::types::builtin
