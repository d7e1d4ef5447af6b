// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The service `rosparam`: parameters of ROS as properties of a component.
#include "detail/names.hpp"
#include "detail/service_parameters.hpp"

#include <rtt/Logger.hpp>
#include <rtt/plugin/ServicePlugin.hpp>
#include <rtt_ros/guarded.hpp>
#include <rtt_rosparam/parameter_types.hpp>
#include <rtt_rosparam/ros_param_data_source.hpp>

#include <memory>

namespace rtt_rosparam {

namespace {

typedef const std::string& Name;

struct Policy {
    const char* name;      // the end of names of operations
    unsigned number;
    const char* constant;
    const char* place;     // for descriptions
};

constexpr Policy policies[] = {
    {"Relative", RELATIVE, "RELATIVE", "in the namespace of the node"},
    {"Absolute", ABSOLUTE, "ABSOLUTE", "at the root"},
    {"Private", PRIVATE, "PRIVATE", "below the node"},
    {"ComponentPrivate", COMPONENT_PRIVATE, "COMPONENT_PRIVATE", "in the component's namespace below the node"},
    {"ComponentRelative", COMPONENT_RELATIVE, "COMPONENT_RELATIVE", "in the component's relative namespace"},
    {"ComponentAbsolute", COMPONENT_ABSOLUTE, "COMPONENT_ABSOLUTE", "in the component's namespace at the root"},
};

constexpr const char* itemText = "a property, or a service with properties";
constexpr const char* rosText = "a name of ROS";

}  // namespace

class ROSParamService : public RTT::Service {
public:
    explicit ROSParamService(RTT::TaskContext* owner) : RTT::Service("rosparam", owner) {
        doc("Parameters of ROS as properties of this component. All operations wait for the ROS master.");
        for (const Policy& policy : policies) {
            addConstant(policy.constant, static_cast<int>(policy.number));
            addGeneral(policy.name, policy);
        }
        addConstant("COMPONENT", static_cast<int>(COMPONENT));
        addAll("", policies[COMPONENT_PRIVATE]);
        addOperation("get", &ROSParamService::getByPolicy, this)
            .doc("Sets one property, or those of one service, from its parameter. False if there is none that fits.")
            .arg("name", itemText)
            .arg("policy", "where the parameter is: RELATIVE, ABSOLUTE, …");
        addOperation("set", &ROSParamService::setByPolicy, this)
            .doc("Sets the parameter of one property, or those of one service.")
            .arg("name", itemText)
            .arg("policy", "where the parameter is: RELATIVE, ABSOLUTE, …");
        addOperation("getParam", &ROSParamService::getParam, this)
            .doc("Sets one property, or those of one service, from any parameter.")
            .arg("ros_name", rosText)
            .arg("rtt_name", itemText);
        addOperation("setParam", &ROSParamService::setParam, this)
            .doc("Sets any parameter from one property, or from those of one service.")
            .arg("ros_name", rosText)
            .arg("rtt_name", itemText);
        addOperation("getParams", &ROSParamService::getParams, this)
            .doc("Sets all properties, with those of services, from parameters of a namespace.")
            .arg("ros_namespace", rosText);
#define RTT_ROSPARAM_ADD(Type, T) addTyped<T>(#Type);
        RTT_ROSPARAM_TYPES(RTT_ROSPARAM_ADD)
#undef RTT_ROSPARAM_ADD
    }

private:
    std::string component() const { return getOwner() ? getOwner()->getName() : std::string(); }

    /** The name of ROS; false, with an error in the log, if there is no such policy. */
    bool makeName(unsigned policy, Name item, std::string& name) const {
        const std::string problem = rtt_ros::problemIn([&] { name = nameOf(component(), policy, item); });
        if (!problem.empty()) RTT::log(RTT::Error) << "rosparam: " << problem << RTT::endlog();
        return problem.empty();
    }
    /** Calls a function for a name of ROS and the component's interface. */
    template <class... Arguments>
    bool withOwner(bool (ServiceParameters::*function)(const std::string&, Arguments...), const std::string& name,
                   const std::decay_t<Arguments>&... arguments) {
        RTT::TaskContext* const owner = getOwner();
        if (!owner) return false;
        ServiceParameters parameters(*owner->provides());
        return (parameters.*function)(name, arguments...);
    }
    bool getByPolicy(Name item, unsigned policy) {
        std::string name;
        return makeName(policy, item, name) && withOwner(&ServiceParameters::getItem, name, item);
    }
    bool setByPolicy(Name item, unsigned policy) {
        std::string name;
        return makeName(policy, item, name) && withOwner(&ServiceParameters::setItem, name, item);
    }
    bool getParam(Name ros, Name item) { return withOwner(&ServiceParameters::getItem, ros, item); }
    bool setParam(Name ros, Name item) { return withOwner(&ServiceParameters::setItem, ros, item); }
    bool getParams(Name ros) { return withOwner(&ServiceParameters::getAll, ros); }

