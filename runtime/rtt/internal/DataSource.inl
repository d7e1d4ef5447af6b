// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_CORELIB_DATASOURCE_INL
#define ORO_CORELIB_DATASOURCE_INL

#include <memory>

namespace RTT {
namespace internal {

template <typename T>
bool DataSource<T>::evaluate() const {
    (void)this->get();
    return true;
}

template <typename T>
std::string DataSource<T>::getType() const {
    return DataSource<T>::GetType();
}

template <typename T>
const types::TypeInfo* DataSource<T>::getTypeInfo() const {
    return DataSource<T>::GetTypeInfo();
}

template <typename T>
const std::type_info* DataSource<T>::getTypeId() const {
    return &typeid(value_t);
}

template <typename T>
const void* DataSource<T>::getRawConstPointer() {
    if constexpr (std::is_void_v<value_t>)
        return nullptr;
    else
        return static_cast<const void*>(std::addressof(this->rvalue()));
}

template <typename T>
void* AssignableDataSource<T>::getRawPointer() {
    return static_cast<void*>(std::addressof(this->set()));
}

template <typename T>
bool AssignableDataSource<T>::assignValue(const void* value) {
    if (!value || !this->isAssignable()) return false;
    this->set(*static_cast<const value_t*>(value));
    return true;
}

}  // namespace internal
}  // namespace RTT

#endif
