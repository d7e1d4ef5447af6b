// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_INTERNAL_PORT_OBJECT_HPP
#define ORO_INTERNAL_PORT_OBJECT_HPP

#include <rtt/Service.hpp>
#include <rtt/base/ChannelElementBase.hpp>

namespace RTT {
namespace internal {

/** The service of a port. Most ports are used without it, so it gets its operations when they are first looked up. May
    outlive the port. */
class PortObject final : public Service {
public:
    explicit PortObject(base::PortInterface& port);

private:
    bool isCommon(const std::string& name) const override;
    void addCommon() override;

    const boost::intrusive_ptr<base::ChannelElementBase> endpoint_;
};

}  // namespace internal
}  // namespace RTT

#endif
