#include <rtt/RTT.hpp>
#include <functional>
#include <map>
#include <memory>
#include <tuple>
#include <vector>

/// Keeps the component, and adds to it when it is told to.
class Helper {
public:
    explicit Helper(RTT::TaskContext* owner) : owner_(owner) {}
    void install() { owner_->addPort("helper", out_); }

private:
    RTT::TaskContext* owner_;
    RTT::OutputPort<int> out_;
};

class Base : public RTT::TaskContext {
protected:
    explicit Base(const std::string& name) : RTT::TaskContext(name) {}
    bool configureHook() override {
        addPort("not_reached", base_);  // Later has a hook of its own
        return true;
    }
    bool startHook() override {
        addPort("base", base_);
        return true;
    }
    RTT::OutputPort<int> base_;
};

class Later : public Base {
public:
    explicit Later(const std::string& name) : Base(name), helper_(new Helper(this)) {
        provides("tool")->addProperty("count", count_);
        install_ = [this] { addPort("stored", stored_); };
        addOperation("extend", [this](int) { return addProperty("extended", count_).ready(); });
        apply([this](auto& port) { addPort("generic", port); });
        if (early_) addPort("never", never_);
        std::vector<std::string> names = {"a"};
        names.push_back(read());
        for (const auto& one : names) addPort(one, ports_[one]);
        bag_.value().ownProperty(new RTT::Property<double>("inner", "", 2));
        addProperty(bag_);
        loadService("marshalling");
        requires()->addServiceRequester(required());
        char key[] = "k0";
        key[1] = '1';
        addAttribute(key, count_);
        std::apply([this](auto&... port) { (addPort("each", port), ...); }, pair_);
        RTT::TaskContext& other = *find();
        other.addPort("elsewhere", never_);
    }

private:
    bool configureHook() override {
        helper_->install();
        provides("tool")->addProperty("size", count_);
        provides("tool")->addProperty("count", count_);  // as the constructor did
        install_();
        setPeriod(0.5);
        return true;
    }
    template <class Function>
    void apply(Function) {}
    static std::string read();
    static RTT::ServiceRequester::shared_ptr required();
    RTT::TaskContext* find();

    const bool early_ = false;
    std::unique_ptr<Helper> helper_;
    std::function<void()> install_;
    std::map<std::string, RTT::OutputPort<int>> ports_;
    RTT::OutputPort<int> stored_, never_;
    std::tuple<RTT::OutputPort<int>, RTT::InputPort<int>> pair_;
    RTT::Property<RTT::PropertyBag> bag_{"bag", "of others"};
    int count_ = 1;
};
