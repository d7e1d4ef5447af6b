// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "values.hpp"

#include "failure.hpp"
#include "fields.hpp"
#include "value_syntax.hpp"

#include <console/table.hpp>
#include <console/type_name.hpp>
#include <console/value_table.hpp>
#include <console/value_text.hpp>
#include <diag/nearest_match.hpp>
#include <rtt/Property.hpp>
#include <rtt/PropertyBag.hpp>
#include <rtt/encoding/Json.hpp>
#include <rtt/encoding/Plan.hpp>
#include <rtt/internal/DataSource.hpp>
#include <rtt/internal/DataSources.hpp>
#include <rtt/rt_string.hpp>
#include <rtt/types/Types.hpp>

#include <algorithm>
#include <map>
#include <mutex>
#include <utility>

namespace OCL::live {
namespace {

using nlohmann::json;
using RTT::PropertyBag;
using RTT::encoding::Json;
using RTT::encoding::Plan;
using RTT::internal::AssignableDataSource;
using RTT::internal::DataSource;
using RTT::types::TypeInfo;

constexpr unsigned kDeepestBag = 32;
constexpr std::size_t kBytesPerLetter = 4;  // no value has more bytes: a number of 8 has a digit and a comma

struct Form {
    std::shared_ptr<const Json> json;
    std::shared_ptr<const Plan> plan;  ///< for the size
    std::string why;                   ///< there is none
};

/** The letters or numbers of a text or vector, which own memory; 0 for other values. Real-time safe. */
std::size_t lengthOf(RTT::base::DataSourceBase& value) {
    if (const auto* const text = DataSource<std::string>::narrow(&value)) return text->rvalue().size();
    if (const auto* const all = DataSource<std::vector<double>>::narrow(&value)) return all->rvalue().size();
    const auto* const all = DataSource<std::vector<int>>::narrow(&value);
    return all ? all->rvalue().size() : 0;
}

/** Made once for each type. */
Form formOf(const TypeInfo& type) {
    static std::mutex mutex;
    static auto* const all = new std::map<const TypeInfo*, Form>();
    const std::lock_guard<std::mutex> lock(mutex);
    const auto known = all->find(&type);
    if (known != all->end()) return known->second;
    Form made;
    made.json = Json::make(type, made.why);
    std::string ignored;
    made.plan = Plan::make(type, RTT::encoding::cdrRules(), ignored);
    // A typekit that is loaded later may bring what is missing.
    if (made.json) all->emplace(&type, made);
    return made;
}

DataSource<PropertyBag>* bagIn(const Source& value) { return DataSource<PropertyBag>::narrow(value.get()); }

bool isText(const Source& value) {
    return DataSource<std::string>::narrow(value.get()) || DataSource<RTT::rt_string>::narrow(value.get());
}

bool isUnknown(const Source& value) { return value->getTypeInfo() == RTT::types::Types()->unknownType(); }

json bagJson(const PropertyBag& bag, std::size_t most, bool& wasCut) {
    json made = json::object();
    for (const auto* const property : bag) made[property->getName()] = jsonOf(property->getDataSource(), most, wasCut);
    return made;
}

void assignBag(const PropertyBag& bag, const json& from, const std::string& path) {
    if (!from.is_object())
        throw Failure(kWrongValue, path + ": found " + kindOf(from) + ", expected an object of its properties");
    for (const auto& [name, value] : from.items()) {
        const auto* const property = bag.find(name);
        if (!property)
            throw Failure(kWrongValue, path + ": there is no property '" + name + "'" +
                                           oroforge::diag::didYouMean(name, bag.list()));
        assign(property->getDataSource(), value, path + "." + name);
    }
}

bool isIndex(const std::string& part) { return part.find_first_not_of("0123456789") == std::string::npos; }

/** True if it is the index of an element. What has no size checks that itself. */
bool isBelow(const std::string& index, const Source& size) {
    const auto* const number = size ? DataSource<int>::narrow(size.get()) : nullptr;
    if (!number) return true;
    return index.size() < 10 && std::stol(index) < number->get();
}

Source memberOf(const Source& whole, const std::string& name, std::vector<std::string>& known) {
    whole->evaluate();
    if (const auto* const bag = bagIn(whole)) {
        known = bag->rvalue().list();
        const auto* const property = bag->rvalue().find(name);
        return property ? property->getDataSource() : nullptr;
    }
    known = whole->getMemberNames();
    if (isIndex(name) && !isBelow(name, whole->getMember("size"))) return nullptr;
    return whole->getMember(name);
}

/** Elements of an array of C++, which is part of a struct; -1 for anything else. */
int sizeOfArray(const Source& value) {
    if (*value->getTypeInfo()->getArrayElement() == '\0') return -1;
    const Source size = value->getMember("size");
    const auto* const number = size ? DataSource<int>::narrow(size.get()) : nullptr;
    return number ? number->get() : -1;
}

json arrayJson(const Source& value, int size, std::size_t most, bool& wasCut) {
    json made = json::array();
    for (int i = 0; i < size && !wasCut; ++i) made.push_back(jsonOf(value->getMember(std::to_string(i)), most, wasCut));
    return wasCut ? json() : made;
}

void assignArray(const Source& value, int size, const json& from, const std::string& path) {
    if (!from.is_array() || from.size() != static_cast<std::size_t>(size))
        throw Failure(kWrongValue, path + ": found " + kindOf(from) +
                                       (from.is_array() ? " of " + std::to_string(from.size()) : std::string()) +
                                       ", expected an array of " + std::to_string(size) + " (type " + typeOf(value) +
                                       ")");
    for (int i = 0; i < size; ++i) {
        const std::string index = std::to_string(i);
        assign(value->getMember(index), from[static_cast<std::size_t>(i)], path + "[" + index + "]");
    }
}

}  // namespace

Copied::Copied(const Source& original) : original_(original) {
    if (!original_ || isUnknown(original_)) return;
    if (const auto* const bag = bagIn(original_)) {
        PropertyBag copies(bag->rvalue().getType());
        addBag(bag->rvalue(), copies, 0);
        copy_ = new RTT::internal::ValueDataSource<PropertyBag>(copies);
        leaves_.clear();
        // A bag clones what it owns when it is copied, so the copies are those in the new one.
        addBag(bag->rvalue(), static_cast<RTT::internal::ValueDataSource<PropertyBag>&>(*copy_).set(), 0);
        return;
    }
    copy_ = original_->getTypeInfo()->buildValue();
    if (copy_) leaves_.push_back({original_, copy_, 0, 0});
}

void Copied::addBag(const PropertyBag& from, PropertyBag& to, unsigned depth) {
    if (depth > kDeepestBag) return;
    for (const auto* const property : from) {
        RTT::base::PropertyBase* mine = to.find(property->getName());
        if (!mine) {
            mine = property->create();
            if (!mine || !to.ownProperty(mine)) continue;
        }
        const auto* const inner = dynamic_cast<const RTT::Property<PropertyBag>*>(property);
        auto* const myInner = dynamic_cast<RTT::Property<PropertyBag>*>(mine);
        if (inner && myInner)
            addBag(inner->rvalue(), myInner->value(), depth + 1);
        else
            leaves_.push_back({property->getDataSource(), mine->getDataSource(), 0, 0});
    }
}

bool Copied::fill(Leaf& leaf) const {
    if (!leaf.original || !leaf.copy) return true;
    leaf.original->evaluate();
    leaf.wanted = lengthOf(*leaf.original);
    if (leaf.wanted > leaf.room && !allocates_) return false;
    leaf.done = leaf.copy->update(leaf.original.get());
    return true;
}

bool Copied::fill() {
    bool all = true;
    for (Leaf& leaf : leaves_) all = fill(leaf) && all;
    const bool cannot = all && !leaves_.empty() && leaves_[0].copy == copy_ && !leaves_[0].done;
    if (cannot) isCopied_ = false;
    return all;
}

void Copied::take(Leaf& leaf, std::size_t room) {
    if (room <= leaf.room) return;
    if (auto* const text = AssignableDataSource<std::string>::narrow(leaf.copy.get())) text->set().reserve(room);
    if (auto* const all = AssignableDataSource<std::vector<double>>::narrow(leaf.copy.get())) all->set().reserve(room);
    if (auto* const all = AssignableDataSource<std::vector<int>>::narrow(leaf.copy.get())) all->set().reserve(room);
    leaf.room = room;
}

void Copied::grow() {
    for (Leaf& leaf : leaves_) take(leaf, leaf.wanted);
}

void Copied::growFor(const Source& value) {
    if (!value || leaves_.empty() || leaves_[0].copy != copy_) return;
    value->evaluate();
    take(leaves_[0], lengthOf(*value));
}

std::string typeOf(const Source& value) { return value ? console::dotted(value->getTypeName()) : "unknown_t"; }

std::string textOf(const Source& value, std::size_t most) {
    return value ? cut(OCL::console::valueText(value, false), most) : "(unknown_t)";
}

json jsonOf(const Source& value, std::size_t most, bool& wasCut) {
    if (!value || isUnknown(value)) return nullptr;
    value->evaluate();
    if (const auto* const bag = bagIn(value)) return bagJson(bag->rvalue(), most, wasCut);
    const void* const address = value->getRawConstPointer();
    const Form form = formOf(*value->getTypeInfo());
    if (const int size = form.json ? -1 : sizeOfArray(value); size >= 0) return arrayJson(value, size, most, wasCut);
    if (!form.json || !address) return nullptr;
    // Text that would be too long need not be made.
    const bool isLarge = form.plan && form.plan->sizeOf(address) / kBytesPerLetter > most;
    const std::string text = isLarge ? "" : form.json->text(address);
    if (isLarge || text.size() > most) {
        wasCut = true;
        return nullptr;
    }
    return json::parse(text, nullptr, false);
}

Source partOf(const Source& whole, const std::vector<std::string>& parts, const std::string& path) {
    Source at = whole;
    std::string here = path;
    for (const std::string& part : parts) {
        std::vector<std::string> known;
        const Source member = memberOf(at, part, known);
        const bool index = isIndex(part);
        if (!member && !index && std::find(known.begin(), known.end(), part) != known.end())
            throw Failure(kNoForm, "field '" + part + "' of '" + here + "' is out of reach; the log says why");
        if (!member)
            throw Failure(kUnknownName, "'" + here + "', of type " + typeOf(at) + ", has no " +
                                            (index ? "element [" + part + "]"
                                                   : "field '" + part + "'" + oroforge::diag::didYouMean(part, known)));
        here += index ? "[" + part + "]" : "." + part;
        at = member;
    }
    return at;
}

void assign(const Source& value, const json& from, const std::string& path) {
    value->evaluate();
    if (const auto* const bag = bagIn(value)) return assignBag(bag->rvalue(), from, path);
    const Form form = formOf(*value->getTypeInfo());
    if (const int size = form.json ? -1 : sizeOfArray(value); size >= 0) return assignArray(value, size, from, path);
    void* const address = value->getRawPointer();
    if (!form.json || !address) {
        const bool text = from.is_string();
        if (text && value->getTypeInfo()->fromString(from.get<std::string>(), value)) return;
        throw Failure(text ? kWrongValue : kNoForm, path + ": values of type " + typeOf(value) + " have no JSON" +
                                                        (form.why.empty() ? "" : " (" + form.why + ")") +
                                                        (text ? ", and this text is none" : ""));
    }
    std::string written;
    try {
        written = from.dump();
    } catch (const json::exception&) {
        throw Failure(kWrongValue, path + ": a text is not UTF-8; an array of its bytes can be given instead");
    }
    const std::string problem = form.json->parse(written, address);
    if (!problem.empty()) throw Failure(kWrongValue, path + ": " + problem + " (type " + typeOf(value) + ")");
    value->updated();
}

void assign(const Source& value, const std::string& text, const std::string& path) {
    const std::size_t first = text.find_first_not_of(" \t");
    const bool bare = isText(value) && (first == std::string::npos || text[first] != '"');
    if (bare) return assign(value, json(text), path);
    json parsed;
    try {
        parsed = parseValue(text);
    } catch (const Failure& failure) {
        if (!formOf(*value->getTypeInfo()).json && value->getTypeInfo()->fromString(text, value)) return;
        throw Failure(failure.code(), path + ": " + failure.what());
    }
    if (!bagIn(value) && !formOf(*value->getTypeInfo()).json && sizeOfArray(value) < 0) parsed = text;
    assign(value, parsed, path);
}

std::string unitOf(std::string& doc) {
    std::string unit;
    doc = OCL::console::oneLine(doc);
    OCL::console::splitUnit(doc, unit);
    return unit;
}

}  // namespace OCL::live
