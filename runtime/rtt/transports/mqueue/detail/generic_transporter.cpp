// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/transports/mqueue/detail/generic_transporter.hpp>

#include <rtt/transports/mqueue/detail/shape_format.hpp>
#include <rtt/types/TypeInfo.hpp>

namespace RTT::mqueue::detail {

std::unique_ptr<MessageFormat> GenericTransporter::makeFormat(const types::TypeInfo& type, std::string& why) const {
    return newFormatOf(type, why);
}

std::pair<void const*, int> GenericTransporter::fillBlob(base::DataSourceBase::shared_ptr source, void* blob, int size,
                                                         void*) const {
    std::string why;
    const auto format = source && source->evaluate() && size >= 0 ? makeFormat(*source->getTypeInfo(), why) : nullptr;
    const void* const sample = format ? source->getRawConstPointer() : nullptr;
    const std::size_t written = sample ? format->write(sample, blob, static_cast<std::size_t>(size)) : 0;
    return {written ? blob : nullptr, static_cast<int>(written)};
}

bool GenericTransporter::updateFromBlob(const void* blob, int size, base::DataSourceBase::shared_ptr target,
                                        void*) const {
    std::string why;
    const auto format = target && size >= 0 ? makeFormat(*target->getTypeInfo(), why) : nullptr;
    void* const sample = target ? target->getRawPointer() : nullptr;
    if (!format || !sample || !format->read(blob, static_cast<std::size_t>(size), sample, why)) return false;
    target->updated();
    return true;
}

unsigned int GenericTransporter::getSampleSize(base::DataSourceBase::shared_ptr sample, void*) const {
    std::string why;
    const auto format = sample && sample->evaluate() ? makeFormat(*sample->getTypeInfo(), why) : nullptr;
    const void* const memory = format ? sample->getRawConstPointer() : nullptr;
    return memory ? static_cast<unsigned int>(format->sizeOf(memory)) : 0;
}

}  // namespace RTT::mqueue::detail
