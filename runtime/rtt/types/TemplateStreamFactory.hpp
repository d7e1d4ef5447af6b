// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_TEMPLATE_STREAM_FACTORY_HPP
#define ORO_TEMPLATE_STREAM_FACTORY_HPP

#include "StreamFactory.hpp"
#include "TypeStreamSelector.hpp"

namespace RTT {
namespace types {

/** The text form of T by its stream operators. */
template <class T>
class TemplateStreamFactory : public StreamFactory {
public:
    std::ostream& write(std::ostream& os, base::DataSourceBase::shared_ptr source) const override {
        if (const void* value = detail::valueOfType(source, typeid(T)))
            TypeStreamSelector<T, true>::write(os, *static_cast<const T*>(value));
        return os;
    }
    std::istream& read(std::istream& is, base::DataSourceBase::shared_ptr target) const override {
        void* value = detail::storageOfType(target, typeid(T));
        if (!value) {
            is.setstate(std::ios::failbit);
            return is;
        }
        TypeStreamSelector<T, true>::read(is, *static_cast<T*>(value));
        target->updated();
        return is;
    }
    bool isStreamable() const override { return detail::HasIstream<T>::value; }
};

}  // namespace types
}  // namespace RTT

#endif
