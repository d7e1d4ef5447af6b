// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_PROPERTY_MARSHALLER_HPP
#define ORO_PROPERTY_MARSHALLER_HPP

#include "MarshallInterface.hpp"
#include <string>

namespace RTT {
namespace marsh {

/** Writes a property file: each flush(), and the destructor, replaces the file with all that was serialized. */
class RTT_API PropertyMarshaller : public MarshallInterface {
public:
    explicit PropertyMarshaller(const std::string& filename);
    ~PropertyMarshaller() override;

    using MarshallInterface::serialize;
    void serialize(base::PropertyBase* property) override;
    void serialize(const PropertyBag& bag) override;
    /** Errors go to the log. */
    void flush() override;

private:
    std::string filename_;
    PropertyBag collected_;
    bool written_ = false;
};

}  // namespace marsh
}  // namespace RTT

#endif
