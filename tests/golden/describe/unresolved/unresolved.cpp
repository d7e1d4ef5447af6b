#include <rtt/RTT.hpp>

#include <cstdlib>
#include <memory>

double measured();
void decorate(RTT::TaskContext& component);

class Unresolved : public RTT::TaskContext {
public:
    explicit Unresolved(const std::string& name) : TaskContext(name), speed_(measured()) {
        addPort(name + "_in", in_);
        if (std::getenv("DEBUG") != nullptr) addPort("debug", debug_);
        for (int i = 0; i < count(); ++i) addPort("out" + std::to_string(i), *outs_[i]);
        addProperty("speed", speed_);
        addProperty("text", text_).doc(std::getenv("DOC"));
        addOperation("go", &Unresolved::go, this, thread()).doc("goes");
        provides(name)->addAttribute("text", text_);
        setActivity(new RTT::Activity(0, measured()));
        decorate(*this);
        if (speed_ > 1) return;
        addPort("after", after_);
    }

private:
    bool configureHook() override {
        addPort("late", late_);
        return true;
    }
    static int count();
    static RTT::ExecutionThread thread();
    void go() {}

    RTT::InputPort<int> in_, debug_, late_, after_;
    std::vector<std::unique_ptr<RTT::OutputPort<int>>> outs_;
    double speed_;
    std::string text_;
};
