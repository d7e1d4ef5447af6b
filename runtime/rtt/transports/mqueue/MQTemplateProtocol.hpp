// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_MQ_TEMPLATE_PROTOCOL_HPP
#define ORO_MQ_TEMPLATE_PROTOCOL_HPP

#include <rtt/transports/mqueue/MQTemplateProtocolBase.hpp>

#include <cstring>

namespace RTT {
namespace mqueue {

/** Sends the memory of T, which must not refer to other memory. */
template <class T>
class MQTemplateProtocol : public MQTemplateProtocolBase<T> {
public:
    std::pair<void const*, int> fillBlob(base::DataSourceBase::shared_ptr source, void* blob, int size,
                                         void*) const override {
        const void* const sample = size >= static_cast<int>(sizeof(T)) ? memoryOf(source) : nullptr;
        if (!sample) return {nullptr, 0};
        std::memcpy(blob, sample, sizeof(T));
        return {blob, static_cast<int>(sizeof(T))};
    }
    bool updateFromBlob(const void* blob, int size, base::DataSourceBase::shared_ptr target, void*) const override {
        auto* const typed = internal::AssignableDataSource<T>::narrow(target.get());
        if (!typed || size != static_cast<int>(sizeof(T))) return false;
        std::memcpy(static_cast<void*>(&typed->set()), blob, sizeof(T));
        typed->updated();
        return true;
    }
    unsigned int getSampleSize(base::DataSourceBase::shared_ptr, void*) const override { return sizeof(T); }

protected:
    std::unique_ptr<MessageFormat> makeFormat(const types::TypeInfo&, std::string&) const override {
        return newMemoryFormat(sizeof(T));
    }

private:
    static const void* memoryOf(const base::DataSourceBase::shared_ptr& source) {
        auto* const typed = internal::DataSource<T>::narrow(source.get());
        return typed && typed->evaluate() ? typed->getRawConstPointer() : nullptr;
    }
};

}  // namespace mqueue
}  // namespace RTT

#endif
