// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Any bytes are read as a property file: errors have places; what is read is written, read and edited without loss.
#include "fuzzing.hpp"

#include <cpf/cpf_edit.hpp>
#include <cpf/cpf_reader.hpp>
#include <cpf/cpf_writer.hpp>
#include <rtt/Property.hpp>
#include <rtt/PropertyBag.hpp>
#include <rtt/internal/values/property_update.hpp>
#include <rtt/types/PropertyDecomposition.hpp>

#include <cstddef>
#include <cstdint>
#include <string>

using namespace RTT;
using namespace RTT::marsh;

namespace {

/** Has names that the corpus uses, too. */
void fillComponent(PropertyBag& bag) {
    bag.ownProperty(new Property<double>("a", "of a component", 0.1));
    bag.ownProperty(new Property<std::string>("b", "", " x\n<y> "));
    bag.ownProperty(new Property<std::vector<double>>("v", "", {1, 2}));
    PropertyBag inner;
    inner.ownProperty(new Property<int>("a", "", -1));
    inner.ownProperty(new Property<char>("c", "", '\0'));
    bag.ownProperty(new Property<PropertyBag>("s", "", inner));
}

void checkEdits(const std::string& text, const xml::Document& document) {
    PropertyBag component, simple;
    fillComponent(component);
    types::decomposePropertyBag(component, simple);
    for (const bool addNew : {false, true}) {
        const std::string once = editedCpf(text, document.root(), simple, addNew);
        PropertyBag read;
        diag::Sink sink;
        const auto again = readText(once, "edited", read, sink);
        require(again.has_value(), "an edited file can be read", once);
        require(editedCpf(once, again->root(), simple, addNew) == once, "there is nothing left to edit", once);
        const auto* a = addNew ? read.find("a") : nullptr;
        require(!addNew || (a && Property<double>(const_cast<base::PropertyBase*>(a)).get() == 0.1),
                "the value is there", once);
    }
}

void checkUpdates(const PropertyBag& bag) {
    PropertyBag component;
    fillComponent(component);
    internal::detail::BagUpdate how;
    how.report = [](const base::PropertyBase*, const std::string&) {};
    how.addMissing = true;
    internal::detail::updateBag(component, bag, how);
    listProperties(component);
    flattenPropertyBag(component);
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***) {
    loadTypekit(RTT_TYPEKIT_FILE);
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(reinterpret_cast<const char*>(data), size);
    PropertyBag bag, back;
    diag::Sink sink, none;
    const auto document = readText(text, "input", bag, sink);
    require(document.has_value() != sink.hadErrors(), "it is read or there is an error");
    for (const auto& diagnostic : sink.all()) require(diagnostic.where.line != 0, "errors have places");
    if (!document) return 0;
    const std::string written = cpfText(bag);
    require(readText(written, "written", back, none).has_value(), "what is written can be read", written);
    require(cpfText(back) == written, "writing and reading changes nothing", written);
    require(editedCpf(text, document->root(), bag, true) == text, "values that are in the file change nothing");
    checkEdits(text, *document);
    checkUpdates(bag);
    return 0;
}
