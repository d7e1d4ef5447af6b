// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_MQUEUE_DETAIL_GENERIC_TRANSPORTER_HPP
#define ORO_MQUEUE_DETAIL_GENERIC_TRANSPORTER_HPP

#include <rtt/transports/mqueue/MQTransporter.hpp>

namespace RTT {
namespace mqueue {
namespace detail {

/** For any type with a shape. */
class GenericTransporter final : public MQTransporter {
public:
    bool isGeneric() const override { return true; }
    std::pair<void const*, int> fillBlob(base::DataSourceBase::shared_ptr source, void* blob, int size,
                                         void* cookie) const override;
    bool updateFromBlob(const void* blob, int size, base::DataSourceBase::shared_ptr target,
                        void* cookie) const override;
    unsigned int getSampleSize(base::DataSourceBase::shared_ptr sample, void* cookie) const override;

protected:
    std::unique_ptr<MessageFormat> makeFormat(const types::TypeInfo& type, std::string& why) const override;
};

}  // namespace detail
}  // namespace mqueue
}  // namespace RTT

#endif
