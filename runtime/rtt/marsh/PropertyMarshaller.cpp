// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "PropertyMarshaller.hpp"

#include "CPFMarshaller.hpp"
#include "PropertyDemarshaller.hpp"
#include <cpf/cpf_reader.hpp>
#include <cpf/cpf_writer.hpp>

namespace RTT::marsh {

std::string detail::cpfElement(base::PropertyBase& property) { return cpfItem(property, 2); }

std::string detail::cpfDocument(const std::string& elements) { return cpfFrame(elements); }

PropertyMarshaller::PropertyMarshaller(const std::string& filename) : filename_(filename) {}

PropertyMarshaller::~PropertyMarshaller() {
    if (!written_) flush();
}

void PropertyMarshaller::serialize(base::PropertyBase* property) {
    if (!property || !property->ready()) return;
    collected_.ownProperty(property->clone());
    written_ = false;
}

void PropertyMarshaller::serialize(const PropertyBag& bag) {
    for (auto* property : bag) serialize(property);
}

void PropertyMarshaller::flush() {
    writeFile(filename_, cpfText(collected_));
    written_ = true;
}

PropertyDemarshaller::PropertyDemarshaller(const std::string& filename) : filename_(filename) {}

bool PropertyDemarshaller::deserialize(PropertyBag& bag) {
    diag::Sink sink;
    PropertyBag read;
    const bool good = readFile(filename_, read, sink);
    logDiagnostics(sink);
    return good && copyProperties(bag, read);
}

}  // namespace RTT::marsh
