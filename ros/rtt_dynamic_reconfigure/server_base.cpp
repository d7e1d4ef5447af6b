// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt_dynamic_reconfigure/server_base.hpp>

#include <rtt/Attribute.hpp>
#include <rtt/Logger.hpp>
#include <rtt/Property.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt_dynamic_reconfigure/detail/merge.hpp>
#include <rtt_dynamic_reconfigure/detail/owner_call.hpp>
#include <rtt_dynamic_reconfigure/detail/owner_thread.hpp>
#include <rtt_dynamic_reconfigure/detail/server_topics.hpp>

#include <exception>
#include <functional>
#include <atomic>
#include <mutex>
#include <thread>
#include <utility>

namespace rtt_dynamic_reconfigure {

using detail::ServerTopics;
using dynamic_reconfigure::Config;
using dynamic_reconfigure::ConfigDescription;

typedef RTT::internal::AssignableDataSource<RTT::PropertyBag> Bag;

ConfigModel::~ConfigModel() = default;

struct ServerBase::Parts {
    Parts(RTT::TaskContext* owner, RTT::PropertyBag& service)
        : min(add(service, "min", "The lowest values. Call refresh() after a change.")),
          max(add(service, "max", "The highest values. Call refresh() after a change.")),
          defaults(add(service, "default", "The values that clients show as defaults.")),
          limits{min->set(), max->set(), defaults->set()},
          thread(owner) {}

    const Bag::shared_ptr min, max, defaults;  // of properties of the service
    Limits limits;
    ConfigDescription description;
    unsigned number = 0;  // of the last look at the properties; all of these are of the component's thread
    detail::OwnerThread thread;
    std::atomic<std::thread::id> setting{std::thread::id()};  // executes a request
    std::mutex mutex;                                         // guards the pointer
    std::shared_ptr<ServerTopics> topics;

    static Bag::shared_ptr add(RTT::PropertyBag& service, const char* name, const char* description) {
        auto* const made = new RTT::Property<RTT::PropertyBag>(name, description);
        service.ownProperty(made);
        return made->getAssignableDataSource();
    }

    std::shared_ptr<ServerTopics> present() {
        const std::lock_guard<std::mutex> lock(mutex);
        return topics;
    }
    std::shared_ptr<ServerTopics> exchange(std::shared_ptr<ServerTopics> next) {
        const std::lock_guard<std::mutex> lock(mutex);
        return std::exchange(topics, std::move(next));
    }

