// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_GLOBAL_SERVICE_HPP
#define ORO_GLOBAL_SERVICE_HPP

#include <rtt/Service.hpp>

namespace RTT {
namespace internal {

/** The root of the services that belong to no component. Has the operation require(name), which loads one. */
class RTT_API GlobalService : public Service {
public:
    static Service::shared_ptr Instance();
    static void Release();

private:
    GlobalService();
    bool require(const std::string& service);
};

}  // namespace internal
}  // namespace RTT

#endif
