// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt_dynamic_reconfigure/detail/parameters.hpp>

#include <rtt/Logger.hpp>
#include <rtt/Property.hpp>
#include <rtt/internal/DataSource.hpp>
#include <rtt/types/Shape.hpp>
#include <rtt/types/TypeInfo.hpp>

#include <algorithm>
#include <climits>
#include <cmath>
#include <limits>
#include <memory>
#include <set>

namespace rtt_dynamic_reconfigure::detail {

using RTT::PropertyBag;
using RTT::base::DataSourceBase;
using RTT::base::PropertyBase;
using RTT::internal::AssignableDataSource;
typedef Parameter::Kind Kind;

namespace {

constexpr std::size_t kDeepest = 16;

template <class T>
AssignableDataSource<T>& as(const DataSourceBase::shared_ptr& source) {
    return static_cast<AssignableDataSource<T>&>(*source);
}

bool kindOf(const DataSourceBase::shared_ptr& source, Kind& kind) {
    if (AssignableDataSource<bool>::narrow(source.get()))
        kind = Kind::Bool;
    else if (AssignableDataSource<int>::narrow(source.get()))
        kind = Kind::Int;
    else if (AssignableDataSource<unsigned>::narrow(source.get()))
        kind = Kind::UInt;
    else if (AssignableDataSource<float>::narrow(source.get()))
        kind = Kind::Float;
    else if (AssignableDataSource<double>::narrow(source.get()))
        kind = Kind::Double;
    else if (AssignableDataSource<std::string>::narrow(source.get()))
        kind = Kind::String;
    else
        return false;
    return true;
}

/** Fills the table from a bag. */
class Collector {
public:
    explicit Collector(Parameters& to) : to_(to) { to_.groups.push_back({"Default", 0}); }

    void addBag(const PropertyBag& bag, std::size_t group) {
        for (const PropertyBase* property : bag.getProperties())
            if (property->ready()) add(property->getName(), property->getDescription(), property->getDataSource(), group);
    }

private:
    void add(const std::string& name, const std::string& description, const DataSourceBase::shared_ptr& source,
             std::size_t group) {
        if (!source || path_.size() == kDeepest) return;
        path_.push_back(name);
        addPart(description, source, group);
        path_.pop_back();
    }

    void addPart(const std::string& description, const DataSourceBase::shared_ptr& source, std::size_t group) {
        Kind kind;
        if (kindOf(source, kind)) return addValue({joined(), path_, description, kind, group, source});
        if (auto* const bag = RTT::internal::DataSource<PropertyBag>::narrow(source.get()))
            return within(group, [&](std::size_t own) { addBag(bag->rvalue(), own); });
        const RTT::types::Shape shape = source->getTypeInfo()->shape();
        if (shape.kind != RTT::types::Shape::Kind::Struct) return;
        within(group, [&](std::size_t own) {
            for (const auto& field : shape.fields)
                if (field.count == 0) add(field.name, description, source->getMember(field.name), own);
        });
    }

    template <class Content>
    void within(std::size_t parent, Content&& content) {
        const std::size_t own = to_.groups.size(), before = to_.all.size();
        to_.groups.push_back({joined(), parent});
        content(own);
        if (to_.all.size() == before) to_.groups.resize(own);
    }

    void addValue(Parameter parameter) {
        if (names_.insert(parameter.name).second)
            to_.all.push_back(std::move(parameter));
        else
            RTT::log(RTT::Warning) << "two properties have the name '" << parameter.name
                                   << "' for dynamic_reconfigure; the second is left out" << RTT::endlog();
    }

    std::string joined() const {
        std::string text;
        for (const std::string& part : path_) text += (text.empty() ? "" : "__") + part;
        return text;
    }