    /** Executes `work(component, properties)` in the component's thread; false if that is impossible or it throws. */
    bool within(const std::atomic<bool>& isClosed, std::string& why,
                const std::function<bool(RTT::TaskContext&, const RTT::PropertyBag&)>& work) {
        bool isDone = false;
        std::string problem;
        const bool wasExecuted = thread.execute(
            [&](RTT::TaskContext& owner) {
                try {
                    ++number;
                    isDone = work(owner, *owner.properties());
                } catch (const std::exception& error) {
                    problem = error.what();
                }
            },
            isClosed, why);
        if (!problem.empty()) why = problem;
        return wasExecuted && isDone;
    }
};

namespace {

/** This thread executes a request meanwhile. */
class Setting {
public:
    explicit Setting(std::atomic<std::thread::id>& thread) : thread_(thread) { thread_ = std::this_thread::get_id(); }
    ~Setting() { thread_ = std::thread::id(); }
    Setting(const Setting&) = delete;
    Setting& operator=(const Setting&) = delete;

private:
    std::atomic<std::thread::id>& thread_;
};

}  // namespace

ServerBase::ServerBase(const std::string& name, RTT::TaskContext* owner, std::unique_ptr<ConfigModel> model)
    : RTT::Service(name, owner), model_(std::move(model)), parts_(std::make_unique<Parts>(owner, *properties())) {
    doc("Lets clients of dynamic_reconfigure change the properties of the component.");
    RTT::Attribute<RTT::PropertyBag> dflt("dflt", parts_->defaults);
    addAttribute(dflt);
    addOperation("advertise", &ServerBase::advertise, this)
        .doc("Offers the properties to clients; false if that fails.")
        .arg("ns", "namespace; empty for ~COMPONENT");
    addOperation("shutdown", &ServerBase::shutdown, this).doc("Offers them no longer.");
    addOperation("updated", &ServerBase::updated, this)
        .doc("Tells clients the present values; false if they are not advertised.");
    addOperation("refresh", &ServerBase::refresh, this)
        .doc("Looks for properties that were added or removed, and tells clients, with the limits. False if that fails.");
    if (owner) (void)refresh();
}

ServerBase::~ServerBase() { shutdown(); }

bool ServerBase::isFine(bool succeeded, const char* what, const std::string& why) const {
    if (!succeeded)
        RTT::log(RTT::Error) << "the properties of component '" << parts_->thread.name()
                             << "' were not " << what << ": " << why << RTT::endlog();
    return succeeded;
}

bool ServerBase::advertise(const std::string& ns) {
    std::string why, where = ns;
    const std::string& owner = parts_->thread.name();
    if (where.empty()) where = owner == "Deployer" ? "~" : "~" + owner;
    if (parts_->setting == std::this_thread::get_id())
        return isFine(false, "advertised", "a request of a client is being executed");
    shutdown();
    std::shared_ptr<ServerTopics> opened = ServerTopics::open(
        where, [this](const Config& request, Config& response) { return set(request, response); }, why);
    if (!isFine(opened != nullptr, "advertised", why)) return false;
    opened->start();
    // Another thread may have been faster.
    if (const auto previous = parts_->exchange(opened)) previous->close();
    return refresh();
}

void ServerBase::shutdown() {
    if (parts_->setting == std::this_thread::get_id()) {
        (void)isFine(false, "shut down", "a request of a client is being executed");
        return;
    }
    if (const std::shared_ptr<ServerTopics> topics = parts_->exchange(nullptr)) topics->close();
}

bool ServerBase::updated() {
    const std::shared_ptr<ServerTopics> topics = parts_->present();
    if (!topics) return false;
    std::string why;
    Config config;
    unsigned number = 0;
    const bool isRead =
        parts_->within(topics->isClosed(), why, [&](RTT::TaskContext&, const RTT::PropertyBag& properties) {
            model_->read(properties, config);
            number = parts_->number;
            return true;
        });
    if (isRead) topics->publishUpdate(config, number);
    return isFine(isRead, "published", why);
}

bool ServerBase::refresh() {
    static const std::atomic<bool> never{false};
    const std::shared_ptr<ServerTopics> topics = parts_->present();
    std::string why;
    Config config;
    ConfigDescription description;
    unsigned number = 0;
    const bool isRead = parts_->within(
        topics ? topics->isClosed() : never, why, [&](RTT::TaskContext&, const RTT::PropertyBag& properties) {
            model_->describe(properties, parts_->limits, parts_->description);
            description = parts_->description;
            model_->read(properties, config);
            number = parts_->number;
            return true;
        });
    if (isRead && topics) {
        topics->publishDescription(description, number);
        topics->publishUpdate(config, number);
    }
    return isFine(isRead, "described", why);
}

// In a thread of roscpp.
bool ServerBase::set(const Config& request, Config& response) {
    const std::shared_ptr<ServerTopics> topics = parts_->present();
    if (!topics) return false;
    std::string why;
    unsigned number = 0;
    const bool isSet = parts_->within(topics->isClosed(), why, [&](RTT::TaskContext& owner, const RTT::PropertyBag& properties) {
        const Setting within(parts_->setting);
        ConfigDescription& description = parts_->description;
        Config present, merged;
        std::uint32_t level = 0;
        RTT::PropertyBag bag;
        number = parts_->number;
        model_->readLimits(parts_->limits, description);
        model_->read(properties, present);
        response = present;
        if (!detail::merge(description, present, request, merged, level, why)) return false;
        if (!model_->fill(merged, level, properties, bag)) {
            why = "the values do not fit the properties";
            return false;
        }
        if (!detail::setProperties(owner, bag, level, why)) return false;
        model_->accept();
        detail::tellChanged(owner, level);
        model_->read(properties, response);
        return true;
    });
    // A client that was refused shows the old values again.
    if (number != 0) topics->publishUpdate(response, number);
    return isFine(isSet, "changed", why);
}

}  // namespace rtt_dynamic_reconfigure