    void addAll(const std::string& end, const Policy& policy) {
        const unsigned number = policy.number;
        const std::string place = policy.place;
        addOperation("getAll" + end, [this, number] {
            return withOwner(&ServiceParameters::getAll, nameOf(component(), number, ""));
        }).doc("Sets all properties, with those of services, from the parameters " + place + ". False if there are " +
               "none, or one does not fit.");
        addOperation("setAll" + end, [this, number] {
            return withOwner(&ServiceParameters::setAll, nameOf(component(), number, ""));
        }).doc("Sets the parameters " + place + " from all properties, with those of services. Others stay.");
    }
    void addGeneral(const std::string& end, const Policy& policy) {
        addAll(end, policy);
        const unsigned number = policy.number;
        const std::string place = policy.place;
        addOperation("get" + end, [this, number](Name item) { return getByPolicy(item, number); })
            .doc("Sets one property, or those of one service, from its parameter " + place + ".")
            .arg("name", itemText);
        addOperation("set" + end, [this, number](Name item) { return setByPolicy(item, number); })
            .doc("Sets the parameter " + place + " of one property, or those of one service.")
            .arg("name", itemText);
    }

    template <class T>
    void addTyped(const std::string& type) {
        addTypedFor<T>(type, policies[RELATIVE]);
        for (const Policy& policy : policies) addTypedFor<T>(type + policy.name, policy);
    }
    template <class T>
    void addTypedFor(const std::string& end, const Policy& policy) {
        const unsigned number = policy.number;
        const std::string place = policy.place;
        addOperation("get" + end, [this, number](Name item, T& value) {
            T copy(value);
            if (!readParameter(nameOf(component(), number, item), typeid(T), &copy)) return false;
            value = std::move(copy);
            return true;
        })
            .doc("Reads a parameter " + place + ". False if it is not there or does not fit; the value stays.")
            .arg("name", "the last part of the parameter's name")
            .arg("value", "receives the value");
        addOperation("set" + end, [this, number](Name item, const T& value) {
            (void)writeParameter(nameOf(component(), number, item), typeid(T), &value);
        })
            .doc("Sets a parameter " + place + ".")
            .arg("name", "the last part of the parameter's name")
            .arg("value", "its new value");
        addOperation("addRosParamProperty" + end, [this, number](Name item) -> RTT::Property<T>& {
            return bound<T>(item, nameOf(component(), number, item));
        })
            .doc("Adds a property to the component that reads and sets a parameter " + place + " at each access.")
            .arg("name", "the name of the property");
    }

    template <class T>
    RTT::Property<T>& bound(const std::string& name, const std::string& full) {
        const typename RosParamDataSource<T>::shared_ptr source(new RosParamDataSource<T>(full));
        RTT::base::PropertyBase* const known = getOwner() ? getOwner()->properties()->find(name) : nullptr;
        auto* const same = dynamic_cast<RTT::Property<T>*>(known);
        if (same && same->setDataSource(source)) return *same;
        auto made = std::make_unique<RTT::Property<T>>(name, "The parameter " + full + " of ROS.", source);
        if (!known && getOwner() && getOwner()->properties()->ownProperty(made.get())) return *made.release();
        logNotAdded(*made, known);
        for (const auto& other : others_) {
            auto* const mine = other->getName() == name ? dynamic_cast<RTT::Property<T>*>(other.get()) : nullptr;
            if (mine && mine->setDataSource(source)) return *mine;
        }
        others_.push_back(std::move(made));
        return static_cast<RTT::Property<T>&>(*others_.back());
    }
    void logNotAdded(const RTT::base::PropertyBase& made, const RTT::base::PropertyBase* known) const {
        RTT::log(RTT::Error) << "rosparam: the property '" << made.getName() << "' of type " << made.getType()
                             << " is not added: "
                             << (!getOwner() ? "this service belongs to no component; load it in one"
                                 : known     ? "the component has one of type " + known->getType() +
                                           " already; take another name"
                                             : "the component does not take this name; take another one")
                             << RTT::endlog();
    }

    // Those that were not added, because callers have references to them: one for each name and type.
    std::vector<std::unique_ptr<RTT::base::PropertyBase>> others_;
};

}  // namespace rtt_rosparam

ORO_SERVICE_NAMED_PLUGIN(rtt_rosparam::ROSParamService, "rosparam")