    Parameters& to_;
    std::vector<std::string> path_;
    std::set<std::string> names_;
};

template <class T>
PropertyBase* newProperty(const Parameter& like) {
    return new RTT::Property<T>(like.path.back(), like.description);
}

PropertyBase* newProperty(const Parameter& like) {
    switch (like.kind) {
        case Kind::Bool: return newProperty<bool>(like);
        case Kind::Int: return newProperty<int>(like);
        case Kind::UInt: return newProperty<unsigned>(like);
        case Kind::Float: return newProperty<float>(like);
        case Kind::Double: return newProperty<double>(like);
        case Kind::String: break;
    }
    return newProperty<std::string>(like);
}

void replace(PropertyBag& bag, PropertyBase* old, PropertyBase* made) {
    if (old) bag.removeProperty(old);
    bag.ownProperty(made);
}

PropertyBag* bagOf(const PropertyBase& property) {
    auto* const source = AssignableDataSource<PropertyBag>::narrow(property.getDataSource().get());
    return source ? &source->set() : nullptr;
}

void keepOnly(PropertyBag& bag, const std::string& prefix, const Parameters& wanted) {
    const PropertyBag::Properties all = bag.getProperties();
    for (PropertyBase* property : all) {
        const std::string name = prefix + property->getName();
        PropertyBag* const inner = bagOf(*property);
        if (inner) keepOnly(*inner, name + "__", wanted);
        if (inner ? inner->empty() : !wanted.find(name)) bag.removeProperty(property);
    }
}

template <class T, class List>
bool find(const List& list, const std::string& name, Value& value) {
    for (const auto& one : list)
        if (one.name == name) return value = static_cast<T>(one.value), true;
    return false;
}

template <class T, class List>
void push(List& list, const std::string& name, const T& value) {
    typename List::value_type one;
    one.name = name;
    one.value = value;
    list.push_back(one);
}

}  // namespace

const char* Parameter::type() const {
    switch (kind) {
        case Kind::Bool: return "bool";
        case Kind::Int:
        case Kind::UInt: return "int";
        case Kind::Float:
        case Kind::Double: return "double";
        case Kind::String: break;
    }
    return "str";
}

Value Parameter::value() const {
    (void)source->evaluate();
    switch (kind) {
        case Kind::Bool: return as<bool>(source).rvalue();
        case Kind::Int: return as<int>(source).rvalue();
        // dynamic_reconfigure has no larger numbers.
        case Kind::UInt: return static_cast<int>(std::min<unsigned>(as<unsigned>(source).rvalue(), INT_MAX));
        case Kind::Float: return static_cast<double>(as<float>(source).rvalue());
        case Kind::Double: return as<double>(source).rvalue();
        case Kind::String: break;
    }
    return as<std::string>(source).rvalue();
}

bool Parameter::takes(const Value& value) const {
    if (value.index() != lowest().index()) return false;
    const double* const number = std::get_if<double>(&value);
    if (number && kind == Kind::Float)
        return !(std::abs(*number) > static_cast<double>(std::numeric_limits<float>::max())) || std::isinf(*number);
    return kind != Kind::UInt || std::get<int>(value) >= 0;
}

void Parameter::set(const Value& value) const {
    switch (kind) {
        case Kind::Bool: as<bool>(source).set(std::get<bool>(value)); break;
        case Kind::Int: as<int>(source).set(std::get<int>(value)); break;
        case Kind::UInt: as<unsigned>(source).set(static_cast<unsigned>(std::get<int>(value))); break;
        case Kind::Float: as<float>(source).set(static_cast<float>(std::get<double>(value))); break;
        case Kind::Double: as<double>(source).set(std::get<double>(value)); break;
        case Kind::String: as<std::string>(source).set(std::get<std::string>(value)); break;
    }
}

Value Parameter::lowest() const {
    switch (kind) {
        case Kind::Bool: return false;
        case Kind::Int: return INT_MIN;
        case Kind::UInt: return 0;
        case Kind::Float: return static_cast<double>(std::numeric_limits<float>::lowest());
        case Kind::Double: return std::numeric_limits<double>::lowest();
        case Kind::String: break;
    }
    return std::string();
}

Value Parameter::highest() const {
    switch (kind) {
        case Kind::Bool: return true;
        case Kind::Int:
        case Kind::UInt: return INT_MAX;
        case Kind::Float: return static_cast<double>(std::numeric_limits<float>::max());
        case Kind::Double: return std::numeric_limits<double>::max();
        case Kind::String: break;
    }
    return std::string();
}

const Parameter* Parameters::find(const std::string& name) const {
    for (const Parameter& one : all)
        if (one.name == name) return &one;
    return nullptr;
}

void Parameters::append(dynamic_reconfigure::Config& config) const {
    for (const Parameter& one : all) detail::append(config, one.name, one.value());
}

void Parameters::appendGroups(dynamic_reconfigure::Config& config) const {
    for (std::size_t i = 0; i != groups.size(); ++i) {
        dynamic_reconfigure::GroupState state;
        state.name = groups[i].name;
        state.state = true;
        state.id = static_cast<int>(i);
        state.parent = static_cast<int>(groups[i].parent);
        config.groups.push_back(state);
    }
}

Parameters parametersOf(const PropertyBag& bag) {
    Parameters made;
    Collector(made).addBag(bag, 0);
    return made;
}

Parameter keepParameter(PropertyBag& bag, const Parameter& parameter, const Value& value) {
    PropertyBag* in = &bag;
    for (std::size_t i = 0; i + 1 != parameter.path.size(); ++i) {
        PropertyBase* const old = in->find(parameter.path[i]);
        PropertyBag* inner = old ? bagOf(*old) : nullptr;
        if (!inner) {
            auto* const made = new RTT::Property<PropertyBag>(parameter.path[i], "");
            replace(*in, old, made);
            inner = &made->set();
        }
        in = inner;
    }
    Parameter kept = parameter;
    PropertyBase* const old = in->find(parameter.path.back());
    Kind kind;
    if (old && kindOf(old->getDataSource(), kind) && kind == parameter.kind) {
        kept.source = old->getDataSource();
        return kept;
    }
    PropertyBase* const made = newProperty(parameter);
    kept.source = made->getDataSource();
    kept.set(value);
    replace(*in, old, made);
    return kept;
}

void keepOnly(PropertyBag& bag, const Parameters& wanted) { keepOnly(bag, "", wanted); }

void append(dynamic_reconfigure::Config& config, const std::string& name, const Value& value) {
    if (auto* const truth = std::get_if<bool>(&value))
        push(config.bools, name, *truth);
    else if (auto* const whole = std::get_if<int>(&value))
        push(config.ints, name, *whole);
    else if (auto* const number = std::get_if<double>(&value))
        push(config.doubles, name, *number);
    else
        push(config.strs, name, std::get<std::string>(value));
}

bool valueIn(const dynamic_reconfigure::Config& config, const std::string& name, const std::string& type, Value& value) {
    if (type == "bool") return find<bool>(config.bools, name, value);
    if (type == "int") return find<int>(config.ints, name, value);
    if (type == "str") return find<std::string>(config.strs, name, value);
    return find<double>(config.doubles, name, value) || find<double>(config.ints, name, value);
}

bool isEqual(const Value& one, const Value& other) {
    const double *const a = std::get_if<double>(&one), *const b = std::get_if<double>(&other);
    return a && b && std::isnan(*a) ? std::isnan(*b) : one == other;
}

}  // namespace rtt_dynamic_reconfigure::detail
