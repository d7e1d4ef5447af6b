// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt_dynamic_reconfigure/auto_config.h>

#include <rtt_dynamic_reconfigure/detail/parameters.hpp>

#include <algorithm>
#include <memory>

namespace rtt_dynamic_reconfigure {

using detail::Parameter;
using detail::Parameters;
using detail::Value;
using dynamic_reconfigure::Config;
using RTT::PropertyBag;
using RTT::base::PropertyBase;

namespace {

/** A copy that shares nothing with the property, as the copy of a bag would. */
PropertyBase* copyOf(const PropertyBase& property) {
    const auto source = property.getDataSource();
    auto* const bag = RTT::internal::DataSource<PropertyBag>::narrow(source.get());
    if (!bag) return property.clone();
    auto made = std::make_unique<RTT::Property<PropertyBag>>(property.getName(), property.getDescription());
    for (const PropertyBase* inner : bag->rvalue().getProperties())
        if (inner->ready()) made->set().ownProperty(copyOf(*inner));
    return made.release();
}

class AutoModel final : public ConfigModel {
public:
    void describe(const PropertyBag& properties, Limits& limits,
                  dynamic_reconfigure::ConfigDescription& description) override {
        const Parameters all = detail::parametersOf(properties);
        description = dynamic_reconfigure::ConfigDescription();
        for (std::size_t i = 0; i != all.groups.size(); ++i) {
            dynamic_reconfigure::Group group;
            group.name = all.groups[i].name;
            group.id = static_cast<int>(i);
            group.parent = static_cast<int>(all.groups[i].parent);
            description.groups.push_back(group);
        }
        for (std::size_t i = 0; i != all.all.size(); ++i) {
            const Parameter& one = all.all[i];
            dynamic_reconfigure::ParamDescription text;
            text.name = one.name;
            text.type = one.type();
            text.level = std::uint32_t(1) << std::min<std::size_t>(i, 31);
            text.description = one.description;
            description.groups[one.group].parameters.push_back(text);
            (void)keepParameter(limits.min, one, one.lowest());
            (void)keepParameter(limits.max, one, one.highest());
            keepParameter(limits.defaults, one, one.value()).set(one.value());
        }
        for (PropertyBag* bag : {&limits.min, &limits.max, &limits.defaults}) detail::keepOnly(*bag, all);
        readLimits(limits, description);
        all.append(description.dflt);
        all.appendGroups(description.dflt);
    }

    void readLimits(const Limits& limits, dynamic_reconfigure::ConfigDescription& description) override {
        read(limits.min, description.min);
        read(limits.max, description.max);
    }

    void read(const PropertyBag& properties, Config& config) override {
        const Parameters all = detail::parametersOf(properties);
        config = Config();
        all.append(config);
        all.appendGroups(config);
    }

    bool fill(const Config& config, std::uint32_t, const PropertyBag& properties, PropertyBag& bag) override {
        const Parameters present = detail::parametersOf(properties);
        for (const PropertyBase* property : properties.getProperties()) {
            const auto isWithin = [&](const Parameter& one) { return one.path.front() == property->getName(); };
            if (std::any_of(present.all.begin(), present.all.end(), isWithin)) bag.ownProperty(copyOf(*property));
        }
        for (const Parameter& one : detail::parametersOf(bag).all) {
            Value value;
            // What did not change keeps its digits, and numbers that are too large for an int.
            if (!detail::valueIn(config, one.name, one.type(), value) || detail::isEqual(value, one.value())) continue;
            if (!one.takes(value)) return false;
            one.set(value);
        }
        return true;
    }
};

}  // namespace

std::unique_ptr<ConfigModel> AutoConfig::makeModel() { return std::make_unique<AutoModel>(); }

}  // namespace rtt_dynamic_reconfigure
