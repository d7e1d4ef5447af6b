// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/transports/corba/detail/generic_transporter.hpp>

#include <rtt/Logger.hpp>
#include <rtt/transports/corba/ApplicationServer.hpp>
#include <rtt/types/TypeInfo.hpp>

#include <cstdint>

namespace RTT::corba {

base::ChannelElementBase::shared_ptr CorbaTypeTransporter::createStream(base::PortInterface*, const ConnPolicy&,
                                                                        bool) const {
    return nullptr;
}

namespace detail {

const AnyCodec* GenericTransporter::codec() const {
    if (CORBA::is_nil(ApplicationServer::orb)) return nullptr;
    if (const AnyCodec* const known = known_.load(std::memory_order_acquire)) return known;
    std::call_once(made_, [this] {
        std::string why;
        codec_ = AnyCodec::make(type_, ApplicationServer::orb, why);
        if (!codec_)
            log(Error) << "values of type " << type_.getTypeName() << " do not cross CORBA: " << why << endlog();
        known_.store(codec_.get(), std::memory_order_release);
    });
    return codec_.get();
}

bool GenericTransporter::updateAny(base::DataSourceBase::shared_ptr source, CORBA::Any& any) const {
    const void* const value = source ? source->getRawConstPointer() : nullptr;
    const AnyCodec* const own = value ? codec() : nullptr;
    return own && own->put(value, any);
}

CORBA::Any_ptr GenericTransporter::createAny(base::DataSourceBase::shared_ptr source) const {
    auto made = std::make_unique<CORBA::Any>();
    return updateAny(source, *made) ? made.release() : nullptr;
}

// The value is taken apart first, so that bytes that are no value leave the target unchanged.
bool GenericTransporter::updateFromAny(const CORBA::Any* any, base::DataSourceBase::shared_ptr target) const {
    const AnyCodec* const own = any && target ? codec() : nullptr;
    if (own && own->isNumber()) {
        std::uint64_t number = 0;  // has room for each
        std::string why;
        if (!own->get(*any, &number, why) || !target->assignValue(&number)) return false;
        target->updated();
        return true;
    }
    const base::DataSourceBase::shared_ptr made = target ? createDataSource(any) : nullptr;
    if (!made || !target->assignValue(made->getRawConstPointer())) return false;
    target->updated();
    return true;
}

base::DataSourceBase::shared_ptr GenericTransporter::createDataSource(const CORBA::Any* any) const {
    const AnyCodec* const own = any ? codec() : nullptr;
    const base::DataSourceBase::shared_ptr made = own ? type_.buildValue() : nullptr;
    std::string why;
    return made && own->get(*any, made->getRawPointer(), why) ? made : nullptr;
}

}  // namespace detail
}  // namespace RTT::corba
