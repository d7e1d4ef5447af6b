// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Parameters of a generated configuration of dynamic_reconfigure (a .cfg file) as properties of a component.
#ifndef RTT_DYNAMIC_RECONFIGURE_SERVER_H
#define RTT_DYNAMIC_RECONFIGURE_SERVER_H

#include <rtt/Property.hpp>
#include <rtt/plugin/ServicePlugin.hpp>
#include <rtt_dynamic_reconfigure/config_bag.hpp>
#include <rtt_dynamic_reconfigure/server_base.hpp>

#include <cstdint>
#include <memory>
#include <string>

namespace rtt_dynamic_reconfigure {

/**
 * How a configuration becomes properties and back. As it is, by the names of the parameters, where `a__b` is property b
 * of bag a. Specialise it for properties of other names or types; setProperty() and getProperty() help.
 */
template <class ConfigType>
struct Updater {
    /** Sets the properties in `bag`, or adds them. False if that fails; then no property of the component changes. */
    static bool propertiesFromConfig(ConfigType& config, std::uint32_t level, RTT::PropertyBag& bag) {
        (void)level;
        dynamic_reconfigure::Config values;
        config.__toMessage__(values);
        return bagFromConfig(values, bag);
    }
    /** Sets the configuration from the component's properties. False if some are missing; the others are set. */
    static bool configFromProperties(ConfigType& config, const RTT::PropertyBag& bag) {
        dynamic_reconfigure::Config values;
        config.__toMessage__(values);
        const bool areAllThere = configFromBag(bag, values);
        return config.__fromMessage__(values) && areAllThere;
    }
};

/** Sets a property of type T in the bag, or adds it. False if it has another type. */
template <class T, class ValueType>
bool setProperty(const std::string& name, RTT::PropertyBag& bag, const ValueType& value) {
    if (RTT::base::PropertyBase* const found = bag.getProperty(name)) {
        auto* const property = dynamic_cast<RTT::Property<T>*>(found);
        if (property) property->set(static_cast<T>(value));
        return property != nullptr;
    }
    return bag.ownProperty(new RTT::Property<T>(name, "", static_cast<T>(value)));
}

/** Gets the value of a property of type T. False if there is none; then `value` stays. */
template <class T, class ValueType>
bool getProperty(const std::string& name, const RTT::PropertyBag& bag, ValueType& value) {
    const auto* const property = bag.getPropertyType<T>(name);
    if (property) value = static_cast<ValueType>(property->rvalue());
    return property != nullptr;
}

/** By the functions that are generated for a .cfg file. */
template <class ConfigType>
class GeneratedModel final : public ConfigModel {
    /** Of a specialisation, the functions may be static, or members that are not. */
    Updater<ConfigType> updater_;

public:
    void describe(const RTT::PropertyBag&, Limits& limits,
                  dynamic_reconfigure::ConfigDescription& description) override {
        description = ConfigType::__getDescriptionMessage__();
        readLimits(limits, description);
        describe(ConfigType::__getDefault__(), limits.defaults, description.dflt);
    }
    void readLimits(const Limits& limits, dynamic_reconfigure::ConfigDescription& description) override {
        describe(ConfigType::__getMin__(), limits.min, description.min);
        describe(ConfigType::__getMax__(), limits.max, description.max);
    }
    void read(const RTT::PropertyBag& properties, dynamic_reconfigure::Config& config) override {
        (void)updater_.configFromProperties(present_, properties);
        config = dynamic_reconfigure::Config();
        present_.__toMessage__(config);
    }
    bool fill(const dynamic_reconfigure::Config& config, std::uint32_t level, const RTT::PropertyBag&,
              RTT::PropertyBag& bag) override {
        next_ = present_;
        dynamic_reconfigure::Config values = config;
        (void)next_.__fromMessage__(values);
        return updater_.propertiesFromConfig(next_, level, bag);
    }
    /** Parameters without a property have their values here. */
    void accept() override { present_ = next_; }

private:
    void describe(const ConfigType& limit, RTT::PropertyBag& bag, dynamic_reconfigure::Config& message) {
        ConfigType config = limit;
        if (bag.empty())
            (void)updater_.propertiesFromConfig(config, ~std::uint32_t(0), bag);
        else
            (void)updater_.configFromProperties(config, bag);
        message = dynamic_reconfigure::Config();
        config.__toMessage__(message, ConfigType::__getParamDescriptions__(), ConfigType::__getGroupDescriptions__());
    }

    ConfigType present_ = ConfigType::__getDefault__(), next_ = present_;
};

/** The service for a configuration. Its parameters are limited to the properties `min` and `max` of the service, which
    at first are the limits in the .cfg file. See ServerBase. */
template <class ConfigType>
class Server : public ServerBase {
public:
    explicit Server(RTT::TaskContext* owner) : Server("reconfigure", owner) {}
    Server(const std::string& name, RTT::TaskContext* owner)
        : ServerBase(name, owner, std::make_unique<GeneratedModel<ConfigType>>()) {}
};

}  // namespace rtt_dynamic_reconfigure

/** Makes a library a plugin with the service `NAME` for a configuration; once, in one source file. */
#define RTT_DYNAMIC_RECONFIGURE_SERVICE_PLUGIN(CONFIG, NAME)                            \
    namespace {                                                                         \
    struct RttReconfigureServer : rtt_dynamic_reconfigure::Server<CONFIG> {             \
        explicit RttReconfigureServer(RTT::TaskContext* owner)                          \
            : rtt_dynamic_reconfigure::Server<CONFIG>(NAME, owner) {}                   \
    };                                                                                  \
    }                                                                                   \
    ORO_SERVICE_NAMED_PLUGIN(RttReconfigureServer, NAME)

#endif
