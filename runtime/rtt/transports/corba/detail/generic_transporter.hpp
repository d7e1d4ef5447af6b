// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_CORBA_DETAIL_GENERIC_TRANSPORTER_HPP
#define ORO_CORBA_DETAIL_GENERIC_TRANSPORTER_HPP

#include <rtt/transports/corba/CorbaTypeTransporter.hpp>
#include <rtt/transports/corba/detail/any_codec.hpp>

#include <atomic>
#include <memory>
#include <mutex>

namespace RTT {
namespace corba {
namespace detail {

/** For any type with a shape. */
class GenericTransporter final : public CorbaTypeTransporter {
public:
    explicit GenericTransporter(const types::TypeInfo& type) : type_(type) {}

    bool isGeneric() const override { return true; }
    CORBA::Any_ptr createAny(base::DataSourceBase::shared_ptr source) const override;
    bool updateAny(base::DataSourceBase::shared_ptr source, CORBA::Any& any) const override;
    base::DataSourceBase::shared_ptr createDataSource(const CORBA::Any* any) const override;
    bool updateFromAny(const CORBA::Any* any, base::DataSourceBase::shared_ptr target) const override;

private:
    /** Null, with an error logged the first time, if the type has no shape, or if there is no ORB. */
    const AnyCodec* codec() const;

    const types::TypeInfo& type_;
    mutable std::once_flag made_;
    mutable std::shared_ptr<const AnyCodec> codec_;
    mutable std::atomic<const AnyCodec*> known_{nullptr};  // once made
};

}  // namespace detail
}  // namespace corba
}  // namespace RTT

#endif
