// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_GLOBALS_REPOSITORY_HPP
#define ORO_GLOBALS_REPOSITORY_HPP

#include <rtt/ConfigurationInterface.hpp>
#include <boost/shared_ptr.hpp>

namespace RTT {
namespace types {

/** Constants, attributes and properties that every script sees. Not thread safe: fill it before threads use it. */
class RTT_API GlobalsRepository : public ConfigurationInterface {
public:
    typedef boost::shared_ptr<GlobalsRepository> shared_ptr;
    static shared_ptr Instance();
    /** Does nothing, because the globals are kept until the process ends. For programs that call it at their end. */
    static void Release() {}

private:
    GlobalsRepository() = default;
};

}  // namespace types
}  // namespace RTT

#endif
