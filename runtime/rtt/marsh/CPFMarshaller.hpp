// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_CPF_MARSHALLER_HPP
#define ORO_CPF_MARSHALLER_HPP

#include "MarshallInterface.hpp"
#include "StreamProcessor.hpp"
#include <ostream>
#include <string>

namespace RTT {
namespace marsh {

namespace detail {
/** The element of a property file for a property. Logs an error and returns an empty text if the type has no such
    form. */
RTT_API std::string cpfElement(base::PropertyBase& property);
/** The text of a property file with these elements. */
RTT_API std::string cpfDocument(const std::string& elements);
}  // namespace detail

/**
 * Writes property files to a stream: flush() writes a whole file of what was serialized since the last flush. To write
 * a file on disk, use PropertyMarshaller. Not thread safe, not real-time safe.
 */
template <typename o_stream>
class CPFMarshaller : public MarshallInterface, public StreamProcessor<o_stream> {
public:
    explicit CPFMarshaller(o_stream& stream) : StreamProcessor<o_stream>(stream) {}

    void serialize(base::PropertyBase* property) override {
        if (property && property->ready()) elements_ += detail::cpfElement(*property);
    }
    void serialize(const PropertyBag& bag) override {
        for (auto* property : bag) serialize(property);
    }
    void flush() override {
        *this->s << detail::cpfDocument(elements_);
        this->s->flush();
        elements_.clear();
    }

private:
    std::string elements_;
};

}  // namespace marsh
}  // namespace RTT

#endif
