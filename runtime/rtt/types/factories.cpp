// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The default behaviour of the interfaces that typekits implement.
#include "CompositionFactory.hpp"
#include "MemberFactory.hpp"
#include "StreamFactory.hpp"
#include "TransportPlugin.hpp"
#include "TypeConstructor.hpp"
#include "TypeInfoGenerator.hpp"
#include "TypeThunkTable.hpp"
#include "TypeMarshaller.hpp"
#include "TypekitPlugin.hpp"
#include "ValueFactory.hpp"

#include <rtt/Logger.hpp>
#include <rtt/types/conversion_watch.hpp>
#include <rtt/types/refusal_watch.hpp>
#include <rtt/base/ChannelElementBase.hpp>
#include <rtt/internal/Reference.hpp>
#include <sstream>

namespace RTT::types {

ValueFactory::~ValueFactory() = default;
CompositionFactory::~CompositionFactory() = default;
Enumeration::~Enumeration() = default;
TypeTransporter::~TypeTransporter() = default;
bool TypeTransporter::isGeneric() const { return false; }
TypekitPlugin::~TypekitPlugin() = default;
TransportPlugin::~TransportPlugin() = default;
TypeInfoGenerator::~TypeInfoGenerator() = default;

bool TypekitPlugin::loadGlobals() { return true; }

boost::shared_ptr<TypeInfoGenerator> TypeInfoGenerator::getSharedPtr() {
    if (!self_) self_.reset(this);
    return self_;
}

void* TypeMarshaller::createCookie() const { return nullptr; }
void TypeMarshaller::deleteCookie(void*) const {}

MemberFactory::~MemberFactory() = default;

bool MemberFactory::resize(base::DataSourceBase::shared_ptr, int) const { return false; }

std::vector<std::string> MemberFactory::getMemberNames() const { return {}; }

std::string MemberFactory::describeMember(const std::string&) const { return {}; }

base::DataSourceBase::shared_ptr MemberFactory::getMember(base::DataSourceBase::shared_ptr, const std::string&) const {
    return nullptr;
}

base::DataSourceBase::shared_ptr MemberFactory::getMember(base::DataSourceBase::shared_ptr item,
                                                          base::DataSourceBase::shared_ptr id) const {
    const void* name = detail::valueOfType(id, typeid(std::string));
    return name ? getMember(item, *static_cast<const std::string*>(name)) : nullptr;
}

bool MemberFactory::getMember(internal::Reference* reference, base::DataSourceBase::shared_ptr item,
                              const std::string& name) const {
    const auto member = getMember(item, name);
    return member && reference && reference->setReference(member);
}

StreamFactory::~StreamFactory() = default;

std::string StreamFactory::toString(base::DataSourceBase::shared_ptr source) const {
    std::ostringstream text;
    write(text, source);
    return text.str();
}

bool StreamFactory::fromString(const std::string& text, base::DataSourceBase::shared_ptr target) const {
    std::istringstream input(text);
    read(input, target);
    return !input.fail();
}

TypeConstructor::~TypeConstructor() = default;

base::DataSourceBase::shared_ptr TypeConstructor::convert(base::DataSourceBase::shared_ptr) const { return nullptr; }

namespace detail {

const void* valueOfType(const base::DataSourceBase::shared_ptr& source, const std::type_info& id) {
    return valueOfType(source.get(), id);
}

const void* valueOfType(base::DataSourceBase* source, const std::type_info& id) {
    if (!source || !source->getTypeId() || *source->getTypeId() != id || !source->evaluate()) return nullptr;
    return source->getRawConstPointer();
}

void* storageOfType(const base::DataSourceBase::shared_ptr& source, const std::type_info& id) {
    if (!source || !source->isAssignable() || !source->getTypeId() || *source->getTypeId() != id) return nullptr;
    return source->getRawPointer();
}

namespace {
thread_local ConversionWatch* watch = nullptr;
thread_local RefusalWatch* refusals = nullptr;
}  // namespace

ConversionWatch::ConversionWatch() : outer_(watch) { watch = this; }
ConversionWatch::~ConversionWatch() { watch = outer_; }
ConversionWatch* ConversionWatch::current() { return watch; }

RefusalWatch::RefusalWatch() : outer_(refusals) { refusals = this; }
RefusalWatch::~RefusalWatch() { refusals = outer_; }
RefusalWatch* RefusalWatch::current() { return refusals; }

std::string RefusalWatch::takeReason(const char* otherwise) {
    if (!refusals || refusals->reason_.empty()) return otherwise;
    return std::exchange(refusals->reason_, {});
}

void warnConversion(const base::DataSourceBase& from, const base::DataSourceBase& to) {
    if (auto* const watching = ConversionWatch::current())
        return watching->note({from.getTypeName(), to.getTypeName()});
    log(Warning) << "conversion from " << from.getType() << " to " << to.getType() << endlog();
}

}  // namespace detail

}  // namespace RTT::types
